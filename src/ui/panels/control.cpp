// Each field shows the scene in use; what a person does to it makes a scene that is wanted. A change that restarts the
// cloth waits until the mouse or the keyboard lets go of its field, one that does not is taken at once.
#include "ui/panels/control.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "core/forces/term.h"
#include "core/scene/bodies.h"
#include "core/scene/same_sides.h"
#include "tyg/methods.h"
#include "ui/panels/open_menu.h"
#include "ui/panels/parameter_field.h"
#include "viewer/cure.h"
#include "viewer/edits.h"
#include "viewer/push.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

constexpr double kShortestMs = 1e-3, kLongestMs = 100;  // of the step's slider
constexpr double kFinestMm = 1e-7, kCoarsestMm = 100;   // of the tolerance's
constexpr int kMostParticles = 512;                     // in a row or column, set by hand
constexpr float kLabels = 5.2F;                         // width of the names, in sizes of the text

void name(const char* text, float size) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(kLabels * size + ImGui::GetStyle().WindowPadding.x);
  ImGui::SetNextItemWidth(-1);
}

/// For sliders and fields that are dragged.
constexpr const char* kTyped = "\nCtrl+click: type a number";

void heading(const char* text, const char* explanation) {
  ImGui::Separator();
  ImGui::TextUnformatted(text);
  ImGui::SameLine();
  ImGui::TextDisabled("%s", explanation);
}

