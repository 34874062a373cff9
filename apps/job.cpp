#include "apps/job.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>

#include "adaption/fit.h"
#include "apps/doubts.h"
#include "apps/finishing_always.h"
#include "apps/frames.h"
#include "apps/page/fit_page.h"
#include "apps/painted_rest.h"
#include "apps/progress.h"
#include "apps/report.h"
#include "apps/rest_shape_files.h"
#include "apps/result_directory.h"
#include "apps/resume.h"
#include "apps/run_pictures.h"
#include "apps/scene_run.h"
#include "apps/series_of_run.h"
#include "garment/paint.h"
#include "solver/base/error.h"
#include "solver/base/stopwatch.h"

namespace ease {

namespace {

class Job {
  using Clock = std::chrono::steady_clock;

 public:
  Job(const Scene& scene, const SceneInput& input, const std::filesystem::path& directory,
      const std::optional<Checkpoint>& resume_from, bool append_to_series, const std::atomic<bool>& interrupted,
      Clock::time_point begin)
      : begin_(begin),
        scene_(scene),
        given_(input),
        numbering_(numberingOf(input, resume_from)),
        input_(renumbered(input, numbering_)),
        directory_(directory),
        resume_from_(resume_from),
        append_to_series_(append_to_series),
        interrupted_(interrupted) {}

  RunEnd operator()() {
    setUp();
    try {
      if (fitsInPasses(scene_)) {
        fit();
      } else {
        adaptingRun();
        if (!interrupted_ && verifies()) replays();
      }
    } catch (const ComputationError& error) {
      report_.failure = error.what();
    }
    progress_.reset();
    report_.interrupted = interrupted_;
    const bool is_done = !report_.interrupted && report_.failure.empty();
    if (is_done) {
      doubt(scene_, given_, numbering_.garment, runInput(scene_, input_, nullptr).body_motion, report_);
      drawPictures();
    }
    tellWarnings();
    finishReport();
    if (is_done) {
      writePage();
      finishReport();  // with the time that the page took
    }
    if (!report_.failure.empty()) throw ComputationError(report_.failure);
    if (is_done) removeEarlierReport(directory_);
    fmt::print("{}", summaryText(report_));
    if (report_.interrupted) return RunEnd::interrupted;
    return report_.doubts.empty() ? RunEnd::done : RunEnd::doubtful;
  }

 private:
  bool verifies() const { return scene_.adaption && scene_.adaption->verify && !fitsInPasses(scene_); }

  std::vector<Moment> momentsLeft() const {
    return timeline(adaptingSchedule(scene_), resume_from_ ? resume_from_->run.done : StepsDone());
  }

  void setUp() {
    const Stopwatch setup(report_.setup_s);
    removeOldResults(directory_, append_to_series_);
    cloth_.emplace(input_.garment, scene_.garment.grain, scene_.material);
    if (resume_from_ && keepsFirstRest(*resume_from_, scene_, input_))
      cloth_->setFirst(resume_from_->first_rest);
    else if (!input_.paint.empty())
      paintFirstRest(input_.paint, *cloth_);
    first_areas_ = cloth_->restAreas();
    if (scene_.body) body_.emplace(movingBody(scene_, input_));
    describe(scene_, input_, *cloth_, report_);
    if (resume_from_ && !fitsInPasses(scene_)) report_.resumed_from_step = resume_from_->run.done.total;
    const long replay_steps = static_cast<long>(timeline(replaySchedule(scene_)).size());
    if (fitsInPasses(scene_))  // at most: all passes, and the check
      progress_.emplace((scene_.adaption->fit.max_passes + 1) *
                        static_cast<long>(timeline(adaptingSchedule(scene_)).size()));
    else
      progress_.emplace(static_cast<long>(momentsLeft().size()) + (verifies() ? 2 * replay_steps : 0));
  }

  RunWatch watch(const std::string& activity, MotionAlbum* album) {
    RunWatch watch;
    if (album) fillAlbum(watch, given_, numbering_, limit(), album == &album_before_, *album);
    watch.interrupted = &interrupted_;
    watch.on_step = [this, activity](const Moment& moment) {
      progress_->advance(fmt::format("{}, {:.3f} s of motion", activity, moment.time_s));
    };
    return watch;
  }

