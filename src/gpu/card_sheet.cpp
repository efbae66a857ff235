// The fields on the card have the layout of the processor's, so that they are copied as they are. Kernels are told the
// numbers of the scene at every pass: that costs little beside a pass over all particles.
#include "gpu/card_sheet.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace tyg {
namespace {

constexpr unsigned kKinds = 2, kPushes = 9, kPinForces = 10;  // bindings
constexpr unsigned kXyz = 3, kExtremes = 4;                   // of kernels/gather.glsl
constexpr int kGroupColumns = 32, kGroupRows = 4;  // particles of a work group, as kernels/fields.glsl has them
constexpr std::uint32_t kPin = 128;                // of a kind
constexpr unsigned kMovingShift = 8;

std::array<float, 3> lawOf(const SpringLaw<float>& law) { return {law.ks, law.ksTimesRest, law.kd}; }

}  // namespace

CardSheet::CardSheet(Card& card, const Layout& layout)
    : card_(card), layout_(layout), kinds_(card), pushes_(card), pinForces_(card), one_(card), moments_(card) {
  // A kernel may look at a block of memory that it does not use: none of them may be missing.
  for (CardBuffer* buffer : {&pushes_, &pinForces_}) buffer->reserve(sizeof(std::uint32_t));
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

ParticleState CardSheet::particle(int index) {
  std::array<float, 6> numbers{};
  one_.reserve(sizeof numbers);
  std::size_t here = 0;
  for (const Field from : {Field::X, Field::V}) {
    for (int axis = 0; axis < 3; ++axis, here += sizeof(float)) {
      one_.copyFrom(field(from), byteOf(index, axis), here, sizeof(float));
    }
  }
  one_.read(numbers.data(), sizeof numbers);  // all at once: whoever reads waits for the card
  return {{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
}

void CardSheet::place(int index, const ParticleState& particle) {
  const auto put = [&](Field to, const Vec3& v) {
    int axis = 0;
    for (const double component : {v.x, v.y, v.z}) {
      const auto number = float(component);
      field(to).write(&number, sizeof number, byteOf(index, axis++));
    }
  };
  put(Field::X, particle.position), put(Field::V, particle.velocity);
}

std::size_t CardSheet::byteOf(int particle, int axis) const {
  return sizeof(float) * static_cast<std::size_t>(axis * layout_.plane + layout_.at(particle));
}

void CardSheet::showState() const {
  fields_.at(std::size_t(Field::X))->show(unsigned(PassRole::Position));
  fields_.at(std::size_t(Field::V))->show(unsigned(PassRole::Velocity));
  kinds_.show(kKinds);
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

void CardSheet::act(CardActing acting) {
  acting_ = std::move(acting);
  evaluation_ = 0;
  if (!std::ranges::equal(movingPins_, acting_.movingPins)) {
    movingPins_.assign(acting_.movingPins.begin(), acting_.movingPins.end());
    writeKinds();
  }
  writePushes();
  pinForces_.reserve(3 * sizeof(float) * movingPins_.size() * acting_.moments.moments.size());
  moments_.write(std::move(acting_.moments));
  kinds_.show(kKinds), pushes_.show(kPushes), pinForces_.show(kPinForces);
}

std::string CardSheet::definesOf(CardUpdate update) const {
  return fmt::format(
      "#define UPDATE {}\n#define STRUCTURAL {:d}\n#define SHEAR {:d}\n#define BEND {:d}\n#define DAMPING {}\n"
      "#define AIR {:d}\n#define CONTACT {:d}\n#define CUT {:d}\n",
      int(update), terms_.structural, terms_.shear, terms_.bend, terms_.damping, terms_.air, terms_.contact,
      terms_.cut);
}

void CardSheet::setScene(Kernel& kernel) const {
  const AllTerms::Numbers<float>& numbers = moments_.moments().numbers;
  kernel.set("structural", lawOf(static_cast<const StructuralSprings::Numbers<float>&>(numbers).law));
  kernel.set("shear", lawOf(static_cast<const ShearSprings::Numbers<float>&>(numbers).law));
  kernel.set("bend", lawOf(static_cast<const BendSprings::Numbers<float>&>(numbers).law));
  kernel.set("weight", std::to_array(numbers.weight));
  kernel.set("drag", numbers.drag);
  kernel.set("zero", 0.0F);
  kernel.set("pushCount", int(acting_.pushes.size()));
  kernel.set("pinBase", int(evaluation_ * movingPins_.size()));
}

void CardSheet::pass(CardUpdate update, std::initializer_list<InPass> roles, float step, float kick) {
  Kernel& kernel = card_.kernel("step.glsl", definesOf(update));
  kernel.use();
  setScene(kernel);
  moments_.tell(kernel, evaluation_);
  run(kernel, roles, step, kick);
  if (acting_.afterPass) acting_.afterPass(evaluation_);
  ++evaluation_;
}

void CardSheet::beginLeapfrog(std::initializer_list<InPass> roles, float step, float kick) {
  Kernel& kernel = card_.kernel("leapfrog_begin.glsl", "#define CUT 0\n");
  kernel.use();
  run(kernel, roles, step, kick);
}

void CardSheet::gather(const CardBuffer& xyz, const CardBuffer& extremes) {
  Kernel& kernel = card_.kernel("gather.glsl", "#define CUT 0\n");
  kernel.use();
  showState();
  xyz.show(kXyz), extremes.show(kExtremes);
  dispatch(kernel);
}

void CardSheet::run(Kernel& kernel, std::initializer_list<InPass> roles, float step, float kick) {
  kernel.set("stepLength", step), kernel.set("kick", kick);
  for (const auto& [role, which] : roles) field(which).show(unsigned(role));
  dispatch(kernel);
}

void CardSheet::dispatch(Kernel& kernel) const {
  const auto groups = [](int particles, int size) { return (particles + size - 1) / size; };
  dispatch(kernel, groups(layout_.columns, kGroupColumns), groups(layout_.rows, kGroupRows));
}

void CardSheet::dispatch(Kernel& kernel, int groupsAcross, int groupsDown) const {
  kernel.set("columns", layout_.columns), kernel.set("rows", layout_.rows);
  kernel.set("stride", int(layout_.stride)), kernel.set("plane", int(layout_.plane));
  const Gl& gl = card_.gl();
  gl.DispatchCompute(static_cast<GLuint>(groupsAcross), static_cast<GLuint>(groupsDown), 1);
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

std::vector<float> CardSheet::forcesOnPins() const {
  std::vector<float> forces(3 * movingPins_.size() * evaluation_);
  if (!forces.empty()) pinForces_.read(forces.data(), forces.size() * sizeof(float));
  return forces;
}

}  // namespace tyg
