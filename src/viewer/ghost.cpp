// The ghost replays the live run's log in strides, and keeps checkpoints of its own to go back to.
#include "viewer/ghost.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tyg/methods.h"

namespace tyg {
namespace {

/// Of the sheet's size, for each step of the reference. Over all built-in scenes it then is within 1e-9 of the size
/// from the truth, at 6 to 21 force evaluations a tick; the scenes' own settings are at 1e-8 or worse, but for two
/// whose steps are a tenth of what would do.
constexpr double kReferenceTolerance = 1e-9;
/// A twin starts as far away as the reference may be off; beside a second method, which need not be right, so many
/// roundings away. More would hide the horizon: lost in the end are twin and cloth equally far.
constexpr double kRoundings = 2;
/// Of the size: a floor above this one could be seen, if not by eye, then on the scale of colours.
constexpr double kSeenFloor = 1e-5;

constexpr std::int64_t kStride = 8;   // ticks between checks of the clock
constexpr double kLongestStride = 1;  // s
constexpr std::size_t kMostCheckpoints = 16;
constexpr std::int64_t kFirstSpacing = 64;  // ticks between checkpoints; doubled whenever there are too many

}  // namespace

Ghost::Ghost(const Simulation& live, const Method* second)
    : second_(second), method_(second != nullptr ? second : &findMethod("dopri54")) {
  begin(live);
}

/// The live scene as the ghost runs it.
Scene Ghost::sceneFor(const Simulation& live) const {
  Scene scene = live.startScene();
  scene.integrator = method_->name;
  if (second_ != nullptr) return scene;
  scene.precision = Precision::Double;
  scene.tolerance = kReferenceTolerance * live.sheet().size();
  return scene;
}

void Ghost::begin(const Simulation& live) {
  liveScene_ = live.startScene();
  scene_ = sceneFor(live);
  const Settings settings{.threads = live.threads()};
  main_.emplace(scene_, *method_, settings);
  twinDistance_ =
      isReference() ? scene_.tolerance : kRoundings * errorFloor(live.sheet().size(), 1, 0, scene_.precision);
  twin_.emplace(twinOf(scene_, twinDistance_), *method_, settings);
  played_.clear();
  checkpoints_.clear();
  ticksBetweenCheckpoints_ = kFirstSpacing;
  told_ = {};
  stalled_ = false;
  keepCheckpoint();
  gap_.reset();
  positions_.resize(3 * static_cast<std::size_t>(live.sheet().count()));
  distances_.clear();
  main_->copyPositions(positions_);
}

std::int64_t Ghost::forceEvaluations() const { return main_->forceEvaluations() + twin_->forceEvaluations(); }

/// The live log grows at its end only, unless the live simulation went back in time: then it is shorter than before.
bool Ghost::hasStrayed(const Simulation& live) const {
  const std::vector<Event>& events = live.log().events;
  if (goal_ < main_->ticks() || events.size() < played_.size()) return true;
  return !played_.empty() && !(events[played_.size() - 1] == played_.back());
}

/// To the last checkpoint that is part of the live one's past.
void Ghost::goBack(const Simulation& live) {
  const std::vector<Event>& events = live.log().events;
  const auto same = static_cast<std::size_t>(std::ranges::mismatch(events, played_).in2 - played_.begin());
  while (checkpoints_.back().tick > goal_ || checkpoints_.back().events > same) checkpoints_.pop_back();
  const Checkpoint& checkpoint = checkpoints_.back();  // the first one is the start, which fits always
  main_->restore(checkpoint.main);
  twin_->restore(checkpoint.twin);
  played_.resize(checkpoint.events);
  gap_.reset();
  distances_.clear();
  told_ = checkpoint.told;
}

void Ghost::keepCheckpoint() {
  if (checkpoints_.size() == kMostCheckpoints) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < checkpoints_.size(); k += 2) checkpoints_[kept++] = std::move(checkpoints_[k]);
    checkpoints_.resize(kept);
    ticksBetweenCheckpoints_ *= 2;
  }
  Checkpoint& made = checkpoints_.emplace_back();
  made.tick = main_->ticks();
  made.events = played_.size();
  made.told = told_;
  made.main = main_->save();
  made.twin = twin_->save();
}

