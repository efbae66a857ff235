// The view of the cloth: where the camera is, what of the window is free for the cloth, and what of it is drawn.
// Must not know: the simulation, windows, OpenGL.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "view/camera.h"
#include "view/draw_options.h"
#include "viewer/input_event.h"
#include "viewer/input_table.h"

namespace tyg {

/// What of the window is not free for the cloth.
struct Insets {
  int left = 0, right = 0;  ///< pixels at the window's sides that panels and keys take
  int top = 0, bottom = 0;  ///< pixels at its other edges, which bars and what is said take
  int wind = 0;             ///< of the pixels at the top the lowest ones, where a wind is shown; 0: the scene has none
  float beside = 0;  ///< m, to the left of the cloth as the camera sees it, at which a second cloth is shown; 0: none
  bool operator==(const Insets&) const = default;
};

class ViewControl {
 public:
  /// A new cloth, whose motion stays within these points (m): once it moves, the view glides to where all of them are
  /// seen, unless the person has moved the camera.
  void begin(std::vector<glm::vec3> motionBounds);
  /// Where the cloth and the bodies, which are kept by reference, are now, whether time has passed since the start, and
  /// whether nothing of the cloth is cut or torn.
  void follow(const Box& cloth, std::span<const Body> bodies, bool hasMoved, bool isWhole);

  /// Size of the window, and its insets. The first one that is not empty frames the cloth, and what is beside it, in
  /// the rest (a fifth of each side in any case), as frameCloth() does. Later ones fit the same again; where more than
  /// the height that is free changes, what the cloth has taken up in the last seconds, and again when its motion has
  /// calmed down. Once the person has moved the camera the cloth stays as large as it is, and slides to the middle of
  /// what is free.
  void resize(Extent pixels, const Insets& insets);
  /// Shows all of the cloth and of the bodies near to it, as large as fits.
  void frameCloth();
  /// Once a frame: moves as the held keys say, or glides on.
  void move(const Motion& keys, float seconds);
  /// Once a frame of a cloth that breaks: goes along with it while it runs, and shows all of it then, unless the person
  /// has moved the camera. Afterwards, once a frame of any other: goes back.
  void followBreaking(bool breaks, bool runs);
  /// Once a frame after that, of a cloth that has moved: where the particles leave what is free of the window, the
  /// camera goes along with them, no farther than it must, unless the person has moved it. It does not follow parts
  /// of a torn cloth that have come so far apart that it is larger than its motion bounds (by a tenth), but goes back
  /// to these. `positions` (x, y, z of each particle, m) is only asked where the box around the cloth leaves it too.
  void keepInView(const std::function<std::span<const float>()>& positions, float seconds);
  /// In the place of keepInView(): a camera that follows the cloth stops, as while a hand holds something.
  void stay() { drift_ = {}, forgetLately(); }
  void turn(glm::vec2 pixels);                           ///< the cursor moved so far
  void orbit(glm::vec2 pixels, const glm::vec3& about);  ///< likewise, around a point, m
  void approach(float notches);                          ///< of the wheel
  /// The cloth is shown so from now on, whatever its scene says.
  void show(Show how) { chosenShow_ = draw_.show = how; }
  /// What show() and the person chose, if they did.
  [[nodiscard]] std::optional<Show> chosenShow() const { return chosenShow_; }
  /// The scene's wish, which counts until the person chooses.
  void followScene(Show how) { draw_.show = chosenShow_.value_or(how); }
  /// Switches one of the things that are drawn; does nothing for an action of another kind. A family of lines comes on
  /// to a surface that is shown alone.
  void toggle(InputAction action);

  [[nodiscard]] const Camera& camera() const { return camera_; }
  /// The camera moves by itself.
  [[nodiscard]] bool glides() const { return glide_.has_value() || drift_ != glm::vec3(0); }
  [[nodiscard]] Extent pixels() const { return pixels_; }  ///< of the window; 0 x 0 while nothing of it can be seen
  [[nodiscard]] const Insets& insets() const { return insets_; }
  [[nodiscard]] bool visible() const { return pixels_.width > 0 && pixels_.height > 0; }
  [[nodiscard]] const DrawOptions& drawOptions() const { return draw_; }
  [[nodiscard]] bool showsHelp() const { return help_; }        ///< the short list of keys
  [[nodiscard]] bool showsAllKeys() const { return allKeys_; }  ///< the long one, over everything

 private:
  /// On its way from one place of the eye to another, m.
  struct Glide {
    glm::vec3 from{0}, to{0};
    float seconds = 0;  ///< so far
  };
  void fitView();
  void glideTo(std::vector<glm::vec3> points);
  /// The way of the camera (m) that brings kept_ into what is free of the window.
  [[nodiscard]] glm::vec3 missingWay();
  void movedByHand();
  void stop();
  void watchLately(float seconds);
  void forgetLately();
  /// The cloth and the bodies near to it, in the place of inView_.
  [[nodiscard]] std::vector<glm::vec3> pointsOf(const Box& cloth) const;
  void addBeside(std::vector<glm::vec3>& points) const;
  [[nodiscard]] FreePart freePart() const;

  Camera camera_;
  DrawOptions draw_;
  std::optional<Show> chosenShow_;  ///< by the person
  bool help_ = true, allKeys_ = false;
  Extent pixels_;
  Insets insets_;
  Box cloth_;
  std::span<const Body> bodies_;
  bool hasMoved_ = false, inPieces_ = false;
  std::vector<glm::vec3> motionBounds_;
  Box bounds_;                     ///< around them
  std::vector<glm::vec3> inView_;  ///< what was framed, moved on with the camera where that followed the cloth
  std::vector<glm::vec3> kept_;    ///< what keepInView() looks at
  FreePart part_;                  ///< of the window, at the last change of it
  bool framed_ = false;
  bool cameraMoved_ = false;  ///< by the person, since the cloth was framed
  std::optional<Glide> glide_;
  glm::vec3 drift_{0};     ///< m/s, of the camera that follows the cloth
  bool away_ = false;      ///< it has followed it, since something was framed
  bool followed_ = false;  ///< a cloth that breaks
  /// What the cloth has taken up in the present period of some seconds, and in the one before it, if there was one.
  Box lately_;
  std::optional<Box> before_;
  float latelySeconds_ = 0;  ///< of the present period
  bool toBeFitted_ = false;  ///< once the cloth's motion has calmed down: what is free of the window has changed
};

}  // namespace tyg
