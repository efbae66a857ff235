// Frames the cloth in what is free of the window, and follows the window's size and the person's hand.
#include "viewer/view_control.h"

#include <algorithm>
#include <utility>

#include "view/body_shapes.h"

namespace tyg {

void ViewControl::resize(Extent pixels, const Insets& insets) {
  if (pixels == pixels_ && insets == insets_) return;
  pixels_ = pixels;
  insets_ = insets;
  if (!visible()) return;
  if (!framed_) return frameCloth();
  if (!cameraMoved_) return fitView();
  const float before = std::exchange(aside_, aside());
  camera_.slide(aside_ - before);
}

void ViewControl::frameCloth() {
  camera_.watch(cloth_);
  inView_ = motionBounds_;
  if (hasMoved_) {
    const auto corners = cloth_.corners();
    inView_.assign(corners.begin(), corners.end());
    addBodyPoints(bodies_, cloth_, inView_);
  }
  fitView();
}

void ViewControl::fitView() {
  if (!visible()) return;
  const int free = std::max(pixels_.width / 3, pixels_.width - insets_.left - insets_.right);
  aside_ = aside();
  std::vector<glm::vec3> points = inView_;
  if (insets_.beside > 0) {
    for (const glm::vec3& point : inView_) points.push_back(point - insets_.beside * camera_.right());
  }
  camera_.frame(points, float(free) / float(pixels_.height), aside_);
  framed_ = true;
  cameraMoved_ = false;
}

float ViewControl::aside() const { return 0.5F * float(insets_.left - insets_.right) / float(pixels_.height); }

void ViewControl::move(const Motion& keys, float seconds) {
  camera_.watch(cloth_);
  camera_.move(keys, seconds);
  cameraMoved_ = cameraMoved_ || keys.right != 0 || keys.up != 0 || keys.forward != 0;
}

void ViewControl::turn(glm::vec2 pixels) {
  camera_.turn(pixels.x, pixels.y);
  cameraMoved_ = true;
}

void ViewControl::approach(float notches) {
  camera_.approach(notches);
  cameraMoved_ = true;
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
    case ChangeBackground:
      draw_.background = draw_.background == Background::Dark ? Background::Light : Background::Dark;
      return;
    default:
      return;
  }
}

}  // namespace tyg
