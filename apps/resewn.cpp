#include "apps/resewn.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>

#include "adaption/growth_demand.h"
#include "apps/painted_rest.h"
#include "apps/progress.h"
#include "apps/run_pictures.h"
#include "apps/scene_run.h"
#include "apps/words.h"
#include "garment/pattern/piece_warnings.h"
#include "solver/base/error.h"
#include "solver/base/stopwatch.h"

namespace ease {

namespace {

constexpr double kExcess = 0.1;  // weight of cloth that is larger on the paper than asked for, where it is let out
constexpr int kFollowing = 2;    // rings of triangles around those that are let out, which may follow them
// Limit that the demand is for, over the garment's: so cloth is let out from 0.96 of the limit on, until it is
// stretched by 0.72 of it (growth_demand.h).
constexpr double kLetOut = 1.2;
constexpr double kMoreOverLimit = 0.001;  // share of the triangles beyond the designed garment's that is warned of

/// Where the garment was in the poses, and how far over the limit.
struct Replayed {
  Positions own;                 // held on the first pose
  std::vector<Positions> poses;  // as the body reached them
  std::vector<int> numbers;      // of these poses
  double over_limit = 0.0;
};

/// Both garments on the same body with the same solver.
class Replay {
 public:
  Replay(const Scene& scene, const SceneInput& given, const InputNumbering& numbering,
         const std::atomic<bool>& interrupted)
      : scene_(scene),
        numbering_(numbering),
        input_(renumbered(given, numbering)),
        cloth_(input_.garment, scene.garment.grain, scene.material),
        interrupted_(interrupted) {
    if (!input_.paint.empty()) paintFirstRest(input_.paint, cloth_);
    long steps = static_cast<long>(timeline(replaySchedule(scene)).size());
    if (scene.body) {
      holdFirstPose(scene);
      steps += static_cast<long>(timeline(replaySchedule(held_scene_)).size());
    }
    // At most: both garments, and all rounds of letting out.
    progress_.emplace(steps * (2 + (scene.adaption ? scene.pattern.let_out : 0)));
  }

  Cloth& cloth() { return cloth_; }

  /// `demand`: is told all stretches; may be null. `which`: the garment, for the line of progress.
  Replayed simulate(const RestShape& rest, GrowthDemand* demand, const std::string& which) {
    which_ = which;
    Replayed replayed;
    if (scene_.body) pass(held_scene_, held_input_, &*held_body_, rest, demand, replayed, true);
    pass(scene_, input_, body_ ? &*body_ : nullptr, rest, demand, replayed, false);
    return replayed;
  }

 private:
  void holdFirstPose(const Scene& scene) {
    body_.emplace(movingBody(scene, input_));
    held_scene_ = scene;
    held_scene_.body->poses.resize(1);
    held_input_ = input_;
    held_input_.poses.resize(1);
    held_input_.way.reset();
    held_body_.emplace(movingBody(held_scene_, held_input_));
  }

  void pass(const Scene& scene, const SceneInput& input, MovingBody* body, const RestShape& rest, GrowthDemand* demand,
            Replayed& replayed, bool is_held) {
    cloth_.setRest(rest);
    const RunInput run_input = runInput(scene, input, body);
    Run run(runSettings(scene, replaySchedule(scene)), run_input, cloth_);
    RunWatch watch;
    watch.interrupted = &interrupted_;
    watch.on_stretch = [&](const std::vector<Stretch>& stretch) {
      if (demand) demand->add(cloth_, stretch);
    };
    watch.on_step = [&](const Moment& moment) {
      progress_->advance(
          fmt::format("{}, {:.3f} s {}", which_, moment.time_s, is_held ? "on the first pose" : "of motion"));
      if (is_held || moment.pose < 0) return;
      replayed.poses.push_back(restored(run.state().positions, numbering_.garment.vertices));
      replayed.numbers.push_back(moment.pose);
    };
    run.run(watch);
    if (interrupted_) throw Interrupted();
    const Positions end = restored(run.state().positions, numbering_.garment.vertices);
    if (is_held) replayed.own = end;
    if (!is_held && replayed.poses.empty()) {
      replayed.poses.push_back(end);
      replayed.numbers.push_back(0);
    }
    if (scene_.adaption)
      replayed.over_limit = std::max(replayed.over_limit, run.record().stretch.overall.share_over_limit);
  }