class ControlPanel final : public Panel {
 public:
  void draw(const PanelScope& scope) override {
    Viewer& viewer = scope.viewer;
    Scene wanted = draft_.value_or(viewer.scenes().scene());
    constexpr float kTight = 0.7F;  // of the usual space between rows: all of them fit into a window of 720 pixels
    const ImVec2 usual = ImGui::GetStyle().ItemSpacing;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {usual.x, kTight * usual.y});
    drawScene(scope, wanted);
    drawEdits(scope, wanted);
    heading("Motion", "(live)");
    drawStepping(scope, wanted);
    drawSprings(scope, wanted);
    drawWorld(scope, wanted);
    heading("Sheet", "(restarts)");
    drawSheet(scope, wanted);
    ImGui::PopStyleVar();
    holdTolerance(wanted);
    take(viewer, wanted);
    // After a start anew, which forgets notes.
    if (!draft_ && !clamped_.empty()) viewer.notes().say(std::exchange(clamped_, {}));
  }

 private:
  void take(Viewer& viewer, const Scene& wanted) {
    const SceneChange change = changeBetween(viewer.scenes().scene(), wanted);
    draft_.reset();
    if (change == SceneChange::None) return;
    if (change != SceneChange::Live && ImGui::IsAnyItemActive()) {
      draft_ = wanted;
      return;
    }
    viewer.scenes().use(wanted);
  }

  /// Coarser steps would miss the bodies, whether a person takes a larger tolerance or a thinner layer.
  void holdTolerance(Scene& wanted) {
    const double most = largestTolerance(wanted);
    if (!(wanted.tolerance > most)) return;
    wanted.tolerance = most;
    clamped_ = fmt::format("tolerance: {:.3g} mm is the most, a thousandth of the layer of contact", 1e3 * most);
  }

  static void drawScene(const PanelScope& scope, Scene& wanted) {
    name("scene", scope.size);
    if (!ImGui::BeginCombo("##scene", wanted.name.c_str(), ImGuiComboFlags_HeightLarge)) return;
    for (const BuiltinScene& scene : builtinScenes()) {
      const std::string text(scene.name);
      if (ImGui::Selectable(text.c_str(), text == wanted.name)) wanted = loadScene(text, methodNames());
    }
    ImGui::EndCombo();
  }

  static void drawStepping(const PanelScope& scope, Scene& wanted) {
    name("method", scope.size);
    if (ImGui::BeginCombo("##method", wanted.integrator.c_str(), ImGuiComboFlags_HeightLarge)) {
      for (const Method& method : methods()) {
        const std::string text(method.name);
        if (ImGui::Selectable(text.c_str(), text == wanted.integrator)) wanted.integrator = text;
        tip(scope, aboutMethod(method));
      }
      ImGui::EndCombo();
    } else {
      tip(scope, aboutMethod(findMethod(wanted.integrator)));
    }
    const bool adaptive = findMethod(wanted.integrator).adaptive;
    name(adaptive ? "output" : "step", scope.size);
    const char* format = adaptive ? "interval %.4g ms" : "%.4g ms";
    if (logSlider("##step", wanted.dt, 1e3, {kShortestMs, kLongestMs}, format)) {
      wanted.dt = std::clamp(wanted.dt, kShortestMs * 1e-3, kLongestMs * 1e-3);
    }
    tip(scope, (adaptive ? "The output interval: within it " + wanted.integrator +
                               " chooses\nits own steps, as small as the tolerance asks."
                         : "The time from one state to the next: a larger step\nis faster and less accurate.") +
                   kTyped);
    drawStepMargin(scope);
    drawTolerance(scope, wanted);
    drawPush(scope);
  }

  /// Along the slider's foot: green up to nine tenths of the limit, amber up to it, hatched beyond; it ends where the
  /// slider's step is the limit.
  static void drawStepMargin(const PanelScope& scope) {
    const Margin& margin = scope.viewer.run().margin();
    if (margin.band() == MarginBand::None || !(margin.limit > 0)) return;
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const float grab = 0.5F * ImGui::GetStyle().GrabMinSize + 2;
    const auto at = [&](double seconds) {
      const double share = std::log(seconds * 1e3 / kShortestMs) / std::log(kLongestMs / kShortestMs);
      return from.x + grab + static_cast<float>(std::clamp(share, 0.0, 1.0)) * (to.x - from.x - 2 * grab);
    };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float top = to.y - std::round(0.22F * scope.size), limit = at(margin.limit);
    list.AddRectFilled({from.x, top}, {at(Margin::kClose * margin.limit), to.y}, scope.colours.good);
    list.AddRectFilled({at(Margin::kClose * margin.limit), top}, {limit, to.y}, scope.colours.warning);
    list.PushClipRect({limit, top}, to, true);
    const float stride = 0.3F * scope.size;
    for (int line = 0; line < static_cast<int>((to.x - limit) / stride); ++line) {
      const float x = limit + static_cast<float>(line) * stride;
      list.AddLine({x, to.y}, {x + to.y - top, top}, scope.colours.warning, 1.5F);
    }
    list.PopClipRect();
    list.AddLine({limit, from.y}, {limit, to.y}, scope.colours.text, 2);
    ImGui::Dummy({0, 0});
    ImGui::SameLine(kLabels * scope.size + ImGui::GetStyle().WindowPadding.x);
    // The foot of the window says more; here it is one line, so that nothing below it moves.
    const Colours& colours = scope.colours;
    const MarginBand band = margin.band();
    const Colour colour = band == MarginBand::Fine    ? colours.dim
                          : band == MarginBand::Close ? colours.warning
                                                      : colours.past;
    const ImVec4 ink = ImGui::ColorConvertU32ToFloat4(colour);
    if (band == MarginBand::Past) {
      ImGui::TextColored(ink, "%.3g times the largest, %.3g ms", margin.share(), 1e3 * margin.limit);
    } else {
      ImGui::TextColored(ink, "%.0f %% of the largest, %.3g ms", 100 * margin.share(), 1e3 * margin.limit);
    }
  }

  static void drawTolerance(const PanelScope& scope, Scene& wanted) {
    if (!findMethod(wanted.integrator).adaptive) return;
    name("tolerance", scope.size);
    const bool moved = logSlider("##tolerance", wanted.tolerance, 1e3, {kFinestMm, kCoarsestMm}, "%.3g mm");
    tip(scope, std::string("The error that one step may make.") + kTyped);
    if (moved) wanted.tolerance = std::max(wanted.tolerance, kFinestMm * 1e-3);
  }

  static void drawPush(const PanelScope& scope) {
    name("push", scope.size);
    const double usual = usualPush(scope.viewer.run().simulation().sheet());
    double factor = scope.viewer.tools().strength();
    if (logSlider("##push", factor, usual, {0.01 * usual, 100 * usual}, "%.3g N"))
      scope.viewer.tools().setStrength(factor);
    tip(scope, std::string("The force of a click on the cloth.") + kTyped);
  }

  void drawSheet(const PanelScope& scope, Scene& wanted) {
    name("sheet", scope.size);
    if (!typing_) size_ = {wanted.columns, wanted.rows};
    ImGui::InputInt2("##sheet", size_.data());
    typing_ = ImGui::IsItemActive();
    const bool typed = ImGui::IsItemDeactivatedAfterEdit();
    tip(scope, fmt::format("columns and rows of particles, {:.4g} mm apart; the sides stay", 1e3 * wanted.spacing));
    if (typed) resize(scope.viewer, wanted);
    name("precision", scope.size);
    constexpr std::array kPrecisions{"float, 4 bytes", "double, 8 bytes"};
    int precision = static_cast<int>(wanted.precision);
    const bool onCard = scope.viewer.scenes().onCard();  // which computes in float
    if (onCard) ImGui::BeginDisabled();
    if (ImGui::Combo("##precision", &precision, kPrecisions.data(), int(kPrecisions.size()))) {
      wanted.precision = static_cast<Precision>(precision);
    }
    if (onCard) ImGui::EndDisabled();
    tip(scope, "How exact numbers are: float is faster, double rounds less.");
    name("damping", scope.size);
    constexpr std::array kLaws{"of relative velocity", "along the spring"};
    int law = static_cast<int>(wanted.damping);
    if (ImGui::Combo("##law", &law, kLaws.data(), int(kLaws.size()))) wanted.damping = static_cast<Damping>(law);
    tip(scope, "What dampers resist: every difference in velocity,\nor only what changes a spring's length.");
    drawDevice(scope, wanted);
  }

  static void drawDevice(const PanelScope& scope, Scene& wanted) {
    SceneControl& scenes = scope.viewer.scenes();
    if (!scenes.canHaveCard()) return;
    name("device", scope.size);
    constexpr std::array kDevices{"processor", "graphics card"};
    int device = scenes.onCard() ? 1 : 0;
    if (ImGui::Combo("##device", &device, kDevices.data(), int(kDevices.size()))) {
      scenes.moveOnCard(device == 1);
      wanted.precision = scenes.scene().precision;
    }
    tip(scope,
        "What moves the cloth. The graphics card needs OpenGL 4.3, computes in float,\n"
        "and pays for sheets of many thousands of particles.");
  }

  /// What does not fit is told.
  void resize(Viewer& viewer, Scene& wanted) {
    for (const std::size_t k : {0U, 1U}) {
      const int typed = std::exchange(size_.at(k), std::clamp(size_.at(k), 1, kMostParticles));
      if (typed == size_.at(k)) continue;
      if (!clamped_.empty()) clamped_ += ", ";
      clamped_ +=
          fmt::format("{}: {} is the {}", k == 0 ? "columns" : "rows", size_.at(k), typed < 1 ? "least" : "most");
    }
    try {
      const Grid grid = withBothSides(wanted, {size_[0], size_[1]});
      Scene resized = withSheet(wanted, grid.columns, grid.rows);
      refuseUnfitBodies(resized);
      if (const std::string said = takeStepThatHolds(resized); !said.empty()) {
        if (!clamped_.empty()) clamped_ += "; ";
        clamped_ += said;
      }
      wanted = resized;
    } catch (const InputError& error) {
      viewer.notes().warn(error.what());
    }
  }

  /// Where one of the counts was typed, the other follows, so that the sides stay. Throws InputError where they do not.
  static Grid withBothSides(const Scene& scene, Grid typed) {
    const bool hasSides = std::max(scene.columns, scene.rows) > 1 && std::max(typed.columns, typed.rows) > 1;
    if (!hasSides || keepsSides(scene, typed)) return typed;
    for (const Grid& fitting : nearestGrids(scene, typed, kMostParticles)) {
      if (typed.rows == scene.rows && fitting.columns == typed.columns) return fitting;
      if (typed.columns == scene.columns && fitting.rows == typed.rows) return fitting;
    }
    throw InputError("sheet: " + otherSides(scene, typed, kMostParticles));
  }

  static void drawSprings(const PanelScope& scope, Scene& wanted) {
    if (!ImGui::BeginTable("springs", 3, ImGuiTableFlags_SizingStretchSame)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed,
                            kLabels * scope.size - ImGui::GetStyle().CellPadding.x);
    ImGui::TableSetupColumn("stiffness");
    ImGui::TableSetupColumn("damping");
    ImGui::TableNextRow();
    for (int column = 1; column < 3; ++column) {
      ImGui::TableSetColumnIndex(column);
      const char* whole = column == 1 ? "stiffness, N/m" : "damping, N s/m";
      const bool fits = ImGui::CalcTextSize(whole).x <= ImGui::GetContentRegionAvail().x;
      ImGui::TextDisabled("%s", fits ? whole : column == 1 ? "stiffness" : "damping");
    }
    for (const ForceTerm* term : forceTerms()) {
      if (!term->family) continue;
      ImGui::TableNextRow();
      ImGui::TableSetColumnIndex(0);
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(term->name.data(), term->name.data() + term->name.size());
      for (const Parameter& parameter : term->parameters) {
        ImGui::TableSetColumnIndex(parameter.role == Role::Stiffness ? 1 : 2);
        ImGui::SetNextItemWidth(-1);
        parameterField(parameter, "", wanted);
        tip(scope,
            fmt::format("{} in {}, {} in scene files{}", parameter.role == Role::Stiffness ? "stiffness" : "damping",
                        unitText(parameter.unit), parameter.key, kTyped));
      }
    }
    ImGui::EndTable();
  }

  /// The parameters of all terms but the springs; of a term that the scene does not have, those that bring it in.
  void drawWorld(const PanelScope& scope, Scene& wanted) {
    for (const ForceTerm* term : forceTerms()) {
      if (term->family) continue;
      const bool isThere = hasTerm(wanted, *term);
      for (const Parameter& parameter : term->parameters) {
        if (!isThere && !parameter.decidesPresence) continue;
        if (parameter.exists != nullptr && !parameter.exists(wanted)) continue;
        const bool acts = parameter.acts == nullptr || parameter.acts(wanted);
        if (!acts) ImGui::BeginDisabled();
        if (parameter.isSpeed) drawSpeed(scope, parameter, wanted);
        const std::string_view called = parameter.nameIn != nullptr ? parameter.nameIn(wanted) : "";
        name(parameter.isSpeed ? "" : std::string(called.empty() ? parameter.label : called).c_str(), scope.size);
        parameterField(parameter, unitText(parameter.unit), wanted);
        tip(scope, fmt::format("{}{} in scene files{}", parameter.count == 3 ? "along x, y (up) and z, " : "",
                               parameter.key, kTyped));
        if (!acts) ImGui::EndDisabled();
      }
    }
  }

  /// The size of a vector, along the direction that it has, or had last.
  void drawSpeed(const PanelScope& scope, const Parameter& parameter, Scene& wanted) {
    const Vec3 value = parameter.get(wanted);
    double speed = std::hypot(value.x, value.y, value.z);
    if (speed > 0) way_ = {value.x / speed, value.y / speed, value.z / speed};
    name(std::string(parameter.label).c_str(), scope.size);
    const std::string id = fmt::format("##speed of {}", parameter.key);
    const std::string format = fmt::format("%.{}g {}", parameter.digits, unitText(parameter.unit));
    if (!logSlider(id.c_str(), speed, 1, {0, parameter.mostByHand}, format.c_str())) return;
    parameter.set(wanted, {speed * way_.x, speed * way_.y, speed * way_.z});
  }

  void drawEdits(const PanelScope& scope, Scene& wanted) {
    Viewer& viewer = scope.viewer;
    constexpr float kBetween = 0.25F;  // of the text's size, so that all buttons fit beside a scroll bar ...
    constexpr float kWithin = 0.27F;   // ... and between a button's edge and its word
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {kWithin * scope.size, ImGui::GetStyle().FramePadding.y});
    bool edited = false;
    const auto button = [&edited, &scope](const char* text, const char* says, bool usable) {
      if (!usable) ImGui::BeginDisabled();
      const bool pressed = ImGui::Button(text);
      tip(scope, says);
      if (!usable) ImGui::EndDisabled();
      ImGui::SameLine(0, kBetween * scope.size);
      edited = edited || pressed;
      return pressed;
    };
    if (button("Undo", "Ctrl+Z", scope.edits.canUndo())) scope.edits.undo(viewer);
    if (button("Redo", "Ctrl+Y or Ctrl+Shift+Z", scope.edits.canRedo())) scope.edits.redo(viewer);
    if (button("Reset", "as it was opened", scope.edits.canReset(viewer))) scope.edits.reset(viewer);
    if (edited) wanted = viewer.scenes().scene();
    if (button("Save .toml", "into the folder that tyg was started in", true)) save(viewer);
    ImGui::PopStyleVar();
    if (open_.draw(scope)) wanted = viewer.scenes().scene();
  }

  static void save(Viewer& viewer) {
    try {
      const std::filesystem::path file = std::filesystem::absolute(saveScene(viewer));
      viewer.notes().say("saved to " + file.string(), viewer.run().now() + Notes::kFiles);
    } catch (const std::exception& error) {
      viewer.notes().warn(error.what());
    }
  }

  OpenMenu open_;
  std::optional<Scene> draft_;  ///< what a held field has come to
  Vec3 way_{1, 0, 0};           ///< of a speed that is 0 now
  std::array<int, 2> size_{};   ///< of the sheet, as typed
  bool typing_ = false;
  std::string clamped_;  ///< what was typed beyond what the sheet's size may be
};

}  // namespace

std::unique_ptr<Panel> makeControlPanel() { return std::make_unique<ControlPanel>(); }

}  // namespace tyg
