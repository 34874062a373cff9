#include "apps/resume.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "apps/fingerprint.h"
#include "apps/run_inputs.h"
#include "apps/scene_run.h"
#include "solver/base/error.h"

namespace ease {

using nlohmann::literals::operator""_json_pointer;

namespace {

/// Throws InputError unless the scene's motion begins with the poses that the body has reached; with other poses the
/// body would jump.
void checkPosesMet(const Checkpoint& checkpoint, const std::string& directory, const Scene& scene,
                   const SceneInput& input) {
  const std::vector<std::uint64_t> met = posesMet(scene, input, checkpoint.run.done);
  const std::vector<int> poses = posesOfMotion(adaptingSchedule(scene));
  const std::string key = scene.file.string() + ": [body] poses";
  for (size_t k = 0; k < std::min(met.size(), checkpoint.poses_met.size()); ++k)
    if (met[k] != checkpoint.poses_met[k])
      throw InputError(
          fmt::format("{}: number {} of the motion, '{}', is not what the run in {} met there: expected "
                      "the same poses as far as it went; more may follow",
                      key, k + 1, input.pose_names[poses[k]], directory));
  if (met.size() < checkpoint.poses_met.size())
    throw InputError(
        fmt::format("{}: the motion has {} with its cycles, and the run in {} met {}: expected as many at "
                    "least",
                    key, met.size(), directory, checkpoint.poses_met.size()));
}

nlohmann::json reportIn(const std::filesystem::path& directory) {
  std::ifstream in(directory / "report.json");
  return nlohmann::json::parse(in, nullptr, false);
}

}  // namespace

Checkpoint checkpointIn(const std::filesystem::path& directory) {
  if (!std::filesystem::is_directory(directory))
    throw InputError(fmt::format("{}: no such directory: expected that of an earlier run", directory.string()));
  if (!std::filesystem::exists(directory / kCheckpoint))
    throw InputError(fmt::format("{}: has no checkpoint yet: expected that of an earlier run, with {}",
                                 directory.string(), kCheckpoint));
  return readCheckpoint(directory / kCheckpoint);
}

void checkResumable(const Checkpoint& checkpoint, const std::filesystem::path& directory, const Scene& scene,
                    const SceneInput& input) {
  const auto expectSame = [&](const char* key, double before, double now) {
    if (before != now)
      throw InputError(fmt::format("{}: {} was {:g} and is {:g}: expected the same, to go on from there",
                                   (directory / kCheckpoint).string(), key, before, now));
  };
  expectSame("[solver] time_step", checkpoint.time_step_s, scene.solver.time_step);
  expectSame("[solver] steps_per_pose", checkpoint.steps_per_pose, scene.solver.steps_per_pose);
  expectSame("[body] steps", checkpoint.interpolation_steps, scene.body ? scene.body->steps : 0);
  // Passes carry the cloth through the whole motion, whatever an earlier run met.
  if (!fitsInPasses(scene) && checkpoint.fit.passes.empty())
    checkPosesMet(checkpoint, directory.string(), scene, input);
}

void takeStartFrom(const StartGarment& earlier, const std::string& name, const Warn& warn, SceneInput& input) {
  const TriangleMesh &now = input.garment, &then = earlier.mesh;
  if (now.positions.rows() != then.positions.rows() || now.triangles.rows() != then.triangles.rows())
    throw InputError(
        fmt::format("{}: {} vertices and {} triangles: expected the garment of the run that goes on, {} "
                    "and {}",
                    name, now.positions.rows(), now.triangles.rows(), then.positions.rows(), then.triangles.rows()));
  if (now.triangles != then.triangles)
    throw InputError(
        fmt::format("{}: its triangles are not those of the run that goes on: expected the same garment, "
                    "numbered as it was",
                    name));
  if (now.positions == then.positions) return;
  warn(
      fmt::format("{}: its vertices lie elsewhere than at the start of the run that goes on: they are taken as they "
                  "were",
                  name));
  input.garment.positions = then.positions;
  if (input.authored) input.authored->garment.mesh.positions = then.positions;
}

std::vector<std::uint64_t> posesMet(const Scene& scene, const SceneInput& input, const StepsDone& done) {
  const std::vector<int> poses = posesOfMotion(adaptingSchedule(scene));
  const int leg = scene.body ? scene.body->steps * scene.solver.steps_per_pose : 0;
  std::vector<std::uint64_t> met;
  for (int k = 0; k < std::ssize(poses) && (k == 0 || done.moving > (k - 1) * leg); ++k) {
    // Interpolated shapes between two poses depend on the direction (gradient_interpolation.h).
    const bool runs_back = done.moving < k * leg && poses[k] < poses[k - 1];
    const Positions& x = input.poses[poses[k]];
    met.push_back(fingerprint(x.data(), x.size() * sizeof(double)) + (runs_back ? 1 : 0));
  }
  return met;
}

std::vector<std::uint64_t> posesOfWholeMotion(const Scene& scene, const SceneInput& input) {
  StepsDone all;
  all.moving = timeStepsOfMotion(adaptingSchedule(scene)) * adaptingSchedule(scene).cycles;
  return posesMet(scene, input, all);
}

void resumeFit(const Checkpoint& checkpoint, const Scene& scene, const SceneInput& given, const SceneInput& input,
               const std::map<std::string, std::string>& inputs, Fit& fit) {
  if (checkpoint.fit.passes.empty() || checkpoint.poses_met != posesOfWholeMotion(scene, given)) return;
  if (checkpoint.paint == input.paint) fit.resume(checkpoint.fit, checkpoint.fit_setting == fitSetting(scene, inputs));
}

std::uint64_t fitSetting(const Scene& scene, const std::map<std::string, std::string>& inputs) {
  std::string text = scene.adaption ? fmt::format("{} {}", scene.adaption->limit, scene.adaption->fit.target) : "";
  for (const auto& [table, hash] : inputs)
    if (table != "adaption" && table != "solver") text += table + hash;
  return fingerprint(text.data(), text.size());
}

bool keepsFirstRest(const Checkpoint& checkpoint, const Scene& scene, const SceneInput& input) {
  return !fitsInPasses(scene) || checkpoint.paint == input.paint;
}

InputNumbering numberingOf(const SceneInput& input, const std::optional<Checkpoint>& checkpoint) {
  InputNumbering numbering = spatialNumbering(input);
  if (checkpoint) numbering.garment = checkpoint->numbering;
  return numbering;
}

bool isAtEnd(const Checkpoint& checkpoint, const std::filesystem::path& directory, const Scene& scene,
             const SceneInput& input) {
  const bool replays = scene.adaption && scene.adaption->verify;
  if (!isFinished(directory, replays || fitsInPasses(scene))) return false;
  if (!fitsInPasses(scene)) return timeline(adaptingSchedule(scene), checkpoint.run.done).empty();
  const FitState& fit = checkpoint.fit;
  const bool ended = fit.over || static_cast<int>(fit.passes.size()) >= scene.adaption->fit.max_passes;
  return ended && checkpoint.poses_met == posesOfWholeMotion(scene, input) &&
         reportIn(directory).value("inputs", std::map<std::string, std::string>()) == runInputs(scene);
}

bool isFinished(const std::filesystem::path& directory, bool with_replays) {
  const nlohmann::json report = reportIn(directory);
  const bool ended = report.is_object() && !report.value("interrupted", true) && !report.contains("failure");
  return ended && (!with_replays || report.value("/sigma_1"_json_pointer, nlohmann::json()).contains("after"));
}

}  // namespace ease