  const Scene& scene_;
  const InputNumbering& numbering_;
  const SceneInput input_;
  Scene held_scene_;
  SceneInput held_input_;
  Cloth cloth_;
  std::optional<MovingBody> body_, held_body_;
  std::optional<Progress> progress_;
  std::string which_;
  const std::atomic<bool>& interrupted_;
};

ResewnPose compared(const std::string& name, const Positions& a, const Positions& b) {
  const Eigen::VectorXd distance = (a - b).rowwise().norm();
  return {name, std::sqrt(distance.squaredNorm() / static_cast<double>(distance.size())), distance.maxCoeff()};
}

double clothArea(const FlatPattern& pattern) {
  double area = 0.0;
  for (const Mat2& edges : sewnEdges(pattern)) area += 0.5 * edges.determinant();
  return area;
}

/// Weights of cloth that is too large (flattening.h): little where triangles grew and around them.
void loosen(const Triangles& triangles, const std::vector<Mat2>& before, const std::vector<Mat2>& grown,
            std::vector<double>& excess) {
  std::vector<char> is_loose(before.size(), 0);
  for (size_t t = 0; t < before.size(); ++t) is_loose[t] = !grown[t].isApprox(before[t], 1e-9);
  for (int ring = 0; ring < kFollowing; ++ring) {
    std::vector<char> touched(triangles.maxCoeff() + 1, 0);
    for (size_t t = 0; t < is_loose.size(); ++t)
      for (int k = 0; is_loose[t] && k < 3; ++k) touched[triangles(static_cast<int>(t), k)] = 1;
    for (size_t t = 0; t < is_loose.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (touched[triangles(static_cast<int>(t), k)]) is_loose[t] = 1;
  }
  for (size_t t = 0; t < is_loose.size(); ++t)
    if (is_loose[t]) excess[t] = kExcess;
}

/// Compares what both garments did.
void compare(const Scene& scene, const SceneInput& input, const FlatPattern& pattern, const Replayed& designed,
             const Replayed& sewn, Resewn& result) {
  if (sewn.own.rows() > 0) result.own = compared(input.pose_names.front(), designed.own, sewn.own);
  result.poses.clear();
  for (size_t k = 0; k < sewn.poses.size(); ++k)
    result.poses.push_back(
        compared(scene.body ? input.pose_names[sewn.numbers[k]] : "end", designed.poses[k], sewn.poses[k]));
  result.seams.clear();
  for (const CutLine& line : pattern.lines) {
    ResewnSeam seam{line.seam.name, 0.0};
    for (size_t k = 0; k < sewn.poses.size(); ++k) {
      double sum = 0.0;
      for (const int v : line.seam.vertices) sum += (designed.poses[k].row(v) - sewn.poses[k].row(v)).squaredNorm();
      seam.rms_m = std::max(seam.rms_m, std::sqrt(sum / static_cast<double>(line.seam.vertices.size())));
    }
    result.seams.push_back(seam);
  }
  result.designed_over_limit = designed.over_limit;
  result.over_limit = sewn.over_limit;
  result.designed_end = designed.poses.back();
  result.sewn_end = sewn.poses.back();
}

/// Whether a piece that could be cut before overlaps itself or has become too wide for the cloth.
bool spoilsPiece(const FlatPattern& before, const FlatPattern& after, double widest) {
  const std::vector<double> was = widthsAcross(before), is = widthsAcross(after);
  for (size_t p = 0; p < after.pieces.size(); ++p) {
    if (after.pieces[p].crosses_itself && !before.pieces[p].crosses_itself) return true;
    if (is[p] > std::max(widest, was[p] + 1e-6)) return true;
  }
  return false;
}

/// Why letting out has ended.
std::string endOfLettingOut(int asked, int rounds, bool asks) {
  if (asked == 0) return "let_out = 0, they are not let out";
  const std::string made = counted(rounds, "round") + " of letting out did not mend it";
  if (!asks) return made + ", and no triangle asks for more cloth";
  if (rounds < asked) return made + ", since a piece would overlap itself or be wider than the cloth";
  return asked < kMaxLetOut ? made + ", raise [pattern] let_out" : made;
}

}  // namespace

Resewn sewAgain(const Scene& scene, const SceneInput& input, const RestShape& designed, const FlatSettings& settings,
                const std::atomic<bool>& interrupted, FlatPattern& pattern) {
  Resewn result;
  const auto begin = std::chrono::steady_clock::now();
  const auto wall = [&] { return secondsSince(begin); };
  const InputNumbering numbering = spatialNumbering(input);
  Replay replay(scene, input, numbering, interrupted);
  const auto numbered = [&](const std::vector<Mat2>& edges) {
    return RestShape{renumbered(designed.positions, numbering.garment.vertices),
                     renumbered(edges, numbering.garment.triangles)};
  };
  const Replayed as_designed = replay.simulate(numbered(designed.edges), nullptr, "designed garment");
  result.has_limit = scene.adaption.has_value();
  GrowthDemand demand(kLetOut * shownLimit(scene));
  Replayed as_sewn =
      replay.simulate(numbered(sewnEdges(pattern)), result.has_limit ? &demand : nullptr, "sewn garment");
  compare(scene, input, pattern, as_designed, as_sewn, result);
  result.wall_s = wall();
  if (!result.has_limit) return result;
  const double wanted = std::max(scene.adaption->fit.target, as_designed.over_limit);
  const double first_area = clothArea(pattern);
  std::vector<double> excess(designed.edges.size(), settings.woven.excess);
  FlatPattern trial = pattern;
  int round = 1;
  bool asks = true;  // some triangle for more cloth
  for (; round <= scene.pattern.let_out && as_sewn.over_limit > wanted; ++round) {
    replay.cloth().setRest(numbered(sewnEdges(trial)));
    asks = demand.letOut(replay.cloth());
    if (!asks) break;
    const std::vector<Mat2> grown = restored(replay.cloth().restEdges(), numbering.garment.triangles);
    loosen(input.garment.triangles, sewnEdges(trial), grown, excess);
    trial = flattenAgain(trial, grown, settings, excess);
    as_sewn = replay.simulate(numbered(sewnEdges(trial)), &demand, fmt::format("let out {}", counted(round, "time")));
    if (as_sewn.over_limit >= result.over_limit || spoilsPiece(pattern, trial, settings.widest)) continue;
    pattern = trial;
    compare(scene, input, pattern, as_designed, as_sewn, result);
    result.rounds = round;
  }
  if (result.over_limit > as_designed.over_limit + kMoreOverLimit)
    pattern.warnings.push_back(
        fmt::format("the sewn garment is over the limit on {:.2f} % of the triangles, the designed one on {:.2f} %: "
                    "{}; add a [[garment.seam]]",
                    100 * result.over_limit, 100 * as_designed.over_limit,
                    endOfLettingOut(scene.pattern.let_out, round - 1, asks)));
  result.area_ratio = clothArea(pattern) / first_area;
  result.wall_s = wall();
  return result;
}

}  // namespace ease
