// The order is that of what lies on top: the long list of keys, a failure over panels, a field that is typed into,
// panels, what is written over the cloth, the cloth.
#include "ui/input_router.h"

#include "ui/frame_capture.h"
#include "ui/hud.h"
#include "ui/imgui_session.h"
#include "ui/panels/panels.h"
#include "viewer/viewer.h"

namespace tyg {

std::string_view InputRouter::route(const WindowEvent& event) const {
  for (const Entry& entry : receivers_) {
    if (entry.receiver(event)) return entry.name;
  }
  return {};
}

InputRouter windowRouter(Panels& panels, Hud& hud, FrameCapture& capture, Viewer& viewer) {
  InputRouter router;
  router.add("all keys", [&](const WindowEvent& event) { return hud.pressAllKeys(event, viewer); });
  router.add("failure", [&](const WindowEvent& event) { return hud.pressFailure(event, viewer); });
  router.add("imgui", imGuiTakes);
  router.add("panels", [&](const WindowEvent& event) { return panels.handle(event, viewer); });
  router.add("buttons", [&](const WindowEvent& event) { return hud.pressButton(event, viewer); });
  router.add("time line", [&](const WindowEvent& event) { return hud.dragTime(event, viewer); });
  router.add("capture", [&](const WindowEvent& event) { return capture.handle(event); });
  router.add("viewer", [&](const WindowEvent& event) { return viewer.handle(event), true; });
  return router;
}

}  // namespace tyg
