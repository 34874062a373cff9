// `ease pattern`: the sewing pattern of a scene, or of the results of a run.
#include <fmt/format.h>
#include <oneapi/tbb/task_arena.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/commands.h"
#include "apps/cut_input.h"
#include "apps/flat_settings.h"
#include "apps/frames.h"
#include "apps/garment_files.h"
#include "apps/job.h"
#include "apps/page/garment_areas.h"
#include "apps/page/pattern_in_page.h"
#include "apps/pattern_check.h"
#include "apps/pattern_files.h"
#include "apps/result_directory.h"
#include "apps/run_inputs.h"
#include "apps/scene_run.h"
#include "apps/words.h"
#include "solver/base/error.h"
#include "solver/base/stopwatch.h"
#include "viz/vtp_arrays.h"

namespace ease {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

/// The report of a finished run in a directory; null where there is none.
nlohmann::json finishedReport(const fs::path& directory) {
  std::ifstream in(directory / "report.json");
  if (!in || !fs::exists(directory / "rest_shape.vtp")) return nullptr;
  nlohmann::json report = nlohmann::json::parse(in, nullptr, false);
  if (!report.is_object() || report.value("interrupted", true) || report.contains("failure")) return nullptr;
  return report;
}

/// The scene's file of the run whose results are in a directory.
std::string sceneOf(const fs::path& directory) {
  const nlohmann::json report = finishedReport(directory);
  if (report.is_null()) {
    std::ifstream in(directory / "report.json");
    const nlohmann::json stopped = nlohmann::json::parse(in, nullptr, false);
    if (stopped.is_object() && (stopped.value("interrupted", false) || stopped.contains("failure")))
      throw InputError(fmt::format("{}: this run was stopped before its end: go on with ease run SCENE --resume {}",
                                   directory.string(), directory.string()));
    throw InputError(fmt::format("{}: no finished run: expected report.json and rest_shape.vtp of ease run, or a scene",
                                 directory.string()));
  }
  const std::string scene = report.value("scene_file", "");
  if (scene.empty() || !fs::exists(scene))
    throw InputError(fmt::format("{}: scene_file = '{}': no such scene: give it by name, ease pattern SCENE -o {}",
                                 (directory / "report.json").string(), scene, directory.string()));
  return scene;
}

/// Reads the rest shape that a run wrote, numbered as the garment's file, as that of the garment.
RestShape readRestShape(const fs::path& file, const SceneInput& input) {
  const VtpMesh read = readVtpArrays(file, {"rest_edges_m"});
  if (read.mesh.triangles != trianglesAsRead(input) || read.triangle_arrays[0].components != 4)
    throw InputError(fmt::format("{}: another garment than the scene's: run it again, or give another directory by -o",
                                 file.string()));
  RestShape rest{read.mesh.positions, {}};
  if (input.as_read) {
    rest.positions.resize(input.garment.positions.rows(), 3);
    const std::vector<int>& vertex = input.as_read->vertex;
    for (size_t v = 0; v < vertex.size(); ++v)
      if (vertex[v] >= 0) rest.positions.row(vertex[v]) = read.mesh.positions.row(static_cast<int>(v));
  }
  const std::vector<float>& values = read.triangle_arrays[0].values;
  for (size_t t = 0; t < values.size() / 4; ++t) {
    Mat2 edges;
    edges << values[4 * t], values[4 * t + 2], values[4 * t + 1], values[4 * t + 3];
    rest.edges.push_back(edges);
  }
  return rest;
}

/// Throws InputError where a run was made with another limit than the scene's.
void checkSameLimit(const nlohmann::json& report, const Scene& scene, const fs::path& run) {
  const double limit = scene.adaption ? 1.0 + scene.adaption->limit : 0.0;
  const double of_run = report.value("sigma_1", nlohmann::json::object()).value("limit", 0.0);
  if (std::abs(of_run - limit) < 1e-9) return;
  const auto inWords = [](double of) { return of > 0.0 ? fmt::format("limit = {:.4g}", of - 1.0) : "no limit"; };
  throw InputError(
      fmt::format("{}: this run was made with {}, the scene has {}: run the scene again, or give another "
                  "directory by -o",
                  run.string(), inWords(of_run), inWords(limit)));
}

/// Throws InputError where a run was made with other tables of the scene, or other files named there.
void checkSameInputs(const nlohmann::json& report, const Scene& scene, const fs::path& run) {
  if (!report.contains("inputs")) return;  // of an earlier version
  const std::vector<std::string> tables =
      differingTables(report["inputs"].get<std::map<std::string, std::string>>(), runInputs(scene));
  if (tables.empty()) return;
  throw InputError(
      fmt::format("{}: this run was made with another {} than the scene has now, or with other files named there: run "
                  "the scene again, or give another directory by -o",
                  run.string(), fmt::join(tables, ", ")));
}

/// Checks the results of a finished run against the scene, or runs the scene; returns how that run ended.
RunEnd runOrCheck(const Scene& scene, SceneInput& input, const fs::path& run, const fs::path& directory,
                  bool finds_cuts, Clock::time_point begin, const std::atomic<bool>& interrupted) {
  const nlohmann::json report = finishedReport(run);
  if (report.is_null()) {
    if (!finds_cuts) checkPieces(scene, input);
    fmt::print("no finished run in {}: the scene is run first\n", run.string());
    if (input.authored) writeGarment(scene, input, directory, interrupted);
    return runScene(scene, input, directory, interrupted, begin);
  }
  checkSameLimit(report, scene, run);
  checkSameInputs(report, scene, run);
  RunEnd end = RunEnd::done;
  for (const nlohmann::json& doubt : report.value("doubts", nlohmann::json::array())) {
    end = RunEnd::doubtful;
    say("warning", fmt::format("{}: {}: the pattern is of a garment whose fit is unknown", run.string(),
                               doubt.get<std::string>()));
  }
  return end;
}

/// Finds cuts if asked for, and flattens the rest shape; `input` and `rest` are then cut and slid as the pieces are.
MadePattern madePattern(const Scene& scene, bool finds_cuts, const FlatSettings& settings, SceneInput& input,
                        RestShape& rest) {
  const Clock::time_point begin = Clock::now();
  RestGarment garment{{rest.positions, input.garment.triangles}, rest.edges, input.seams, loopsOf(input)};
  MadePattern made;
  ofPattern(scene, [&] {
    if (finds_cuts) {
      CutSettings cuts = scene.pattern.cuts.value_or(CutsScene()).settings;
      cuts.size.widest = settings.widest;
      made.cuts = findCuts(garment, cuts, settings);
      garment = made.cuts->cut.garment;
      cutInput(made.cuts->cut, input, rest);
    }
    made.flat = flattenGarment(garment, settings);
    checkAllowanceNames(scene.pattern.allowances, made.flat.cut);
    made.file_vertex = verticesAsRead(input, made.flat.cut.pieces.glue);
    cutInput(made.flat.slid, input, rest);
    drawPattern(scene, made);
  });
  made.wall_s = secondsSince(begin);
  return made;
}

/// Sews the pieces again, simulates the garment, and lets out pieces that need it.  Where that fails or is interrupted,
/// `made` stays as it was.
void checkSewn(const Scene& scene, const SceneInput& input, const RestShape& rest, const FlatSettings& settings,
               const std::atomic<bool>& interrupted, MadePattern& made) {
  fmt::print("pattern   {} in {:.1f} s; the garment sewn from them is simulated\n",
             counted(static_cast<long>(made.flat.pieces.size()), "piece"), made.wall_s);
  std::fflush(stdout);
  MadePattern sewn = made;
  sewn.resewn = sewAgain(scene, input, rest, settings, interrupted, sewn.flat);
  const Clock::time_point let_out = Clock::now();
  ofPattern(scene, [&] { drawPattern(scene, sewn); });
  sewn.wall_s += secondsSince(let_out);
  made = std::move(sewn);
}

}  // namespace

