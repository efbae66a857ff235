// Reads the framebuffer back; whatever goes wrong with files becomes a warning, and the window goes on.
#include "ui/frame_capture.h"

#include <fmt/core.h>

#include <exception>
#include <utility>

#include "core/scene/scene_writer.h"
#include "gfx/contexts/offscreen.h"
#include "util/interrupt.h"

namespace tyg {
namespace {

/// Shows what `work` says, long enough to read where files are, or why it failed.
template <class Work>
void tell(Viewer& viewer, const Work& work) {
  try {
    if (std::string said = work(); !said.empty()) {
      viewer.notes().say(std::move(said), viewer.run().now() + Notes::kFiles);
    }
  } catch (const std::exception& error) {
    viewer.notes().warn(error.what());
  }
}

}  // namespace

bool FrameCapture::handle(const WindowEvent& event) {
  if (event.kind != WindowEvent::Kind::Press || event.control) return false;
  const Input* input = findInput(event.key);
  if (input == nullptr) return false;
  if (input->action == InputAction::KeepPicture) return pictureAsked_ = true;
  if (input->action != InputAction::Film) return false;
  movieAsked_ = !movieAsked_;
  return true;
}

void FrameCapture::toggleMovie(Viewer& viewer, Extent window) {
  tell(viewer, [&]() -> std::string {
    if (files_.filming()) return files_.endMovie();
    files_.beginMovie(viewer.scenes().scene().name, window.width, window.height);
    return {};
  });
}

void FrameCapture::film(Viewer& viewer, Extent window) {
  tell(viewer, [&] { return files_.movieDone(); });
  if (std::exchange(movieAsked_, false)) toggleMovie(viewer, window);
  if (!files_.filming()) return;
  readFramebuffer(window.width, window.height, pixels_);
  tell(viewer, [&] { return files_.film(pixels_, viewer.run().now()); });
}

void FrameCapture::takePicture(Viewer& viewer, Extent window) {
  // On the way to a past time, what is shown is not what the run's log would lead to.
  if (viewer.run().seeking() || !std::exchange(pictureAsked_, false)) return;
  readFramebuffer(window.width, window.height, pixels_);
  tell(viewer, [&] { return files_.keep(pixels_, sceneToToml(viewer.scenes().scene()), viewer.run().recordShown()); });
}

std::string FrameCapture::end() {
  std::string said = files_.endMovie();
  return said.empty() ? files_.awaitMovie(interrupted) : said;
}

std::string FrameCapture::filmingText() const {
  if (files_.finishing()) return fmt::format("finishing {}", files_.movieName());
  if (!files_.filming()) return {};
  return fmt::format("filming into {}  \u00b7  {:.1f} s  \u00b7  Z ends it", files_.movieName(), files_.filmed());
}

}  // namespace tyg
