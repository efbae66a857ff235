// A motion that another program wrote, opened in the window: the ghost of the cloth, and what the check says of it.
// Must not know: windows, panels, files.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "viewer/background_check.h"
#include "viewer/given_ghost.h"

namespace tyg {

class MotionReview {
 public:
  /// Takes this text as a motion of the scene, in the place of any other, and begins to check it. Throws InputError
  /// with what was found and what is allowed, and changes nothing, where it is none.
  void open(const std::string& text, const std::string& path, const Scene& scene);
  /// Checks it again, as a motion of this scene.
  void checkAgain(const Scene& scene);
  void stopCheck() { check_.stop(); }
  /// The cloth begins anew, with this scene. A motion that cannot be one of it is closed; returns why, else nothing.
  std::string beginRun(const Scene& scene);

  [[nodiscard]] bool isOpen() const { return ghost_.has_value(); }
  /// Counts the motions that were opened so far.
  [[nodiscard]] int opened() const { return opened_; }
  /// Of the file, without its folder; on one line.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// There is one while a motion is open.
  [[nodiscard]] GivenGhost& ghost() { return ghost_.value(); }
  [[nodiscard]] const GivenGhost& ghost() const { return ghost_.value(); }
  [[nodiscard]] const CheckProgress& check() { return check_.progress(); }
  /// Whether what was checked is a motion of this scene too: only its method and its steps may be others.
  [[nodiscard]] bool isOf(const Scene& scene) const;

 private:
  std::optional<GivenGhost> ghost_;
  std::shared_ptr<const GivenMotion> motion_;
  std::string name_;
  Scene checked_;
  int opened_ = 0;
  BackgroundCheck check_;
};

}  // namespace tyg
