// `tyg run`: simulate a scene without a window, and report.
#include <chrono>
#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/device_options.h"
#include "app/commands/option_checks.h"
#include "app/output/exit_code.h"
#include "app/output/progress.h"
#include "app/output/sample_file.h"
#include "app/reports/run_report.h"
#include "core/simulation/replay.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "util/interrupt.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

struct RunOptions {
  SceneOptions scene;
  DeviceOptions device;
  int samples = 20;
  std::optional<std::string> out, replay;
  bool ledger = false, keepGoing = false, json = false, verbose = false;
};

constexpr const char* kExamples =
    R"(--out writes t,particle,x,y,z,vx,vy,vz (s, m, m/s) with 17 significant digits. The K sample times
are duration/K apart and are met exactly, so a step may be shortened to end on one.
--json: dt_asked and dt are in s (dt is the largest step taken), seconds is the computing time of
the steps alone, energies are in J, stable_dt is in s, and numbers that are not finite are null.

Examples:
  tyg run curtain
  tyg run flag --integrator leapfrog --dt 0.001 --ledger
  tyg run poke --samples 100 --out poke.csv
  tyg run curtain --sheet 200x200 --precision float --threads 2 --json
  tyg run --replay clicks.csv    what `tyg view curtain --record clicks.csv` saw, to the same bits

Exit codes: 0 done; 1 the run became unstable, or a replay ended in other bits; 2 wrong input or
usage; 130 interrupted by Ctrl-C. After 1 and 130 no CSV file is written.)";

EventLog readLog(const std::string& path) {
  return parseEventLog(readWholeFile(path, "--replay: cannot read", "a file written by tyg view --record"), path);
}

template <class T>
void mustAgree(const char* option, const std::optional<T>& given, const T& logged, const std::string& loggedText) {
  if (!given || *given == logged) return;
  throw InputError(std::string(option) + ": the log given to --replay was made with " + loggedText +
                   "; allowed is that, or to leave the option out");
}

/// Whether two scenes differ in nothing that the log does not say itself.
bool sameCloth(Scene scene, const Scene& other) {
  scene.name = other.name, scene.title = other.title, scene.shows = other.shows;
  scene.integrator = other.integrator, scene.dt = other.dt, scene.precision = other.precision;
  scene.tolerance = other.tolerance, scene.duration = other.duration;
  return scene == other;
}

/// The scene as it was when the log was made. Throws InputError where scene and log cannot belong together.
Scene fitted(Scene scene, const SceneOptions& options, const EventLog& log) {
  const auto grid = [](int columns, int rows) { return fmt::format("{}x{}", columns, rows); };
  if (scene.columns != log.columns || scene.rows != log.rows) {
    const std::string logged = grid(log.columns, log.rows);
    throw InputError("--replay: found a sheet of " + grid(scene.columns, scene.rows) + " particles in scene '" +
                     scene.name + "', allowed is the log's: " + logged + " of scene '" + log.scene +
                     "' (try that scene, or --sheet " + logged + ")");
  }
  if (!options.scene.empty() && !log.sceneText.empty() && !sameCloth(scene, loggedScene(log, methodNames()))) {
    std::cerr << "tyg run: the log was made on another cloth than '" << scene.name
              << "' is now; without SCENE its own is used" << std::endl;
  }
  const std::string precision(nameOf(log.precision));
  mustAgree("--precision", options.precision, precision, precision);
  mustAgree("--integrator", options.integrator, log.integrator, log.integrator);
  mustAgree("--dt", options.dt, log.dt, fmt::format("{:g} s", log.dt));
  if (!log.sceneText.empty()) {
    const double tolerance = loggedScene(log, methodNames()).tolerance;
    const std::optional<double> asked = options.tolerance ? std::optional(scene.tolerance) : std::nullopt;
    mustAgree("--tolerance", asked, tolerance, fmt::format("{:g} m", tolerance));
    scene.tolerance = tolerance;
  }
  scene.precision = log.precision;
  scene.integrator = findMethod(log.integrator).name;
  scene.dt = log.dt;
  return scene;
}

/// A simulation being run, and the clock that runs only while it steps.
class Run {
 public:
  Run(const Scene& scene, const RunOptions& options, const std::shared_ptr<Device>& device)
      : options_(options),
        simulation_(scene, findMethod(scene.integrator), settingsOf(options, device)),
        progress_("tyg run " + scene.name) {
    const Ledger start = simulation_.ledger();
    startEnergy_ = start.mechanical() - start.work.sum();
    simulation_.observe([this] { return progress_.show(fractionDone()); });
  }

  void toTheEnd(SampleFile* file) {
    const double duration = simulation_.scene().duration;
    const int stops = file == nullptr ? 1 : options_.samples;
    for (int k = 1; k <= stops && goesOn(); ++k) {
      const double stop = k == stops ? duration : duration * k / stops;
      timed([&] { simulation_.advanceTo(stop); });
      if (file != nullptr && goesOn()) file->add(simulation_);
    }
    simulation_.check();
    progress_.finish();
  }

  void replay(const EventLog& log) {
    replayedTicks_ = log.ticks;
    simulation_.replay(log, methods());
    for (std::int64_t tick = 0; tick < log.ticks && goesOn(); ++tick) timed([&] { simulation_.tick(); });
    simulation_.check();
    progress_.finish();
  }

  [[nodiscard]] Simulation& simulation() { return simulation_; }
  [[nodiscard]] bool failed() const { return simulation_.status() != Status::Ok && !options_.keepGoing; }
  [[nodiscard]] double seconds() const { return seconds_; }
  [[nodiscard]] double startEnergy() const { return startEnergy_; }