/// Some ticks, no farther than to the next thing that happened to the live cloth.
void Ghost::stride(const Simulation& live) {
  const std::vector<Event>& events = live.log().events;
  while (played_.size() < events.size() && events[played_.size()].tick <= main_->ticks()) {
    const Event& event = events[played_.size()];
    // The reference keeps its own tolerance, either ghost its method.
    const auto* world = std::get_if<WorldEvent>(&event.action);
    const bool ownTolerance = isReference() && world != nullptr && world->parameter == "run.tolerance";
    if (!ownTolerance && !std::holds_alternative<MethodEvent>(event.action)) {
      main_->apply(event, methods());
      twin_->apply(event, methods());
    }
    played_.push_back(event);
  }
  std::int64_t end = std::min(goal_, main_->ticks() + kStride);
  if (played_.size() < events.size()) end = std::min(end, events[played_.size()].tick);
  const std::int64_t count = end - main_->ticks();
  main_->tick(count);
  twin_->tick(count);
  if (twin_->ticks() != main_->ticks()) return;  // it was given up
  if (main_->ticks() - checkpoints_.back().tick >= ticksBetweenCheckpoints_) keepCheckpoint();
}

/// Small steps may be too many for one frame.
bool Ghost::strideInTime(const Simulation& live, const Clock& clock) {
  bool late = false;
  const auto watch = [&, began = clock()] { return !(late = late || clock() - began >= kLongestStride); };
  main_->observe(watch);
  twin_->observe(watch);
  stride(live);
  main_->observe({});
  twin_->observe({});
  return !late;
}

void Ghost::follow(const Simulation& live, double seconds, const Clock& clock, const ShownTarget* shown) {
  if (live.startScene() != liveScene_) begin(live);
  const std::int64_t goal = shown != nullptr ? shown->ticks : live.ticks();
  if (goal < std::exchange(goal_, goal)) stalled_ = false;
  if (hasStrayed(live)) goBack(live);
  const std::int64_t before = main_->ticks();
  const double start = clock();
  while (!stalled_ && main_->ticks() < goal_ && main_->check() == Status::Ok) {
    stalled_ = !strideInTime(live, clock);
    if (clock() - start >= seconds) break;
  }
  const double time = shown != nullptr ? shown->time : live.time();
  behind_ = main_->ticks() == goal_ ? 0 : std::max(0.0, time - main_->time());
  watchGap(clock());
  if (main_->ticks() == before && gap_) return;
  main_->copyPositions(positions_);
  if (main_->ticks() == goal_ && !stalled_) measure(live, shown);
}

void Ghost::watchGap(double now) {
  constexpr double kPatience = 1;  // s of the clock
  const bool inStep = behind_ == 0;
  if (!inStep && now - watched_ < kPatience) return;
  losing_ = !inStep && behindThen_ > 0 && behind_ >= behindThen_;
  watched_ = now, behindThen_ = behind_;
}

void Ghost::measure(const Simulation& live, const ShownTarget* shown) {
  const int count = live.sheet().count();
  distances_.resize(static_cast<std::size_t>(count));
  double square = 0, largest = 0, twinSquare = 0;
  const auto squareBetween = [](const Vec3& a, const Vec3& b) {
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z;
  };
  for (int particle = 0; particle < count; ++particle) {
    const Vec3 here = main_->position(particle);
    const float* pictured = shown != nullptr ? &shown->positions[3 * static_cast<std::size_t>(particle)] : nullptr;
    const Vec3 there = pictured != nullptr ? Vec3{pictured[0], pictured[1], pictured[2]} : live.position(particle);
    const double apart = squareBetween(there, here);
    square += apart;
    largest = std::max(largest, apart);
    distances_[static_cast<std::size_t>(particle)] = static_cast<float>(std::sqrt(apart));
    twinSquare += squareBetween(twin_->position(particle), here);
  }
  GhostGap gap{.time = main_->time(), .rms = std::sqrt(square / count), .largest = std::sqrt(largest)};
  gap.error = told_.error = std::max(told_.error, gap.rms);
  const double size = live.sheet().size(), apart = std::sqrt(twinSquare / count);
  if (twinDistance_ > 0) told_.amplification = std::max(told_.amplification, apart / twinDistance_);
  const double disagreement = isReference() ? told_.amplification * scene_.tolerance : 0;
  gap.floor = errorFloor(size, told_.amplification, disagreement, live.scene().precision);
  if (shown != nullptr) gap.floor = std::max(gap.floor, errorFloor(size, 1, 0, Precision::Float));  // as pictures are
  if (std::isnan(told_.since)) told_.since = gap.time;
  if (gap.means()) told_.meant = gap.time;
  gap_ = gap;
}

double Ghost::horizon() const {
  const bool passed = gap_ && !gap_->means() && gap_->floor > kSeenFloor * main_->sheet().size();
  return passed ? told_.meant : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace tyg
