// See control.h.
#include "app/panels/control.h"

#include <imgui.h>

#include <string>

#include "app/viewer.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

class ControlPanel final : public Panel {
 public:
  void draw(const PanelScope& scope) override {
    Scene wanted = scope.viewer.scene();
    chooseScene(wanted);
    chooseMethod(wanted);
    scope.viewer.use(wanted);
  }

 private:
  static void chooseScene(Scene& wanted) {
    if (!ImGui::BeginCombo("scene", wanted.name.c_str())) return;
    for (const BuiltinScene& scene : builtinScenes()) {
      const std::string name(scene.name);
      if (ImGui::Selectable(name.c_str(), name == wanted.name)) wanted = loadScene(name, methodNames());
    }
    ImGui::EndCombo();
  }
  static void chooseMethod(Scene& wanted) {
    if (!ImGui::BeginCombo("method", wanted.integrator.c_str())) return;
    for (const Method& method : methods()) {
      const std::string name(method.name);
      if (ImGui::Selectable(name.c_str(), name == wanted.integrator)) wanted.integrator = name;
    }
    ImGui::EndCombo();
  }
};

}  // namespace

std::unique_ptr<Panel> makeControlPanel() { return std::make_unique<ControlPanel>(); }

}  // namespace tyg
