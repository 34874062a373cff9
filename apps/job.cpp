#include "apps/job.h"

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <string>

#include "adaption/clip.h"
#include "adaption/stitch.h"
#include "apps/frames.h"
#include "apps/garment_files.h"
#include "apps/progress.h"
#include "apps/report.h"
#include "apps/result_directory.h"
#include "apps/resume.h"
#include "apps/run.h"
#include "solver/base/error.h"
#include "solver/io/mesh_io.h"
#include "viz/picture.h"

namespace ease {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kShownStretch = 0.1;  // marked in the picture of a run that has no limit

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How much longer each triangle's cloth became from one rest shape to another: sigma_1 of the map between them.
void measureGrowth(const std::vector<Mat2>& first_inverse, double first_area, const Cloth& cloth, Report& report) {
  std::vector<double> growth(cloth.triangleCount());
  double area = 0.0;
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    const Mat2 map = cloth.restEdges()[t] * first_inverse[t];
    growth[t] = principalStretch(map.transpose() * map).sigma_1;
    area += cloth.restAreas()[t];
  }
  const StretchStatistics statistics = stretchStatistics(growth, 0.0);
  report.growth_max = statistics.max;
  report.growth_p99 = statistics.p99;
  report.growth_area_ratio = area / first_area;
}

/// A garment in a picture.
struct Shown {
  TriangleMesh garment;
  std::vector<float> sigma_1;
};

/// On the first pose as it starts, and on the last.
struct FirstAndLast {
  Shown first, last;
};

class Job {
 public:
  Job(const Scene& scene, const SceneInput& input, const std::filesystem::path& directory,
      const std::optional<Checkpoint>& from, bool here, const std::atomic<bool>& interrupted)
      : scene_(scene),
        given_(input),
        numbering_(numberingOf(input, from)),
        input_(renumbered(input, numbering_)),
        directory_(directory),
        from_(from),
        here_(here),
        interrupted_(interrupted) {}

  bool operator()() {
    const Clock::time_point start = Clock::now();
    removeOldResults(directory_, here_);
    setUp();
    report_.setup_s = secondsSince(start);
    try {
      adaptingRun();
      if (!interrupted_ && scene_.adaption && scene_.adaption->verify) replays();
    } catch (const ComputationError& error) {
      report_.failure = error.what();
      finishReport(start);
      throw;
    }
    if (!interrupted_) drawPictures();
    finishReport(start);
    if (!interrupted_) removeEarlierReport(directory_);
    fmt::print("{}", summaryText(report_));
    return !interrupted_;
  }

 private:
  static InputNumbering numberingOf(const SceneInput& input, const std::optional<Checkpoint>& from) {
    InputNumbering numbering = spatialNumbering(input);
    if (from) numbering.garment = from->numbering;
    return numbering;
  }

  StepsDone done() const { return from_ ? from_->done : StepsDone(); }

  /// s of motion, until which the series in the directory are kept; -1: none are.
  double resumedAt() const { return here_ ? (from_->done.all + 0.5) * from_->time_step_s : -1.0; }

  void setUp() {
    cloth_.emplace(input_.garment, scene_.garment.grain, scene_.material);
    if (from_)
      cloth_->setRest(from_->first_rest.positions, from_->first_rest.edges);
    else if (!input_.paint.empty())
      Stitcher(*cloth_, systemOrdering(cloth_->vertexCount(), cloth_->triangles())).rescale(*cloth_, input_.paint);
    first_rest_ = cloth_->rest();
    cloth_->setFirst(first_rest_);
    first_inverse_ = cloth_->restInverse();
    first_areas_ = cloth_->restAreas();
    if (scene_.body) body_.emplace(movingBody(scene_, input_));
    report_.vertices = cloth_->vertexCount();
    report_.triangles = cloth_->triangleCount();
    report_.time_step_s = scene_.solver.time_step;
    report_.limit = scene_.adaption ? scene_.adaption->limit : 0.0;
    report_.pose_names = input_.pose_names;
    if (from_) report_.resumed_from_step = from_->done.all;
    report_.warnings = input_.warnings;
    const long replays = scene_.adaption && scene_.adaption->verify ? 2 : 0;
    progress_.emplace(static_cast<long>(timeline(scene_, true, done()).size()) +
                      replays * static_cast<long>(timeline(scene_, false).size()));
  }

  RunOptions options(bool adapting, const char* what) {
    RunOptions options;
    options.adapting = adapting;
    options.first_areas = &first_areas_;
    options.interrupted = &interrupted_;
    options.on_step = [this, what](const Moment& moment) {
      progress_->advance(fmt::format("{}, {:.3f} s of motion", what, moment.time_s));
    };
    return options;
  }