  /// Starts a series, into which the frames of the watched run go (series_of_run.h).
  void writeFrames(std::optional<SeriesOfRun>& series, RunWatch& watch, double keep_until = -1.0,
                   const std::string& replay = "") const {
    series.emplace(directory_, given_, numbering_, first_areas_, limit(), keep_until, replay);
    watch.on_frame = [&series](const Snapshot& snapshot) { series->write(snapshot); };
  }

  void adaptingRun() {
    std::optional<SeriesOfRun> series;
    RunWatch run_watch = watch(scene_.adaption ? "adapting" : "simulating", verifies() ? nullptr : &album_after_);
    if (scene_.output && !momentsLeft().empty()) {  // otherwise only the replays are left
      writeFrames(series, run_watch,
                  append_to_series_ ? (resume_from_->run.done.total + 0.5) * resume_from_->time_step_s : -1.0);
    }
    run_watch.on_checkpoint = [&](const RunState& state) {
      if (series) series->finish();  // frames must be on disk before the checkpoint after them
      writeCheckpoint(directory_ / kCheckpoint, checkpointOf(state));
    };
    const RunInput run_input = runInput(scene_, input_, body());
    Run run(runSettings(scene_, adaptingSchedule(scene_)), run_input, *cloth_);
    if (resume_from_)
      run.resume(withPaint(resume_from_->run, paintBetween(resume_from_->paint, input_.paint), *cloth_));
    const auto finish = [&] {
      report_.run = run.record();
      const Stopwatch total(report_.run.times.total), output(report_.run.times.output);
      end_ = run.state().positions;
      if (series) series->finish();
      writeRestShape();
    };
    finishingAlways([&] { run.run(run_watch); }, finish);
  }

  /// Fits the rest shape in passes (adaption/fit.h); the check writes the frames.
  void fit() {
    const RunInput run_input = runInput(scene_, input_, body());
    Fit fit(runSettings(scene_, adaptingSchedule(scene_)), scene_.adaption->fit, run_input, *cloth_);
    if (resume_from_) resumeFit(*resume_from_, scene_, given_, input_, report_.inputs, fit);
    std::optional<SeriesOfRun> series, before;
    FitWatch fit_watch;
    fit_watch.interrupted = &interrupted_;
    fit_watch.of_pass = [&](int pass) {
      RunWatch run_watch = watch(fmt::format("pass {}", pass), pass == 1 ? &album_before_ : nullptr);
      if (pass == 1 && writesReplays(scene_)) writeFrames(before, run_watch, -1.0, "before");
      return run_watch;
    };
    fit_watch.of_check = [&] {
      RunWatch run_watch = watch("check", &album_after_);
      if (scene_.output) writeFrames(series, run_watch);
      return run_watch;
    };
    fit_watch.on_pass = [&](const FitState& state) {
      const RunState start{{}, {startOf(input_), Positions::Zero(cloth_->vertexCount(), 3)}, cloth_->rest(), {}, {}};
      writeCheckpoint(directory_ / kCheckpoint, checkpointOf(start, state));
    };
    const auto finish = [&] {
      recordFit(fit, secondsSince(begin_), report_);
      for (auto* written : {&before, &series})
        if (*written) (*written)->finish();
      writeRestShape();
    };
    finishingAlways([&] { fit.run(fit_watch); }, finish);
    if (interrupted_) return;
    const RestShape fitted = cloth_->rest();
    before_ = shown(cloth_->first(), fit.state().first_end);
    after_ = shown(fitted, fit.result().check_end);
  }

  std::optional<double> limit() const { return scene_.adaption ? std::optional(scene_.adaption->limit) : std::nullopt; }

  Checkpoint checkpointOf(const RunState& state, const FitState& fit = {}) const {
    return {state,
            fit,
            fitSetting(scene_, report_.inputs),
            fitsInPasses(scene_) ? posesOfWholeMotion(scene_, given_) : posesMet(scene_, given_, state.done),
            scene_.solver.time_step,
            scene_.solver.steps_per_pose,
            scene_.body ? scene_.body->steps : 0,
            resume_from_ ? resume_from_->start : StartGarment{given_.garment, scene_.collision.offset},
            numbering_.garment,
            cloth_->first(),
            input_.paint};
  }

  void writeRestShape() {
    const RestShapeFigures figures = ease::writeRestShape(*cloth_, given_, numbering_.garment, directory_);
    report_.growth = figures.growth;
    report_.folded_edges = figures.folded_edges;
  }