 private:
  static Settings settingsOf(const RunOptions& options, const std::shared_ptr<Device>& device) {
    return {.threads = options.scene.threads.value_or(0),
            .ledger = options.ledger,
            .keepGoing = options.keepGoing,
            .device = device};
  }
  [[nodiscard]] double fractionDone() const {
    if (replayedTicks_ > 0) return double(simulation_.ticks()) / double(replayedTicks_);
    return simulation_.time() / simulation_.scene().duration;
  }
  [[nodiscard]] bool goesOn() const { return !failed() && !interrupted(); }

  template <class Work>
  void timed(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  const RunOptions& options_;
  InterruptWatch watch_;
  Simulation simulation_;
  double seconds_ = 0, startEnergy_ = 0;
  std::int64_t replayedTicks_ = 0;  // 0: the scene's duration is what there is to do
  Progress progress_;
};

/// Says how the run ended, on standard output for the result and standard error for what went wrong.
int report(Run& run, const RunOptions& options, const DeviceReport& device, const EventLog* log) {
  Simulation& simulation = run.simulation();
  const FinishedRun finished{simulation,
                             simulation.ledger(),
                             options.ledger,
                             run.seconds(),
                             restLatticeLimit(simulation.scene(), simulation.method()),
                             run.startEnergy(),
                             log != nullptr,
                             device};
  std::cout << (options.json ? runJson(finished) + "\n" : runSummary(finished)) << std::flush;
  if (options.out && !options.json && !run.failed()) {
    std::cout << "written       " << *options.out << ": " << options.samples << " times, " << simulation.sheet().count()
              << " particles" << std::endl;
  }
  if (run.failed()) {
    std::cerr << "tyg run: " << failureAdvice(finished) << std::endl;
    return kSimulationFailed;
  }
  if (log != nullptr && log->hash.empty()) {
    std::cerr << "tyg run: the log has no hash, so that nothing says whether it was replayed to the same bits"
              << std::endl;
  } else if (log != nullptr && log->hash != hashText(simulation)) {
    std::cerr << "tyg run: the replay ended in other bits than the log: found hash " << hashText(simulation)
              << ", the log says " << log->hash << std::endl;
    return kSimulationFailed;
  }
  return kDone;
}

int run(const RunOptions& options) {
  std::optional<EventLog> log;
  if (options.replay) log = readLog(*options.replay);
  const bool fromLog = options.scene.scene.empty();  // there is one then
  Scene scene = fromLog ? overridden(loggedScene(*log, methodNames()), options.scene) : chosenScene(options.scene);
  if (log) scene = fitted(std::move(scene), options.scene, *log);
  takeFloatOnCard(scene, options.device, options.scene.precision || log);
  std::optional<SampleFile> file;
  if (options.out) {
    constexpr double kBytesOfParticle = 140;
    file.emplace(*options.out);
    sayLargeOutput("tyg run", *options.out, scene, std::size_t(options.samples), kBytesOfParticle);
  }

  const ChosenDevice chosen = chosenDevice(options.device, scene, options.scene.threads.value_or(0), "tyg run");
  auto run = std::make_unique<Run>(scene, options, chosen.device);
  if (options.verbose) std::cerr << runPlan(run->simulation());
  if (log) {
    run->replay(*log);
  } else {
    run->toTheEnd(file ? &*file : nullptr);
  }
  if (interrupted()) {
    return sayInterrupted("tyg run",
                          fmt::format("it was at t = {:g} s; nothing was written", run->simulation().time()));
  }
  if (file && !run->failed()) file->keep();
  return report(*run, options, chosen.report, log ? &*log : nullptr);
}

}  // namespace

void addRunCommand(CLI::App& app, Action& action) {
  Command command(app, "run", "Simulate a scene without a window, and report energies, steps and time");
  const auto options = std::make_shared<RunOptions>();
  addSceneOptions(command, options->scene);
  addDeviceOption(command, options->device);
  const CommandOption scene = command.find("SCENE");
  constexpr int kMostSamples = 1000000;
  CommandOption samples = command.option("--samples", options->samples,
                                         "Number of equally spaced sample times after t = 0, for --out [20]");
  samples.typeName("K").check([](const std::string& text) { return checkCount(text, kMostSamples, "sample times"); });
  CommandOption out =
      command.option("--out", options->out, "Write every particle at the sample times to this CSV file");
  out.typeName("FILE.csv");
  command.flag("--ledger", options->ledger,
               "Add up the dissipated energy too, and report the drift of the energy ledger");
  command.flag("--keep-going", options->keepGoing, "Go on after the instability alarm, and end with exit code 0");
  CommandOption replay = command.option("--replay", options->replay,
                                        "Do again what tyg view --record logged, with the log's method, step, "
                                        "tolerance and precision; without SCENE on its own scene");
  replay.typeName("LOG").excludes(out).excludes(samples).excludes(command.find("--duration"));
  command.flag("--json", options->json, "Print one JSON object instead of the summary, after a failure too");
  command.flag("--verbose", options->verbose, "First print on standard error what is simulated, and how");
  command.footer(kExamples);
  command.onChosen([=, &action] {
    if (samples.given() && !out.given()) std::cerr << "tyg run: without --out, --samples is not used" << std::endl;
    if (!scene.given() && replay.given()) options->scene.scene.clear();  // the log's own
    action = [options] { return run(*options); };
  });
}

}  // namespace tyg