  void adaptingRun() {
    std::optional<SeriesOfRun> series;
    RunOptions run_options = options(true, scene_.adaption ? "adapting" : "simulating");
    const bool moves_on = !timeline(scene_, true, done()).empty();  // otherwise the replays alone are left
    if (scene_.output && moves_on) {
      series.emplace(directory_, given_, numbering_, resumedAt());
      run_options.series = &*series;
    }
    run_options.keep = [&](Checkpoint checkpoint) {
      checkpoint.start = from_ ? from_->start : StartGarment{given_.garment, scene_.collision.offset};
      checkpoint.numbering = numbering_.garment;
      checkpoint.first_rest = first_rest_;
      checkpoint.poses_met = posesMet(scene_, given_, checkpoint.done);
      if (series) series->finish();  // its frames are there before what goes on from them
      writeCheckpoint(directory_ / kCheckpoint, checkpoint);
    };
    run_options.from = from_ ? &*from_ : nullptr;
    const auto finish = [&] {
      if (series) series->finish();
      measureGrowth(first_inverse_, sum(first_areas_), *cloth_, report_);
      report_.folded_edges = foldedEdges(*cloth_, first_rest_.positions);
      const Frame rest = restored(restFrame(*cloth_, first_areas_), numbering_.garment);
      writeObj(directory_ / "rest_shape.obj", {rest.positions, given_.garment.triangles});
      writeVtp(directory_ / "rest_shape.vtp", given_.garment.triangles, rest);
      if (given_.authored && !given_.authored->seams.empty())
        writePieces({rest.positions, given_.garment.triangles}, given_.authored->seams, directory_, "rest_pieces");
    };
    try {
      runMotion(scene_, input_, body(), *cloth_, run_options, state_, report_.run);
    } catch (const ComputationError&) {
      finish();
      throw;
    }
    const Clock::time_point start = Clock::now();
    finish();
    report_.run.output_s += secondsSince(start);
    report_.run.wall_s += secondsSince(start);
  }

  void replays() {
    const RestShape adapted{cloth_->restPositions(), cloth_->restEdges()};
    replay(first_rest_, "replaying the first rest shape", report_.before, before_);
    replay(adapted, "replaying the adapted rest shape", report_.after, after_);
    report_.verified = !interrupted_;
  }

  void replay(const RestShape& rest, const char* what, PassRecord& record, FirstAndLast& shown) {
    if (interrupted_) return;
    cloth_->setRest(rest.positions, rest.edges);
    State state;
    runMotion(scene_, input_, body(), *cloth_, options(false, what), state, record);
    shown = {shownAt(input_.garment.positions), shownAt(state.positions)};
  }

  Shown shownAt(const Positions& x) const {
    std::vector<Stretch> stretch;
    measureStretch(*cloth_, x, stretch);
    Shown shown{{x, cloth_->triangles()}, {}};
    for (const Stretch& s : stretch) shown.sigma_1.push_back(static_cast<float>(s.sigma_1));
    return shown;
  }

  /// How the replays began and ended; without them, how the run ended.
  void drawPictures() {
    progress_.reset();
    const auto draw = [&](const char* name, const Positions& at,
                          std::initializer_list<std::pair<const char*, const Shown*>> all) {
      const TriangleMesh body{at, input_.body_triangles};
      std::vector<StretchView> views;
      for (const auto& [title, shown] : all)
        views.push_back({title, &shown->garment, shown->sigma_1, body_ ? &body : nullptr});
      const double limit = scene_.adaption ? report_.limit : kShownStretch;
      const std::string reason =
          drawStretch(directory_ / name, views, "largest principal stretch", 1.0, 1.0 + 2.0 * limit, 1.0 + limit);
      if (!reason.empty()) report_.warnings.push_back("no picture: " + reason);
    };
    Positions last;
    if (body_) last = input_.poses[posesOfMotion(scene_, !report_.verified).back()];
    if (report_.verified) {
      draw("stretch.png", last, {{"before", &before_.last}, {"after", &after_.last}});
      draw("stretch_first_pose.png", body_ ? input_.poses.front() : last,
           {{"before", &before_.first}, {"after", &after_.first}});
    } else {
      const Shown ended = shownAt(state_.positions);
      draw("stretch.png", last, {{"", &ended}});
    }
  }

  void finishReport(Clock::time_point start) {
    progress_.reset();
    for (const std::string& warning : depthWarnings(report_)) report_.warnings.push_back(warning);
    if (report_.run.fully_grown > 0)
      report_.warnings.push_back(
          fmt::format("{} triangles are still over the limit at {:g} times their first length: a load stretches them, "
                      "not the body's shape; is the cloth too weak for its weight, or pinned too far apart?",
                      report_.run.fully_grown, kMaxGrowth));
    report_.interrupted = interrupted_;
    report_.total_s = secondsSince(start);
    for (size_t k = input_.warnings.size(); k < report_.warnings.size(); ++k)
      std::fputs(fmt::format("ease: warning: {}\n", report_.warnings[k]).c_str(), stderr);
    writeReport(report_, scene_, directory_);
  }

  MovingBody* body() { return body_ ? &*body_ : nullptr; }

  static double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (double value : values) total += value;
    return total;
  }

  const Scene& scene_;
  const SceneInput& given_;
  const InputNumbering numbering_;
  const SceneInput input_;  // the same in this numbering
  const std::filesystem::path directory_;
  const std::optional<Checkpoint>& from_;
  const bool here_;  // the run before is in the same directory
  const std::atomic<bool>& interrupted_;

  std::optional<Cloth> cloth_;
  std::optional<MovingBody> body_;
  RestShape first_rest_;
  std::vector<Mat2> first_inverse_;
  std::vector<double> first_areas_;
  State state_;
  FirstAndLast before_, after_;
  Report report_;
  std::optional<Progress> progress_;
};

}  // namespace

bool runScene(const Scene& scene, const SceneInput& input, const std::filesystem::path& directory,
              const std::atomic<bool>& interrupted, const std::optional<Checkpoint>& from, bool here) {
  return Job(scene, input, directory, from, here, interrupted)();
}

}  // namespace ease
