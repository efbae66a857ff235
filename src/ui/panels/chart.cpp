// The study begins anew whenever something of the scene changes that its rows depend on.
#include "ui/panels/chart.h"

#include <fmt/core.h>
#include <imgui.h>

#include <cmath>
#include <optional>
#include <utility>

#include "tyg/methods.h"
#include "tyg/sheet.h"
#include "ui/panels/chart_plot.h"
#include "ui/panels/paragraph.h"
#include "util/calibration_clock.h"
#include "viewer/background_study.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

using Stage = StudyProgress::Stage;

/// What the rows depend on: the scene without the settings that are being compared.
Scene studiedPart(Scene scene) {
  scene.integrator.clear();
  scene.dt = scene.tolerance = 1;
  return scene;
}

/// The method in use first, then all others.
std::vector<const Method*> methodsFrom(const Method& first) {
  std::vector<const Method*> order{&first};
  for (const Method& method : methods()) {
    if (&method != &first) order.push_back(&method);
  }
  return order;
}

class LiveChart final : public Panel {
 public:
  void follow(Viewer& viewer) override {
    Scene part = studiedPart(viewer.scenes().scene());
    if (part != studied_) {
      studied_ = std::move(part);
      study_.start(viewer.scenes().scene(), methodsFrom(viewer.scenes().method()));
    }
    const StudyProgress& told = study_.progress();
    const std::pair now{told.rows.size(), std::lround(100 * told.fraction)};
    news_ = now != shown_ || told.stage != stage_;
    shown_ = now, stage_ = told.stage;
  }

  [[nodiscard]] bool busy() const override { return news_; }

  /// A study that is done stays, in case the panel is opened again.
  void close() override {
    if (study_.running()) study_.stop(), studied_.reset();
  }

  void draw(const PanelScope& scope) override {
    const StudyProgress& told = study_.progress();
    progressLine(scope, told);
    Viewer& viewer = scope.viewer;
    const Simulation& simulation = viewer.run().simulation();
    const ChartPlot::Contents contents{
        .rows = told.rows,
        .scale = {.duration = viewer.scenes().scene().duration, .size = simulation.sheet().size()},
        .present = {&viewer.scenes().method(), simulation.dt(), simulation.scene().tolerance,
                    viewer.run().margin().limit},
        .allMethods = told.allMethods};
    const WorkRow* under = plot_.draw(scope, contents, std::round(kPlotHeight * scope.size));
    if (under != nullptr && under->status == RowStatus::Ok && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
      adopt(viewer, settingOf(*under));
    }
    words(scope, contents, told.stage == Stage::Done);
  }

 private:
  static constexpr float kPlotHeight = 17;  // text sizes

  static void progressLine(const PanelScope& scope, const StudyProgress& told) {
    switch (told.stage) {
      case Stage::Reference:
        return dim(scope, "computing the reference: %.0f %%", 100 * told.fraction, 0);
      case Stage::Rows:
        return dim(scope, "measuring: %.0f %%, %d runs so far", 100 * told.fraction, int(told.rows.size()));
      case Stage::Failed:
        return paragraph(told.problem, scope.colours.text);
      default:
        dim(scope, "from the start of the scene, one thread: %.0f %%, %d runs", 100 * told.fraction,
            int(told.rows.size()));
    }
    if (told.refusals.empty()) return;
    ImGui::SameLine();
    dim(scope, "(%.0f left out)", double(told.refusals.size()), 0);
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    for (const std::string& refusal : told.refusals) ImGui::TextUnformatted(refusal.c_str());
    ImGui::EndTooltip();
  }

  static void dim(const PanelScope& scope, const char* format, double number, int count) {
    ImGui::PushStyleColor(ImGuiCol_Text, scope.colours.dim);
    ImGui::Text(format, number, count);
    ImGui::PopStyleColor();
  }

  static void words(const PanelScope& scope, const ChartPlot::Contents& contents, bool finished) {
    const ChartAdvice advice = adviceOn(contents.rows, contents.present, contents.scale, finished);
    paragraph(advice.present, scope.colours.text);
    const Pace& pace = scope.viewer.pace();
    if (scope.viewer.run().state() == RunState::Running && pace.realTime > 0 && pace.simulating > 0) {
      paragraph(fmt::format("Here and now, alarm included: {:.3g} ms per simulated second.",
                            1e3 * pace.simulating / pace.realTime),
                scope.colours.dim);
    }
    if (!advice.better.empty()) {
      paragraph(advice.better, scope.colours.good);
    } else if (std::isfinite(estimateOf(contents.rows, contents.present).error)) {
      paragraph(contents.allMethods ? "No measured setting is faster or more accurate."
                                    : "Not every method has been measured yet.",
                scope.colours.dim);
    }
  }

  static void adopt(Viewer& viewer, const Setting& setting) {
    Scene wanted = viewer.scenes().scene();
    wanted.integrator = setting.method->name;
    if (setting.method->adaptive) {
      wanted.tolerance = setting.tolerance;
    } else {
      wanted.dt = setting.dt;
    }
    viewer.scenes().use(wanted);
  }

  BackgroundStudy study_{[] { return calibrationClock(1); }};
  std::optional<Scene> studied_;
  ChartPlot plot_;
  std::pair<std::size_t, long> shown_;
  Stage stage_ = Stage::Idle;
  bool news_ = false;
};

}  // namespace

std::unique_ptr<Panel> makeChartPanel() { return std::make_unique<LiveChart>(); }

}  // namespace tyg
