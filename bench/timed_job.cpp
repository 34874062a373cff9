#include "bench/timed_job.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>

#include "apps/scene_run.h"
#include "apps/series_of_run.h"
#include "solver/base/error.h"
#include "solver/base/stopwatch.h"
#include "solver/io/mesh_io.h"

namespace ease {

namespace {

using Clock = std::chrono::steady_clock;

/// Returns the times that were spent between two moments of a run.
PassTimes operator-(const PassTimes& later, const PassTimes& earlier) {
  return {later.total - earlier.total,
          later.step - earlier.step,
          later.interpolation - earlier.interpolation,
          later.level_set - earlier.level_set,
          later.adaption - earlier.adaption,
          later.output - earlier.output};
}

class Job {
 public:
  Job(const Scene& scene, const JobLimits& limits, JobTiming& timing)
      : scene_(scene), limits_(limits), timing_(timing) {}

  void operator()() {
    const Clock::time_point start = Clock::now();
    const SceneInput given = readSceneInput(scene_);
    const InputNumbering numbering = spatialNumbering(given);
    const SceneInput input = renumbered(given, numbering);
    Cloth cloth(input.garment, scene_.garment.grain, scene_.material);
    timing_.vertices = cloth.vertexCount();
    MovingBody body = movingBody(scene_, input);
    timing_.setup_s = secondsSince(start);
    const ScratchDirectory scratch;
    SeriesOfRun series(scratch.path, given, numbering, cloth.restAreas(),
                       runSettings(scene_, adaptingSchedule(scene_)).limit);

    begin_ = Clock::now();
    const RunInput run_input = runInput(scene_, input, &body);
    Run run(runSettings(scene_, adaptingSchedule(scene_)), run_input, cloth);
    RunWatch watch;
    watch.on_frame = [&](const Snapshot& snapshot) { series.write(snapshot); };
    watch.on_step = [&](const Moment&) { countStep(run.record()); };
    watch.interrupted = &enough_;
    try {
      run.run(watch);
    } catch (const ComputationError& error) {
      std::strncpy(timing_.failure, error.what(), sizeof timing_.failure - 1);
      return;
    }
    report(run.record());
  }

 private:
  void countStep(const PassRecord& record) {
    if (++steps_ == 1) {
      timing_.first_step_s = secondsSince(begin_);
      first_ = record;
      begin_ = Clock::now();
      return;
    }
    timing_.run_s = secondsSince(begin_);
    const int timed = steps_ - 1;
    enough_ = timed >= limits_.steps || (timed >= limits_.least && timing_.run_s > limits_.seconds);
  }

  void report(const PassRecord& record) {
    timing_.steps = steps_ - 1;
    timing_.substeps = record.substeps.time;
    timing_.times = record.times - first_.times;
    timing_.handed_over = static_cast<double>(record.solver.handed_over - first_.solver.handed_over);
    timing_.newton_iterations = static_cast<double>(record.solver.newton_iterations - first_.solver.newton_iterations);
    timing_.projective_iterations =
        static_cast<double>(record.solver.projective_iterations - first_.solver.projective_iterations);
    const Penetration& deepest = record.penetration;
    timing_.penetration_mm = 1e3 * std::max({deepest.vertices, deepest.edge_midpoints, deepest.centroids});
  }

  const Scene& scene_;
  const JobLimits& limits_;
  JobTiming& timing_;
  PassRecord first_;  // record after the first step
  std::atomic<bool> enough_ = false;
  int steps_ = 0;
  Clock::time_point begin_;
};

/// Calls `work(timing)` in a child process and returns the timing that it has filled in.
template <class Work>
JobTiming inChild(const Work& work) {
  int ends[2];
  if (::pipe(ends) != 0) throw ComputationError("no pipe to a child process");
  const pid_t child = ::fork();
  if (child < 0) throw ComputationError("no child process");
  JobTiming timing;
  if (child == 0) {
    try {
      work(timing);
    } catch (const std::exception& error) {
      std::strncpy(timing.failure, error.what(), sizeof timing.failure - 1);
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    timing.peak_memory_MB = static_cast<double>(usage.ru_maxrss) / 1024.0;
    const bool told = ::write(ends[1], &timing, sizeof timing) == static_cast<ssize_t>(sizeof timing);
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  const bool told = ::read(ends[0], &timing, sizeof timing) == static_cast<ssize_t>(sizeof timing);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!told) throw ComputationError(fmt::format("the run died, with status {}", status));
  return timing;
}

}  // namespace

ScratchDirectory::ScratchDirectory() {
  std::string name = (std::filesystem::temp_directory_path() / "ease_bench_XXXXXX").string();
  if (!::mkdtemp(name.data())) throw ComputationError(name + ": cannot be made");
  path = name;
}

ScratchDirectory::~ScratchDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

JobTiming timeJob(const Scene& scene, const JobLimits& limits) {
  return inChild([&](JobTiming& timing) { Job(scene, limits, timing)(); });
}

void writeGarment(const Scene& scene, const std::filesystem::path& file) {
  const JobTiming timing = inChild([&](JobTiming&) { writeObj(file, readSceneInput(scene).garment); });
  if (timing.failure[0]) throw ComputationError(timing.failure);
}

}  // namespace ease
