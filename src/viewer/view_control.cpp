// Frames the cloth in what is free of the window, and follows the window's size and the person's hand.
#include "viewer/view_control.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "view/body_shapes.h"

namespace tyg {

namespace {

constexpr float kGlideSeconds = 0.8F;
constexpr float kFollowRate = 10;      // 1/s: the camera catches up with a cloth that is out of view
constexpr float kDriftDecay = 2;       // 1/s, of the camera's speed while it catches up ...
constexpr float kRestDecay = 12;       // ... and once it has
constexpr float kMostMissing = 0.1F;   // cloth sizes: what is missing all at once, as after a drag, is no hurry
constexpr float kLongestMove = 0.05F;  // s: a stalled frame moves the camera no farther
constexpr float kInPieces = 1.1F;      // sizes of the motion bounds: a larger torn cloth has come apart, until it fits
constexpr float kAtRest = 1e-3F;       // cloth sizes a second
constexpr float kPeriod = 3;           // s, in which a cloth takes up about all that it will ...
constexpr float kCalm = 0.9F;          // ... where it has taken up this share of the period before

}  // namespace

void ViewControl::begin(std::vector<glm::vec3> motionBounds) {
  motionBounds_ = std::move(motionBounds);
  inPieces_ = false;
  if (motionBounds_.empty()) return;
  bounds_ = {motionBounds_.front(), motionBounds_.front()};
  for (const glm::vec3& point : motionBounds_) bounds_ = bounds_.with({point, point});
}

void ViewControl::follow(const Box& cloth, std::span<const Body> bodies, bool hasMoved, bool isWhole) {
  cloth_ = cloth, bodies_ = bodies;
  inPieces_ = !isWhole && cloth_.size() > (inPieces_ ? 1 : kInPieces) * bounds_.size();
  const bool turns = hasMoved != std::exchange(hasMoved_, hasMoved);
  if (turns) forgetLately(), toBeFitted_ = false;
  if (!turns || !(hasMoved || away_) || !framed_ || cameraMoved_ || motionBounds_.empty()) return;
  glideTo(hasMoved ? motionBounds_ : pointsOf(cloth_));
}

void ViewControl::resize(Extent pixels, const Insets& insets) {
  if (pixels == pixels_ && insets == insets_) return;
  const auto aside = [](const Insets& of) { return std::array{of.left, of.right}; };
  const bool isLarge = pixels != pixels_ || aside(insets) != aside(insets_);  // lines of text come and go
  pixels_ = pixels;
  insets_ = insets;
  if (!visible()) return;
  if (!framed_) return frameCloth();
  if (!cameraMoved_) {
    if (isLarge && hasMoved_) away_ = toBeFitted_ = true;
    if (isLarge && before_ && !inPieces_) inView_ = pointsOf(before_->with(lately_));
    return fitView();
  }
  const FreePart before = std::exchange(part_, freePart());
  camera_.slide(part_.toTheRight - before.toTheRight, part_.above - before.above);
}

void ViewControl::frameCloth() {
  camera_.watch(cloth_);
  inView_ = pointsOf(cloth_);
  away_ = false;
  fitView();
}

std::vector<glm::vec3> ViewControl::pointsOf(const Box& cloth) const {
  const auto corners = cloth.corners();
  std::vector<glm::vec3> points(corners.begin(), corners.end());
  addBodyPoints(bodies_, cloth, points);
  return points;
}

void ViewControl::forgetLately() {
  lately_ = cloth_;
  before_.reset();
  latelySeconds_ = 0;
}

void ViewControl::watchLately(float seconds) {
  if (!hasMoved_ || followed_ || inPieces_) return forgetLately();
  lately_ = lately_.with(cloth_);
  latelySeconds_ += seconds;
  if (latelySeconds_ < kPeriod) return;
  const bool isCalm = before_ && lately_.size() > kCalm * before_->size();
  if (isCalm && toBeFitted_ && framed_ && !cameraMoved_) {
    glideTo(pointsOf(before_->with(lately_)));
    away_ = true, toBeFitted_ = false;
  }
  before_ = std::exchange(lately_, cloth_);
  latelySeconds_ = 0;
}

void ViewControl::glideTo(std::vector<glm::vec3> points) {
  const glm::vec3 from = camera_.eye();
  inView_ = std::move(points);
  away_ = false;
  fitView();
  glide_ = Glide{.from = from, .to = camera_.eye()};
  camera_.place(from);
}

void ViewControl::followBreaking(bool breaks, bool runs) {
  if (!breaks && std::exchange(followed_, false) && !cameraMoved_) return glideTo(motionBounds_);
  if (!breaks || cameraMoved_ || !visible()) return;
  followed_ = true;
  constexpr float kShare = 0.25F;  // of the way, a frame
  const glm::vec3 from = camera_.eye();
  frameCloth();
  camera_.place(glm::mix(from, camera_.eye(), runs ? kShare : 1));
}

glm::vec3 ViewControl::missingWay() {
  addBeside(kept_);
  // First as deep into the picture as the cloth is beyond all that was framed: one that falls away would become tiny.
  const glm::vec3 from = camera_.eye(), ahead = camera_.forward();
  float beyond = std::numeric_limits<float>::infinity();
  for (const glm::vec3& point : inView_) beyond = std::min(beyond, glm::dot(cloth_.centre() - point, ahead));
  if (beyond > 0 && !inView_.empty()) camera_.place(from + beyond * ahead);
  camera_.keepInView(kept_, part_);
  const glm::vec3 missing = camera_.eye() - from;
  camera_.place(from);
  return missing;
}

void ViewControl::keepInView(const std::function<std::span<const float>()>& positions, float seconds) {
  if (!framed_ || !visible() || !hasMoved_ || motionBounds_.empty() || cameraMoved_ || glide_ || followed_) {
    drift_ = {};
    return;
  }
  if (inPieces_) {
    if (away_) glideTo(motionBounds_);
    return;
  }
  const auto corners = cloth_.corners();
  kept_.assign(corners.begin(), corners.end());
  if (drift_ == glm::vec3(0) && missingWay() == glm::vec3(0)) return;
  const std::span<const float> particles = positions();
  kept_.clear();
  for (std::size_t i = 0; i < particles.size(); i += 3) {
    kept_.emplace_back(particles[i], particles[i + 1], particles[i + 2]);
  }
  const glm::vec3 missing = missingWay();
  // Its speed grows with the way that is missing and with how long it has been: a cloth that goes on steadily is
  // followed at a small distance, and one that stops lets the camera drift to rest.
  const float time = std::clamp(seconds, 0.0F, kLongestMove);
  drift_ +=
      time * (kFollowRate * kFollowRate * missing - (missing == glm::vec3(0) ? kRestDecay : kDriftDecay) * drift_);
  if (glm::length(drift_) < kAtRest * cloth_.size()) drift_ = {};
  const float length = glm::length(missing), most = kMostMissing * cloth_.size();
  const glm::vec3 way = time * (drift_ + 2 * kFollowRate * (length > most ? most / length : 1) * missing);
  camera_.place(camera_.eye() + way);
  if (way != glm::vec3(0)) away_ = true;
  for (glm::vec3& point : inView_) point += way;
}

void ViewControl::movedByHand() {
  cameraMoved_ = true;
  stop();
}

void ViewControl::stop() {
  glide_.reset();
  drift_ = {};
}

void ViewControl::addBeside(std::vector<glm::vec3>& points) const {
  if (insets_.beside <= 0) return;
  for (std::size_t i = 0, count = points.size(); i < count; ++i) {
    points.push_back(points[i] - insets_.beside * camera_.right());
  }
}

void ViewControl::fitView() {
  if (!visible()) return;
  part_ = freePart();
  std::vector<glm::vec3> points = inView_;
  addBeside(points);
  if (inPieces_) camera_.watch(bounds_);  // what fell far away asks for no space around the rest
  camera_.frame(points, part_);
  framed_ = true;
  cameraMoved_ = false;
  stop();
}

FreePart ViewControl::freePart() const {
  const auto [width, height] = pixels_;
  const auto heights = [height = height](int pixels) { return float(pixels) / float(height); };
  return {.width = heights(std::max(width / 5, width - insets_.left - insets_.right)),
          .height = heights(std::max(height / 5, height - insets_.top - insets_.bottom)),
          .toTheRight = heights(insets_.left - insets_.right) / 2,
          .above = heights(insets_.bottom - insets_.top) / 2};
}

void ViewControl::move(const Motion& keys, float seconds) {
  camera_.watch(cloth_);
  camera_.move(keys, seconds);
  if (keys != Motion{}) movedByHand();
  watchLately(seconds);
  if (!glide_) return;
  glide_->seconds += seconds;
  camera_.place(glm::mix(glide_->from, glide_->to, glm::smoothstep(0.0F, kGlideSeconds, glide_->seconds)));
  if (glide_->seconds >= kGlideSeconds) glide_.reset();
}

void ViewControl::turn(glm::vec2 pixels) {
  camera_.turn(pixels.x, pixels.y);
  movedByHand();
}

void ViewControl::orbit(glm::vec2 pixels, const glm::vec3& about) {
  camera_.watch(cloth_);
  camera_.orbit(pixels.x, pixels.y, about);
  movedByHand();
}

void ViewControl::approach(float notches) {
  camera_.approach(notches);
  movedByHand();
}

void ViewControl::toggle(InputAction action) {
  using enum InputAction;
  const auto flip = [](bool& value) { value = !value; };
  const auto flipLines = [&](bool& family) {
    family = draw_.show == Show::Surface || !family;
    if (draw_.show == Show::Surface) show(Show::Both);
  };
  switch (action) {
    case ShowStructural:
      return flipLines(draw_.structural);
    case ShowShear:
      return flipLines(draw_.shear);
    case ShowBend:
      return flipLines(draw_.bend);
    case ChangeShow:
      return show(draw_.show == Show::Lines ? Show::Surface : draw_.show == Show::Surface ? Show::Both : Show::Lines);
    case ShowParticles:
      return flip(draw_.particles);
    case ShowPins:
      return flip(draw_.pins);
    case ShowGround:
      return flip(draw_.ground);
    case ShowHelp:
      return flip(help_);
    case ShowAllKeys:
      return flip(allKeys_);
    case ChangeBackground:
      draw_.background = draw_.background == Background::Dark ? Background::Light : Background::Dark;
      return;
    default:
      return;
  }
}

}  // namespace tyg
