// The command line: `ease run SCENE`, `ease garment SCENE`, `ease check SCENE`.
//
// Exit codes: 0 done, 1 wrong input, 2 the computation failed, 130 interrupted.
#include <fmt/format.h>
#include <oneapi/tbb/task_arena.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>

#include "apps/garment_files.h"
#include "apps/job.h"
#include "apps/result_directory.h"
#include "apps/resume.h"
#include "apps/scene.h"
#include "apps/timeline.h"
#include "apps/words.h"
#include "solver/mesh/error.h"
#include "solver/mesh/topology.h"

namespace fs = std::filesystem;

namespace ease {

namespace {

enum ExitCode { kDone = 0, kWrongInput = 1, kFailed = 2, kInterrupted = 130 };

constexpr const char* kExamples = R"(
Examples:
  ease run scenes/t-shirt.toml                    results in results/t-shirt
  ease run scenes/t-shirt.toml -o out/shirt      results in out/shirt
  ease check scenes/t-shirt.toml                  reads and checks everything, computes nothing
Every key of a scene, with its unit, is explained in scenes/t-shirt.toml; those of the tools that make a garment, in
scenes/tunic.toml.
Exit codes: 0 done, 1 wrong input, 2 the computation failed, 130 interrupted.)";

constexpr const char* kRunExamples = R"(
Examples:
  ease run scenes/t-shirt.toml
  ease run scenes/t-shirt.toml -o out/shirt --threads 1
  ease run scenes/t-shirt.toml --resume results/t-shirt      goes on where it was interrupted
Open garment.pvd, body.pvd and rest.pvd of the results in ParaView; report.json has the figures.
Ctrl-C ends a run early and leaves what is written whole; once more, it ends at once.)";

constexpr const char* kGarmentExamples = R"(
Examples:
  ease garment scenes/tunic.toml                 garment.obj, garment.vtp, garment.json, garment.png in results/tunic
  ease garment scenes/tunic.toml --pieces        cut along its seams as well)";

constexpr const char* kCheckExamples = R"(
Example:
  ease check scenes/t-shirt.toml)";

struct Arguments {
  std::string scene;
  std::string directory;  // empty: results/<name>
  int threads = -1;       // -1: as the scene says
  std::string resumed;    // directory of an earlier run to go on from, or empty
  bool pieces = false;    // of `ease garment`
};

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void onSignal(int) {
  if (interrupted.exchange(true)) ::_exit(kInterrupted);
}

void say(const char* kind, const std::string& line) {
  fmt::print(stderr, "ease: {}: {}\n", kind, line);
}

SceneInput readWithWarnings(const Scene& scene, const StartGarment* before = nullptr) {
  return readSceneInput(
      scene, [](const std::string& warning) { say("warning", warning); }, before);
}

/// What `ease check` prints: enough to see whether the scene is the one that was meant.
void printSummary(const Scene& scene, const SceneInput& input) {
  const Topology topology = buildTopology(input.garment, scene.name);
  size_t pinned = 0;
  for (const std::vector<int>& vertices : input.pins) pinned += vertices.size();
  fmt::print("{}\n", scene.name);
  const size_t loops = topology.boundary_loops.size();
  fmt::print("  garment   {} vertices, {} triangles, {} boundary loop{}, {} pinned vertices\n",
             input.garment.positions.rows(), input.garment.triangles.rows(), loops, loops == 1 ? "" : "s", pinned);
  if (scene.body) {
    fmt::print("  body      {} vertices, {} triangles, poses: {}\n", input.poses.front().rows(),
               input.body_triangles.rows(), fmt::join(input.pose_names, ", "));
  } else {
    fmt::print("  body      none\n");
  }
  const int steps = timeStepsOfMotion(scene);
  fmt::print("  motion    {} time steps of {:g} s: {:g} s, by {}\n", steps, scene.solver.time_step,
             steps * scene.solver.time_step, scene.solver.method);
  if (const int parts = divisionFor(scene, input).time_steps; parts > 1)
    fmt::print("            each in {} parts, since the body moves {:.2g} mm in it\n", parts,
               1e3 * bodyMotionOfStep(scene, input));
  if (const auto& adaption = scene.adaption) {
    fmt::print("  adaption  principal stretch at most {:g}, every {} time steps, {} through the motion{}{}\n",
               1.0 + adaption->limit, adaption->every,
               adaption->cycles == 1 ? "once" : fmt::format("{} times", adaption->cycles),
               adaption->settle > 0 ? fmt::format(", then {} time steps more", adaption->settle) : "",
               adaption->verify ? ", verified" : "");
  }
  fmt::print("ok\n");
}

