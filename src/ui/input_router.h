// Who gets what the person does with keys and mouse: one ordered list of receivers, of which the first that takes an
// event ends its way. Must not know: window libraries, what a receiver does with an event.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "viewer/input_event.h"

namespace tyg {

class FrameCapture;
class Hud;
class Panels;
class Viewer;

class InputRouter {
 public:
  /// Returns true where the event was for this receiver, and nobody after it is to see it.
  using Receiver = std::function<bool(const WindowEvent&)>;

  /// Is asked after all that were added before. `name` must stay valid.
  void add(std::string_view name, Receiver receiver) { receivers_.push_back({name, std::move(receiver)}); }
  /// Offers the event to one after the other. Returns the name of the one that took it; empty: none did.
  [[nodiscard]] std::string_view route(const WindowEvent& event) const;

 private:
  struct Entry {
    std::string_view name;
    Receiver receiver;
  };
  std::vector<Entry> receivers_;
};

/// The receivers of the window, in their order: "all keys", "imgui", "panels", "buttons", "time line", "capture",
/// "viewer". All that is given here must live as long as the router is used.
InputRouter windowRouter(Panels& panels, Hud& hud, FrameCapture& capture, Viewer& viewer);

}  // namespace tyg
