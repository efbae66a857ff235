// The scene in use, with its method and step: how a person changes them, at once where the running simulation can take
// the change, else from a new start; and the cures of a failure, which are such changes too.
// Must not know: windows, panels, who chooses.
#pragma once

#include <array>
#include <string>
#include <utility>

#include "viewer/card_offer.h"
#include "viewer/run_control.h"
#include "viewer/scene_change.h"

namespace tyg {

struct OpenedFile;
using StepText = std::array<char, 48>;

class SceneControl {
 public:
  /// `scene`: that of the run's simulation. All that is given here must live as long as this does.
  SceneControl(const Scene& scene, Settings settings, RunControl& run, Notes& notes);

  /// Goes on with this scene: at once where the running simulation can, else from the start. Changes nothing and warns
  /// where the scene does not fit together. Returns what it took.
  SceneChange use(const Scene& scene);
  /// Opens a scene or the log of a run, which is then played. Throws InputError where it is neither, or cannot be used.
  void open(const OpenedFile& file, const std::string& path);
  /// By its slot in methods(); does nothing beyond the last one.
  void chooseMethod(std::size_t slot);
  /// By a twentieth.
  void smallerStep();
  void largerStep();
  /// The step of the cure, or 0.9 of the limit where nothing failed.
  void takeSafeStep();
  /// The method of the cure; does nothing where there is none.
  void takeHoldingMethod();
  /// From the start, with the scene, method and step that are chosen.
  void restart();
  /// Whether to follow the dissipated energy, restarts included.
  void followLedger(bool on);
  /// From now on a graphics card can be had.
  void offerCard(CardOffer offer) { cardOffer_ = std::move(offer); }
  [[nodiscard]] bool canHaveCard() const { return cardOffer_ != nullptr; }
  /// Whether the graphics card moves the cloth, which then begins anew, in float. Says what the card is; changes
  /// nothing and warns where none serves.
  void moveOnCard(bool on);
  [[nodiscard]] bool onCard() const { return settings_.device != nullptr; }
  /// Time came to a tick that may have had another method, step or live parameters: they are the chosen ones now.
  void followSimulation();

  /// The scene that a restart begins, with the method and step that are chosen. While the cloth is frozen they are
  /// for the next run.
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Method& method() const { return *method_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  /// Counts the sheets there have been: what is made for one sheet is made anew when this changes.
  [[nodiscard]] int sheetsSoFar() const { return sheetsSoFar_; }
  /// Counts the runs there have been, from any start.
  [[nodiscard]] int runsSoFar() const { return runsSoFar_; }
  /// `step of 2 ms`, or `tolerance of 0.1 mm` for a method that chooses its own steps. Allocates nothing.
  void describeStep(StepText& text) const;

 private:
  void useLive(const Scene& scene);
  void useMethod(const Method& method);
  void useStep(double dt);
  void changeStep(double factor);
  void goOnWhereMended();
  void begin(Scene scene, bool newSheet);
  void play(EventLog log);
  void cureWith(const Scene& wanted);

  RunControl& run_;
  Notes& notes_;
  Scene scene_;
  Settings settings_;
  CardOffer cardOffer_;
  const Method* method_;
  int sheetsSoFar_ = 1, runsSoFar_ = 1;
};

}  // namespace tyg