ExitCode interruptedBeforeWriting() {
  say("interrupted", "nothing was written");
  return kInterrupted;
}

ExitCode interruptedIn(const fs::path& directory) {
  say("interrupted", fmt::format("what was written until then is in {}", directory.string()));
  return kInterrupted;
}

ExitCode checkCommand(const Arguments& arguments) {
  const Scene scene = readScene(arguments.scene);
  const SceneInput input = readWithWarnings(scene);
  if (interrupted) return interruptedBeforeWriting();
  printSummary(scene, input);
  return kDone;
}

fs::path directoryOf(const Arguments& arguments, const Scene& scene) {
  if (!arguments.directory.empty()) return arguments.directory;
  return arguments.resumed.empty() ? fs::path("results") / scene.name : fs::path(arguments.resumed);
}

ExitCode garmentCommand(const Arguments& arguments) {
  const Scene scene = readScene(arguments.scene);
  if (!scene.garment.tools)
    throw InputError(fmt::format("{}: [garment] has no [[garment.boundary]]: expected the tools that make a garment",
                                 arguments.scene));
  const SceneInput input = readWithWarnings(scene);
  if (interrupted) return interruptedBeforeWriting();
  const fs::path directory = directoryOf(arguments, scene);
  const ResultDirectory made(directory);
  made.removeOldGarment(scene);
  fmt::print("{}", writeGarment(scene, input, directory, interrupted));
  if (arguments.pieces && !interrupted)
    fmt::print("{}", writePieces(input.garment, input.authored->seams, directory, "pieces"));
  if (interrupted) return interruptedIn(directory);
  fmt::print("results   {}\n", directory.string());
  return kDone;
}

ExitCode runCommand(const Arguments& arguments) {
  Scene scene = readScene(arguments.scene);
  if (arguments.threads >= 0) scene.solver.threads = arguments.threads;
  const fs::path directory = directoryOf(arguments, scene);

  // An arena of our own: the implicit one takes its size at first use, whatever is asked for later.
  const int threads = scene.solver.threads;
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  return arena.execute([&] {
    std::optional<Checkpoint> from;
    if (!arguments.resumed.empty()) from = checkpointIn(arguments.resumed);
    const SceneInput input = readWithWarnings(scene, from ? &from->start : nullptr);
    divisionFor(scene, input);  // refuses what cannot be simulated
    if (from) checkGoesOn(*from, arguments.resumed, scene, input);
    if (interrupted) return interruptedBeforeWriting();
    const bool replays = scene.adaption && scene.adaption->verify;
    if (from && timeline(scene, true, from->done).empty() && isFinished(arguments.resumed, replays)) {
      fmt::print("nothing left to do: the run in {} is at the end; it goes on with more poses, cycles or steps\n",
                 arguments.resumed);
      return kDone;
    }
    const ResultDirectory made(directory);
    made.removeOldGarment(scene);
    if (input.authored) writeGarment(scene, input, directory, interrupted);
    try {
      std::error_code apart;
      const bool here = from && fs::equivalent(directory, arguments.resumed, apart);
      if (runScene(scene, input, directory, interrupted, from, here)) return kDone;
    } catch (const ComputationError& error) {
      throw ComputationError(fmt::format("{}; what was written until then is in {}", error.what(), directory.string()));
    }
    return interruptedIn(directory);
  });
}

/// Calls `command`; whatever goes wrong becomes one line and an exit code.
template <class Command>
ExitCode guarded(const Command& command) {
  try {
    return command();
  } catch (const InputError& error) {
    say("error", error.what());
    return kWrongInput;
  } catch (const std::bad_alloc&) {
    say("error", "out of memory");
  } catch (const std::exception& error) {
    say("error", error.what());
  }
  return kFailed;
}