ExitCode patternCommand(const Arguments& arguments, const std::atomic<bool>& interrupted) {
  const Clock::time_point begin = Clock::now();
  const bool is_directory = fs::is_directory(arguments.scene);
  Scene scene = readScene(is_directory ? sceneOf(arguments.scene) : arguments.scene);
  if (arguments.threads >= 0) scene.solver.threads = arguments.threads;
  const fs::path directory = !arguments.directory.empty() ? fs::path(arguments.directory)
                             : is_directory               ? fs::path(arguments.scene)
                                                          : fs::path("results") / scene.name;
  const fs::path run = is_directory ? fs::path(arguments.scene) : directory;
  const int threads = scene.solver.threads;
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  return arena.execute([&] {
    SceneInput input = readSceneInput(
        scene, [](const std::string& warning) { say("warning", warning); }, nullptr,
        [&] {
          if (interrupted) throw Interrupted();
        });
    const bool finds_cuts = findsCuts(scene, input);
    const FlatSettings settings = flatSettings(scene);
    const ResultDirectory results(directory);
    const RunEnd end = runOrCheck(scene, input, run, directory, finds_cuts, begin, interrupted);
    if (end == RunEnd::interrupted) {
      say("interrupted", fmt::format("what was written until then is in {}", directory.string()));
      return kInterrupted;
    }
    RestShape rest = readRestShape(run / "rest_shape.vtp", input);
    MadePattern made = madePattern(scene, finds_cuts, settings, input, rest);
    const auto write = [&] {
      const std::vector<std::string> warnings = warningsOf(made);
      for (const std::string& warning : warnings) say("warning", warning);
      removeOldPattern(directory);
      const std::string summary = writePattern(scene, input, made, directory);
      showPatternInPage(directory, summary, warnings);
      fmt::print("{}results   {}\n", summary, directory.string());
    };
    try {
      if (scene.pattern.check) checkSewn(scene, input, rest, settings, interrupted, made);
    } catch (const Interrupted&) {
      write();
      say("interrupted", fmt::format("the pattern is in {}, the garment sewn from it was not checked and not let out",
                                     directory.string()));
      return kInterrupted;
    } catch (const std::exception&) {
      write();
      throw;
    }
    write();
    return end == RunEnd::doubtful ? kDoubtful : kDone;
  });
}

}  // namespace ease