  void replays() {
    const RestShape adapted = cloth_->rest();
    replay(cloth_->first(), "before", "replaying the first rest shape", report_.before, before_, album_before_);
    replay(adapted, "after", "replaying the adapted rest shape", report_.after, after_, album_after_);
    report_.verified = !interrupted_;
  }

  void replay(const RestShape& rest, const char* name, const char* activity, PassRecord& record, ShownReplay& replay,
              MotionAlbum& album) {
    if (interrupted_) return;
    cloth_->setRest(rest);
    const RunInput run_input = runInput(scene_, input_, body());
    Run run(runSettings(scene_, replaySchedule(scene_)), run_input, *cloth_);
    RunWatch run_watch = watch(activity, &album);
    std::optional<SeriesOfRun> series;
    if (writesReplays(scene_)) writeFrames(series, run_watch, -1.0, name);
    run.run(run_watch);
    if (series) series->finish();
    record = run.record();
    replay = shown(rest, run.state().positions);
  }

  /// Shows the start and the end of a replay on a rest shape, which the cloth then has.
  ShownReplay shown(const RestShape& rest, const Positions& end) {
    cloth_->setRest(RestShape(rest));
    return {showGarment(*cloth_, startOf(input_)), showGarment(*cloth_, end)};
  }

  /// Shows how the replays began and ended; without replays, how the run ended.
  void drawPictures() {
    const double limit = shownLimit(scene_);
    const std::vector<int> poses = posesOfMotion(report_.verified ? replaySchedule(scene_) : adaptingSchedule(scene_));
    const auto body = [&](size_t visit) {
      return body_ ? TriangleMesh{input_.poses[poses[visit]], input_.body_triangles} : TriangleMesh();
    };
    const size_t last = poses.empty() ? 0 : poses.size() - 1;
    const ShownGarment shown = report_.verified ? ShownGarment() : showGarment(*cloth_, end_);
    const std::vector<std::string> reasons =
        report_.verified
            ? drawReplays(directory_, before_, after_, body(last), body(0), limit, report_.doubts)
            : std::vector{drawGarments(directory_ / "stretch.png", {{"", &shown}}, body(last), limit, report_.doubts)};
    for (const std::string& reason : reasons)
      if (!reason.empty()) report_.warnings.push_back("no picture: " + reason);
  }

  void tellWarnings() {
    for (const std::string& warning : runWarnings(report_)) report_.warnings.push_back(warning);
    for (size_t k = input_.warnings.size(); k < report_.warnings.size(); ++k)
      std::fputs(fmt::format("ease: warning: {}\n", report_.warnings[k]).c_str(), stderr);
  }

  void finishReport() {
    report_.total_s = secondsSince(begin_);
    writeReport(report_, scene_, directory_);
  }

  void writePage() const {
    writeFitPage(
        {scene_, given_, report_, album_before_, album_after_, restored(first_areas_, numbering_.garment.triangles),
         restored(cloth_->restAreas(), numbering_.garment.triangles)},
        directory_);
  }

  MovingBody* body() { return body_ ? &*body_ : nullptr; }

  const Clock::time_point begin_;
  const Scene& scene_;
  const SceneInput& given_;  // in the numbering of its files
  const InputNumbering numbering_;
  const SceneInput input_;  // `given_` in the run's numbering
  const std::filesystem::path directory_;
  const std::optional<Checkpoint>& resume_from_;
  const bool append_to_series_;
  const std::atomic<bool>& interrupted_;

  std::optional<Cloth> cloth_;
  std::optional<MovingBody> body_;
  std::vector<double> first_areas_;  // areas of the first rest shape's triangles, m^2
  Positions end_;                    // positions of the garment after the run, m
  ShownReplay before_, after_;
  MotionAlbum album_before_, album_after_;
  Report report_;
  std::optional<Progress> progress_;
};

}  // namespace

RunEnd runScene(const Scene& scene, const SceneInput& input, const std::filesystem::path& directory,
                const std::atomic<bool>& interrupted, std::chrono::steady_clock::time_point begin,
                const std::optional<Checkpoint>& resume_from, bool append_to_series) {
  return Job(scene, input, directory, resume_from, append_to_series, interrupted, begin)();
}

}  // namespace ease