ExitCode wrongUsage(const std::string& line) {
  say("error", line + "; see: ease --help");
  return kWrongInput;
}

/// What an unknown word of the line is, and what was probably meant.
std::string unknownText(const CLI::App& app, const std::string& word) {
  const bool is_option = word.front() == '-', has_command = !app.get_subcommands().empty();
  std::vector<std::string> known = {"run", "check", "garment"};
  if (is_option || has_command) known.clear();
  if (is_option)
    for (const CLI::Option* option : (has_command ? app.get_subcommands().front() : &app)->get_options())
      if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
  const std::string nearest = nearestWord(word, known);
  return fmt::format("unknown {} '{}'{}",
                     is_option     ? "option"
                     : has_command ? "argument"
                                   : "command",
                     word, nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest));
}

ExitCode commandLine(int argc, char** argv) {
  CLI::App app("Ease fits a garment to a moving body: poses and a garment in, a rest shape that fits every pose out.",
               "ease");
  app.footer(kExamples);
  app.set_version_flag("--version", "ease " EASE_VERSION, "Print the version and end");
  app.set_help_flag("-h,--help", "Print this help and end");
  app.require_subcommand(0, 1);
  app.allow_extras();  // commands too: what is unknown is named below, in the order of the line

  Arguments arguments;
  CLI::App* run = app.add_subcommand("run", "Simulate and adapt; write series, rest shape, report and picture");
  run->add_option("SCENE", arguments.scene, "Scene file, TOML")->required();
  run->add_option("-o,--output", arguments.directory, "Directory for the results; by default results/<scene's name>")
      ->check([](const std::string& directory) { return directory.empty() ? "expected a directory's name" : ""; });
  run->add_option("--threads", arguments.threads, "Number of threads, 0 for all; by default as the scene says")
      ->check(CLI::Range(0, 1024));
  run->add_option("--resume", arguments.resumed,
                  "Go on where the run in this directory stopped; the scene may have other pins, paint, material, "
                  "offset, adaption, method, or more poses or cycles after those that the body has met.  Results go "
                  "there too, unless -o says otherwise")
      ->check([](const std::string& directory) { return directory.empty() ? "expected a directory's name" : ""; });
  run->footer(kRunExamples);
  CLI::App* check = app.add_subcommand("check", "Read and check all that run would use; compute nothing");
  check->add_option("SCENE", arguments.scene, "Scene file, TOML")->required();
  check->footer(kCheckExamples);

  CLI::App* garment = app.add_subcommand("garment", "Make the garment with the scene's tools; write it and a picture");
  garment->add_option("SCENE", arguments.scene, "Scene file, TOML")->required();
  garment->add_option("-o,--output", arguments.directory, "Directory for the files; by default results/<scene's name>");
  garment->add_flag("--pieces", arguments.pieces, "Cut it along its seams as well: pieces.obj, .vtp, .json");
  garment->footer(kGarmentExamples);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return static_cast<ExitCode>(app.exit(error));  // --help, --version
    return wrongUsage(error.what());
  }
  if (const auto unknown = app.remaining(true); !unknown.empty()) return wrongUsage(unknownText(app, unknown.front()));
  if (run->parsed()) return guarded([&] { return runCommand(arguments); });
  if (check->parsed()) return guarded([&] { return checkCommand(arguments); });
  if (garment->parsed()) return guarded([&] { return garmentCommand(arguments); });
  return wrongUsage("no command: expected 'run', 'garment' or 'check'");
}

/// Whether all that was printed has arrived; says so if not.
bool isPrinted() {
  errno = 0;
  if (std::cout.flush() && std::fflush(stdout) == 0 && !std::ferror(stdout)) return true;
  say("error", fmt::format("standard output: {}", errno != 0 ? std::strerror(errno) : "cannot be written"));
  return false;
}

}  // namespace

}  // namespace ease

int main(int argc, char** argv) {
  std::signal(SIGINT, ease::onSignal);
  std::signal(SIGTERM, ease::onSignal);
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large is an error of writing it
  const ease::ExitCode code = ease::guarded([&] { return ease::commandLine(argc, argv); });
  return ease::isPrinted() ? code : ease::kFailed;
}
