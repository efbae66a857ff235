// Panels on a screen that is not there, with a mouse and a clock that the test moves.
#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include "tyg/methods.h"
#include "ui/panels/panels.h"
#include "viewer/viewer.h"

namespace tyg {

using Kind = WindowEvent::Kind;

class PanelsFixture : public testing::Test {
 protected:
  PanelsFixture() {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {1280, 720};
    io.IniFilename = nullptr;
    io.Fonts->Build();
    viewer_.resize({.width = 1280, .height = 720}, {.left = 200, .right = 200});
  }
  void frames(int count = 4) {
    for (int k = 0; k < count; ++k) {
      now_ += 1.0 / 60;
      viewer_.frame();
      panels_.follow(viewer_);
      ImGui::NewFrame();
      panels_.draw(viewer_);
      drawOver();
      ImGui::Render();
    }
  }
  /// What a frame shows besides the panels.
  virtual void drawOver() {}
  bool press(KeyCode key, bool control = false, bool shift = false) {
    return panels_.handle({.kind = Kind::Press, .key = key, .control = control, .shift = shift}, viewer_);
  }
  bool pressMouse(double x, double y) {
    return panels_.handle({.kind = Kind::Press, .key = kLeftButton, .x = x, .y = y}, viewer_);
  }

  /// Rests there, goes down and comes up.
  void click(float x, float y) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {x, y}, frames(2);
    io.MouseDown[0] = true, frames(1);
    io.MouseDown[0] = false, frames(2);
  }

  struct Context {
    Context() { ImGui::CreateContext(); }
    ~Context() { ImGui::DestroyContext(); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
  } context_;
  double now_ = 1, busy_ = 0;  ///< s; what each look at the clock takes
  Viewer viewer_{loadScene("curtain", methodNames()), Settings{.threads = 1}, [this] { return now_ += busy_; }};
  Panels panels_{18, viewer_};
};

}  // namespace tyg
