#include "apps/commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <new>
#include <optional>

#include "apps/garment_file.h"
#include "apps/garment_files.h"
#include "apps/job.h"
#include "apps/mesh_list.h"
#include "apps/pattern_check.h"
#include "apps/result_directory.h"
#include "apps/resume.h"
#include "apps/scene.h"
#include "apps/scene_run.h"
#include "apps/words.h"
#include "solver/base/error.h"
#include "solver/mesh/topology.h"

namespace ease {

namespace fs = std::filesystem;

namespace {

/// Reads the scene's meshes and makes its garment, printing warnings.  Throws Interrupted once `interrupted` is true.
SceneInput readWithWarnings(const Scene& scene, const std::atomic<bool>& interrupted,
                            const StartGarment* start = nullptr) {
  const auto pause = [&] {
    if (interrupted) throw Interrupted();
  };
  const SceneInput input = readSceneInput(
      scene, [](const std::string& warning) { say("warning", warning); }, start, pause);
  pause();
  return input;
}

void printParts(const TriangleMesh& mesh) {
  const GarmentParts parts = partsOf(mesh);
  std::vector<std::string> sizes;
  for (const int vertices : parts.vertices) sizes.push_back(std::to_string(vertices));
  if (sizes.size() > 1) fmt::print("            {} parts of {} vertices\n", sizes.size(), shortList(sizes));
}

/// Prints the summary of `ease check`, which shows the user whether the scene is the intended one.
void printSummary(const Scene& scene, const SceneInput& input) {
  const Topology topology = buildTopology(input.garment, scene.name);
  size_t pinned = 0;
  for (const std::vector<int>& vertices : input.pins) pinned += vertices.size();
  fmt::print("{}\n", scene.name);
  const size_t loops = topology.boundary_loops.size();
  fmt::print("  garment   {} vertices, {} triangles, {} boundary loop{}, {} pinned\n", input.garment.positions.rows(),
             input.garment.triangles.rows(), loops, loops == 1 ? "" : "s",
             counted(static_cast<long>(pinned), "vertex"));
  for (size_t p = 0; p < input.pins.size(); ++p) {
    Vec3 sum = Vec3::Zero();
    for (const int v : input.pins[p]) sum += input.garment.positions.row(v).transpose();
    const Vec3 mean = sum / static_cast<double>(std::max<size_t>(input.pins[p].size(), 1));
    const auto* loop = std::get_if<std::string>(&scene.garment.pins[p].what);
    fmt::print("            pin {}{}: {} about ({:.3f}, {:.3f}, {:.3f})\n", p + 1,
               loop ? fmt::format(", loop \"{}\"", *loop) : "",
               counted(static_cast<long>(input.pins[p].size()), "vertex"), mean.x(), mean.y(), mean.z());
  }
  printParts(input.garment);
  if (scene.body) {
    fmt::print("  body      {} vertices, {} triangles, poses: {}\n", input.poses.front().rows(),
               input.body_triangles.rows(), shortList(input.pose_names));
    printParts({input.poses.front(), input.body_triangles});
  } else {
    fmt::print("  body      none\n");
  }
  const int steps = timeStepsOfMotion(replaySchedule(scene));
  fmt::print("  motion    {} time steps of {:g} s: {:g} s, by {}\n", steps, scene.solver.time_step,
             steps * scene.solver.time_step, nameOf(scene.solver.method));
  if (const int parts = substepsOf(scene, input).time; parts > 1)
    fmt::print("            each in {} parts, since the body moves {:.2g} mm in it\n", parts,
               1e3 * runInput(scene, input, nullptr).body_motion);
  if (const auto& adaption = scene.adaption) {
    const std::string motion = fmt::format(
        "{} through the motion{}", adaption->cycles == 1 ? "once" : fmt::format("{} times", adaption->cycles),
        adaption->settle > 0 ? fmt::format(", then {} time steps more", adaption->settle) : "");
    if (fitsInPasses(scene))
      fmt::print(
          "  adaption  principal stretch at most {:g} in all but {:g} of the triangles, at most {} passes, each {}\n",
          1.0 + adaption->limit, adaption->fit.target, adaption->fit.max_passes, motion);
    else
      fmt::print("  adaption  principal stretch at most {:g}, every {} time steps, {}{}\n", 1.0 + adaption->limit,
                 adaption->every, motion, adaption->verify ? ", verified" : "");
  }
  fmt::print("ok\n");
}

ExitCode interruptedIn(const fs::path& directory) {
  say("interrupted", fmt::format("what was written until then is in {}", directory.string()));
  return kInterrupted;
}

fs::path directoryOf(const Arguments& arguments, const Scene& scene) {
  if (!arguments.directory.empty()) return arguments.directory;
  return arguments.resumed.empty() ? fs::path("results") / scene.name : fs::path(arguments.resumed);
}

}  // namespace

void say(const char* kind, const std::string& line) {
  std::fputs(fmt::format("ease: {}: {}\n", kind, oneLine(line)).c_str(),
             stderr);  // fmt::print would throw if the disk is full
}

ExitCode guarded(const std::function<ExitCode()>& command) {
  try {
    return command();
  } catch (const Interrupted&) {
    say("interrupted", "nothing was written");
    return kInterrupted;
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

ExitCode checkCommand(const Arguments& arguments, const std::atomic<bool>& interrupted) {
  const Scene scene = readScene(arguments.scene);
  const SceneInput input = readWithWarnings(scene, interrupted);
  if (scene.pattern.is_given && !findsCuts(scene, input)) checkPieces(scene, input);
  printSummary(scene, input);
  return kDone;
}

ExitCode garmentCommand(const Arguments& arguments, const std::atomic<bool>& interrupted) {
  const Scene scene = readScene(arguments.scene, arguments.directory.empty());
  if (!scene.garment.tools)
    throw InputError(fmt::format("{}: [garment] has no [[garment.boundary]]: expected the tools that make a garment",
                                 arguments.scene));
  const SceneInput input = readWithWarnings(scene, interrupted);
  const fs::path directory = directoryOf(arguments, scene);
  const ResultDirectory results(directory);
  results.removeOldGarment(scene);
  fmt::print("{}", writeGarment(scene, input, directory, interrupted));
  if (arguments.pieces && !interrupted)
    fmt::print("{}", writePieces(input.garment, input.authored->seams, directory, "pieces"));
  if (interrupted) return interruptedIn(directory);
  fmt::print("results   {}\n", directory.string());
  return kDone;
}

ExitCode runCommand(const Arguments& arguments, const std::atomic<bool>& interrupted) {
  const auto begin = std::chrono::steady_clock::now();
  Scene scene = readScene(arguments.scene, arguments.directory.empty());
  if (arguments.threads >= 0) scene.solver.threads = arguments.threads;
  const fs::path directory = directoryOf(arguments, scene);

  // TBB's implicit arena fixes its number of threads at first use, so an explicit one is made with the requested
  // number.
  const int threads = scene.solver.threads;
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  return arena.execute([&] {
    std::optional<Checkpoint> checkpoint;
    if (!arguments.resumed.empty()) checkpoint = checkpointIn(arguments.resumed);
    const SceneInput input = readWithWarnings(scene, interrupted, checkpoint ? &checkpoint->start : nullptr);
    substepsOf(scene, input);  // throws if the scene cannot be simulated
    if (checkpoint) checkResumable(*checkpoint, arguments.resumed, scene, input);
    if (checkpoint && isAtEnd(*checkpoint, arguments.resumed, scene, input)) {
      fmt::print(
          "nothing left to do: the run in {} is at the end; it goes on with more poses, cycles, passes or steps\n",
          arguments.resumed);
      return kDone;
    }
    const ResultDirectory results(directory);
    if (!checkpoint && !arguments.force) results.refuseOtherScene(scene.name);
    if (!checkpoint && results.holdsStoppedRun())
      say("warning",
          fmt::format("{0}: replaces a run that was stopped; ease run {1} --resume {0} would have gone on with it",
                      directory.string(), scene.file.string()));
    results.removeOldGarment(scene);
    if (input.authored) writeGarment(scene, input, directory, interrupted);
    try {
      std::error_code differs;
      const bool same_directory = checkpoint && fs::equivalent(directory, arguments.resumed, differs);
      const RunEnd end = runScene(scene, input, directory, interrupted, begin, checkpoint, same_directory);
      if (end != RunEnd::interrupted) return end == RunEnd::doubtful ? kDoubtful : kDone;
    } catch (const ComputationError& error) {
      throw ComputationError(fmt::format("{}; what was written until then is in {}", error.what(), directory.string()));
    }
    return interruptedIn(directory);
  });
}

}  // namespace ease
