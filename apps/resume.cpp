#include "apps/resume.h"

#include <fmt/format.h>

#include "solver/mesh/error.h"

namespace ease {

Checkpoint checkpointIn(const std::filesystem::path& directory) {
  if (!std::filesystem::is_directory(directory))
    throw InputError(fmt::format("{}: no such directory: expected that of an earlier run", directory.string()));
  if (!std::filesystem::exists(directory / kCheckpoint))
    throw InputError(fmt::format("{}: has no checkpoint yet: expected that of an earlier run, with {}",
                                 directory.string(), kCheckpoint));
  return readCheckpoint(directory / kCheckpoint);
}

void checkGoesOn(const Checkpoint& from, const std::filesystem::path& directory, const Scene& scene,
                 const SceneInput& input) {
  const auto expectSame = [&](const char* key, double before, double now) {
    if (before != now)
      throw InputError(fmt::format("{}: {} was {:g} and is {:g}: expected the same, to go on from there",
                                   (directory / kCheckpoint).string(), key, before, now));
  };
  expectSame("the garment's number of vertices", from.state.positions.rows(), input.garment.positions.rows());
  expectSame("the garment's number of triangles", from.rest_edges.size(), input.garment.triangles.rows());
  expectSame("[solver] time_step", from.time_step_s, scene.solver.time_step);
  expectSame("[solver] steps_per_pose", from.steps_per_pose, scene.solver.steps_per_pose);
  expectSame("[body] steps", from.interpolation_steps, scene.body ? scene.body->steps : 0);
}

}  // namespace ease
