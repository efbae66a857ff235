// The fields on the card have the layout of the processor's, so that they are copied as they are. Kernels are told the
// numbers of the scene at every pass: that costs little beside a pass over all particles.
#include "gpu/card_sheet.h"

#include <fmt/core.h>

#include <bit>

namespace tyg {
namespace {

constexpr unsigned kKinds = 2, kPushes = 9, kPinForces = 10, kGusts = 11, kSolids = 12;  // bindings
constexpr unsigned kXyz = 3, kExtremes = 4;                                              // of kernels/gather.glsl
constexpr int kGroupColumns = 32, kGroupRows = 4;  // particles of a work group, as kernels/fields.glsl has them
constexpr std::uint32_t kPin = 128;                // of a kind
constexpr unsigned kMovingShift = 8;

std::array<float, 3> lawOf(const SpringLaw<float>& law) { return {law.ks, law.ksTimesRest, law.kd}; }
std::array<float, 3> arrayOf(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

void writeFloats(CardBuffer& buffer, const std::vector<float>& numbers) {
  if (!numbers.empty()) buffer.write(numbers.data(), numbers.size() * sizeof(float));
}

}  // namespace

CardSheet::CardSheet(Card& card, const Layout& layout)
    : card_(card), layout_(layout), kinds_(card), pushes_(card), pinForces_(card), gusts_(card), solids_(card) {
  // A kernel may look at a block of memory that it does not use: none of them may be missing.
  for (CardBuffer* buffer : {&pushes_, &pinForces_, &gusts_, &solids_}) buffer->reserve(sizeof(std::uint32_t));
}

CardBuffer& CardSheet::field(Field field) {
  std::unique_ptr<CardBuffer>& buffer = fields_.at(std::size_t(field));
  if (!buffer) {
    buffer = std::make_unique<CardBuffer>(card_);
    const VectorField<float> zeros(layout_);  // the padding stays so
    buffer->write(zeros.x(), zeros.bytes());
    card_.refuseErrors();
  }
  return *buffer;
}

void CardSheet::write(Field to, const VectorField<float>& from) { field(to).write(from.x(), from.bytes()); }

void CardSheet::read(Field from, VectorField<float>& to) const {
  fields_.at(std::size_t(from))->read(to.x(), to.bytes());
}

void CardSheet::useSheet(const Sheet& sheet, const KernelTerms& terms) {
  sheet_ = sheet, terms_ = terms;
  writeKinds();
}

void CardSheet::writeKinds() {
  std::vector<std::uint32_t> kinds(std::size_t(layout_.plane));
  const auto kindOf = [&](int particle) -> std::uint32_t& { return kinds[std::size_t(layout_.at(particle))]; };
  if (terms_.cut) {
    for (int particle = 0; particle < sheet_.count(); ++particle) {
      for (unsigned bit = 1; bit <= Missing::Cell; bit *= 2) {
        if (sheet_.missing.has(particle, Missing::Bit(bit))) kindOf(particle) |= bit;
      }
    }
  }
  for (const int pin : sheet_.pins) kindOf(pin) |= kPin;
  for (std::size_t k = 0; k < movingPins_.size(); ++k) kindOf(movingPins_[k]) |= std::uint32_t(k + 1) << kMovingShift;
  kinds_.write(kinds.data(), kinds.size() * sizeof(kinds[0]));
}

void CardSheet::writePushes() {
  std::vector<std::uint32_t> numbers;
  for (const PushedParticle<float>& push : acting_.pushes) {
    numbers.push_back(std::uint32_t(push.row * layout_.stride + push.column));
    for (const float number : push.force) numbers.push_back(std::bit_cast<std::uint32_t>(number));
  }
  if (!numbers.empty()) pushes_.write(numbers.data(), numbers.size() * sizeof(numbers[0]));
}

void CardSheet::act(const CardActing& acting) {
  acting_ = acting;
  evaluation_ = 0;
  if (!std::ranges::equal(movingPins_, acting.movingPins)) {
    movingPins_.assign(acting.movingPins.begin(), acting.movingPins.end());
    writeKinds();
  }
  writePushes();
  writeFloats(gusts_, acting.gusts);
  writeFloats(solids_, acting.solids);
  pinForces_.reserve(3 * sizeof(float) * movingPins_.size() * acting.moments.size());
  kinds_.show(kKinds), pushes_.show(kPushes), pinForces_.show(kPinForces);
  gusts_.show(kGusts), solids_.show(kSolids);
}

std::string CardSheet::definesOf(CardUpdate update) const {
  return fmt::format(
      "#define UPDATE {}\n#define STRUCTURAL {:d}\n#define SHEAR {:d}\n#define BEND {:d}\n#define DAMPING {}\n"
      "#define AIR {:d}\n#define CONTACT {:d}\n#define CUT {:d}\n",
      int(update), terms_.structural, terms_.shear, terms_.bend, terms_.damping, terms_.air, terms_.contact,
      terms_.cut);
}

void CardSheet::setScene(Kernel& kernel) const {
  const AllTerms::Numbers<float>& numbers = acting_.numbers;
  kernel.set("structural", lawOf(static_cast<const StructuralSprings::Numbers<float>&>(numbers).law));
  kernel.set("shear", lawOf(static_cast<const ShearSprings::Numbers<float>&>(numbers).law));
  kernel.set("bend", lawOf(static_cast<const BendSprings::Numbers<float>&>(numbers).law));
  kernel.set("weight", arrayOf(numbers.weight));
  kernel.set("drag", numbers.drag);
  kernel.set("pushCount", int(acting_.pushes.size()));
  const AirTerm::Numbers<float>& air = numbers;
  kernel.set("airFactor", air.factor), kernel.set("tinyArea", air.tinyArea);
  const ContactTerm::Numbers<float>& contact = numbers;
  kernel.set("contactForce", contact.force), kernel.set("perLayer", contact.perLayer);
  kernel.set("contactDamping", contact.damping), kernel.set("friction", contact.friction);
  kernel.set("slip", contact.slip);
}

void CardSheet::setMoment(Kernel& kernel) const {
  const CardActing::Moment& moment = acting_.moments.at(evaluation_);
  kernel.set("steadyWind", moment.steadyWind);
  kernel.set("firstGust", moment.firstGust), kernel.set("endGust", moment.endGust);
  kernel.set("firstSolid", moment.firstSolid), kernel.set("endSolid", moment.endSolid);
  kernel.set("pinBase", int(evaluation_ * movingPins_.size()));
}

void CardSheet::pass(CardUpdate update, std::initializer_list<InPass> roles, float step, float kick) {
  Kernel& kernel = card_.kernel("step.glsl", definesOf(update));
  kernel.use();
  setScene(kernel);
  setMoment(kernel);
  ++evaluation_;
  run(kernel, roles, step, kick);
  if (acting_.watch) showTo(roles);
}

/// What a pass evaluates at is still there when it is over.
void CardSheet::showTo(std::initializer_list<InPass> roles) {
  if (watchedPosition_.bytes() == 0) watchedPosition_ = watchedVelocity_ = VectorField<float>(layout_);
  for (const auto& [role, which] : roles) {
    if (role == PassRole::Position) read(which, watchedPosition_);
    if (role == PassRole::Velocity) read(which, watchedVelocity_);
  }
  acting_.watch(watchedPosition_, watchedVelocity_);
}

void CardSheet::beginLeapfrog(std::initializer_list<InPass> roles, float step, float kick) {
  Kernel& kernel = card_.kernel("leapfrog_begin.glsl", "#define CUT 0\n");
  kernel.use();
  run(kernel, roles, step, kick);
}

void CardSheet::gather(const CardBuffer& xyz, const CardBuffer& extremes) {
  Kernel& kernel = card_.kernel("gather.glsl", "#define CUT 0\n");
  kernel.use();
  xyz.show(kXyz), extremes.show(kExtremes), kinds_.show(kKinds);
  run(kernel, {{PassRole::Position, Field::X}, {PassRole::Velocity, Field::V}}, 0, 0);
}

void CardSheet::run(Kernel& kernel, std::initializer_list<InPass> roles, float step, float kick) {
  kernel.set("columns", layout_.columns), kernel.set("rows", layout_.rows);
  kernel.set("stride", int(layout_.stride)), kernel.set("plane", int(layout_.plane));
  kernel.set("stepLength", step), kernel.set("kick", kick);
  for (const auto& [role, which] : roles) field(which).show(unsigned(role));
  const auto groups = [](int particles, int size) { return static_cast<GLuint>((particles + size - 1) / size); };
  const Gl& gl = card_.gl();
  gl.DispatchCompute(groups(layout_.columns, kGroupColumns), groups(layout_.rows, kGroupRows), 1);
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

std::vector<float> CardSheet::forcesOnPins() const {
  std::vector<float> forces(3 * movingPins_.size() * evaluation_);
  if (!forces.empty()) pinForces_.read(forces.data(), forces.size() * sizeof(float));
  return forces;
}

}  // namespace tyg
