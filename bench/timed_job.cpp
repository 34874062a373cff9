#include "bench/timed_job.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>

#include "apps/run.h"
#include "solver/mesh/error.h"

namespace ease {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A folder for a run's frames, removed in the end.
struct Scratch {
  std::filesystem::path path;
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "ease_fps_XXXXXX").string();
    if (!::mkdtemp(name.data())) throw ComputationError(name + ": cannot be made");
    path = name;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

void run(const Scene& scene, const JobLimits& limits, JobTiming& timing) {
  const Clock::time_point start = Clock::now();
  const SceneInput input = readSceneInput(scene);
  Cloth cloth(input.garment, scene.garment.grain, scene.material);
  timing.vertices = cloth.vertexCount();
  MovingBody body(input.body_triangles, input.poses, scene.body->steps,
                  {scene.collision.voxel, std::max(0.03, 3.0 * scene.collision.offset)});
  const Scratch scratch;
  SeriesOfRun series(scratch.path, input.garment.triangles, input.body_triangles);
  const std::vector<double> first_areas = cloth.restAreas();
  timing.setup_s = secondsSince(start);

  std::atomic<bool> enough = false;
  int steps = 0;
  const Clock::time_point begin = Clock::now();
  RunOptions options;
  options.series = &series;
  options.first_areas = &first_areas;
  options.interrupted = &enough;
  options.on_step = [&](const Moment&) { enough = ++steps >= limits.steps || secondsSince(begin) > limits.seconds; };
  State state;
  PassRecord record;
  try {
    runMotion(scene, input, &body, cloth, options, state, record);
  } catch (const ComputationError& error) {
    std::strncpy(timing.failure, error.what(), sizeof timing.failure - 1);
  }
  timing.run_s = record.wall_s;
  timing.steps = record.steps;
  timing.substeps = record.division.time_steps;
  timing.step_s = record.step_s;
  timing.level_set_s = record.level_set_s;
  timing.interpolation_s = record.interpolation_s;
  timing.adaption_s = record.adaption_s;
  timing.output_s = record.output_s;
  timing.voxels_on_demand = record.voxels_on_demand;
  timing.handed_over = record.handed_over;
  timing.newton_iterations = record.newton_iterations;
  timing.projective_iterations = record.projective_iterations;
  const Penetration& deepest = record.penetration;
  timing.penetration_mm = 1e3 * std::max({deepest.vertices, deepest.edge_midpoints, deepest.centroids});
}

[[noreturn]] void runAndTell(const Scene& scene, const JobLimits& limits, int pipe) {
  JobTiming timing;
  try {
    run(scene, limits, timing);
  } catch (const std::exception& error) {
    std::strncpy(timing.failure, error.what(), sizeof timing.failure - 1);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  timing.peak_memory_MB = static_cast<double>(usage.ru_maxrss) / 1024.0;
  const bool told = ::write(pipe, &timing, sizeof timing) == static_cast<ssize_t>(sizeof timing);
  ::_exit(told ? 0 : 1);
}

}  // namespace

JobTiming timeJob(const Scene& scene, const JobLimits& limits) {
  int ends[2];
  if (::pipe(ends) != 0) throw ComputationError("no pipe to a child process");
  const pid_t child = ::fork();
  if (child < 0) throw ComputationError("no child process");
  if (child == 0) runAndTell(scene, limits, ends[1]);
  ::close(ends[1]);
  JobTiming timing;
  const bool told = ::read(ends[0], &timing, sizeof timing) == static_cast<ssize_t>(sizeof timing);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!told) throw ComputationError(fmt::format("the run died, with status {}", status));
  return timing;
}

}  // namespace ease
