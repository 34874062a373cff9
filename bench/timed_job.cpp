#include "bench/timed_job.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>

#include "apps/run.h"
#include "solver/base/error.h"
#include "solver/io/mesh_io.h"

namespace ease {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What counts in a record, so that the first step can be taken away.
struct Counted {
  double seconds[5];
  long counts[3];
  explicit Counted(const PassRecord& r)
      : seconds{r.step_s, r.level_set_s, r.interpolation_s, r.adaption_s, r.output_s},
        counts{r.handed_over, r.newton_iterations, r.projective_iterations} {}
};

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
    SeriesOfRun series(scratch.path, given, numbering);
    const std::vector<double> first_areas = cloth.restAreas();

    RunOptions options;
    options.series = &series;
    options.first_areas = &first_areas;
    options.interrupted = &enough_;
    options.on_step = [&](const Moment&) { countStep(body); };
    State state;
    begin_ = Clock::now();
    try {
      runMotion(scene_, input, &body, cloth, options, state, record_);
    } catch (const ComputationError& error) {
      std::strncpy(timing_.failure, error.what(), sizeof timing_.failure - 1);
      return;
    }
    report();
  }

 private:
  void countStep(const MovingBody& body) {
    if (++steps_ == 1) {
      timing_.first_step_s = secondsSince(begin_);
      first_ = Counted(record_);
      // The body's times get into the record at the end only.
      first_.seconds[1] = body.times().level_set_s;
      first_.seconds[2] = body.times().interpolation_s;
      begin_ = Clock::now();
      return;
    }
    timing_.run_s = secondsSince(begin_);
    const int timed = steps_ - 1;
    enough_ = timed >= limits_.steps || (timed >= limits_.least && timing_.run_s > limits_.seconds);
  }

  void report() {
    const Counted all(record_);
    timing_.steps = steps_ - 1;
    timing_.substeps = record_.division.time_steps;
    double* const seconds[] = {&timing_.step_s, &timing_.level_set_s, &timing_.interpolation_s, &timing_.adaption_s,
                               &timing_.output_s};
    for (int k = 0; k < 5; ++k) *seconds[k] = all.seconds[k] - first_.seconds[k];
    double* const counts[] = {&timing_.handed_over, &timing_.newton_iterations, &timing_.projective_iterations};
    for (int k = 0; k < 3; ++k) *counts[k] = static_cast<double>(all.counts[k] - first_.counts[k]);
    const Penetration& deepest = record_.penetration;
    timing_.penetration_mm = 1e3 * std::max({deepest.vertices, deepest.edge_midpoints, deepest.centroids});
  }

  const Scene& scene_;
  const JobLimits& limits_;
  JobTiming& timing_;
  PassRecord record_;
  Counted first_{record_};
  std::atomic<bool> enough_ = false;
  int steps_ = 0;
  Clock::time_point begin_;
};

/// Calls `work(timing)` in a child process, and returns what it made of the timing.
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
