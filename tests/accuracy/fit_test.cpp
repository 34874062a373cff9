// Rest shapes fitted in passes (adaption/fit.h) to bodies that tell what they must be: a tube's circumference C on a
// body of circumference C1 lies between C1/(1 + delta) and C1/(1 + goal).
#include <catch2/catch.hpp>

#include "adaption/fit.h"
#include "apps/scene_run.h"
#include "tests/accuracy/tube.h"

using namespace ease;

namespace {

std::vector<TriangleMesh> cylinders(const std::vector<double>& radii) {
  std::vector<TriangleMesh> all;
  for (const double radius : radii) all.push_back(cylinder(radius));
  return all;
}

double coneRadius(double y) {  // m, around the tube
  return 0.0925 + 0.125 * y;
}

// The cylinder's triangles on a cone.
TriangleMesh cone() {
  TriangleMesh body = cylinder(1.0);
  for (Eigen::Index v = 0; v < body.positions.rows(); ++v) {
    const double radius = coneRadius(body.positions(v, 1));
    body.positions(v, 0) *= radius;
    body.positions(v, 2) *= radius;
  }
  return body;
}

/// A tube on these bodies in turn, without gravity, to be fitted in passes.
struct TubeFit {
  Scene scene;
  SceneInput input;
  std::optional<MovingBody> body;
  RunInput run_input;
  RunSettings settings;

  explicit TubeFit(const std::vector<TriangleMesh>& poses) {
    for (const TriangleMesh& pose : poses) {
      input.poses.push_back(pose.positions);
      input.body_triangles = pose.triangles;
    }
    input.pose_names.assign(poses.size(), "body");
    input.garment = tubeOn(0.08);
    input.offsets.assign(input.garment.positions.rows(), CollisionScene().offset);
    scene.body.emplace();
    scene.body->poses = input.pose_names;
    scene.body->steps = 24;
    scene.solver.time_step = 0.0125;
    scene.solver.steps_per_pose = 1;
    scene.solver.gravity.setZero();
    scene.adaption.emplace();
    scene.adaption->every = 2;
    body.emplace(movingBody(scene, input));
    run_input = runInput(scene, input, &*body);
    settings = runSettings(scene, adaptingSchedule(scene));
  }

  Cloth cloth() const { return Cloth(input.garment, Vec3::UnitY(), scene.material); }
  Fit fit(Cloth& cloth) const { return Fit(settings, scene.adaption->fit, run_input, cloth); }
};

}  // namespace

TEST_CASE("fitted in passes, a tube has one rest shape whatever order it meets two cylinders in, and keeps the limit") {
  const double thickest = 2.0 * M_PI * (0.1 + kTubeOffset);
  std::vector<std::vector<Mat2>> fitted;
  for (const bool thick_first : {true, false}) {
    const TubeFit tube(cylinders(thick_first ? std::vector{0.08, 0.1, 0.09} : std::vector{0.08, 0.09, 0.1}));
    const double limit = tube.scene.adaption->limit;
    Cloth cloth = tube.cloth();
    Fit fit = tube.fit(cloth);
    FitState after_first;
    FitWatch watch;
    watch.on_pass = [&](const FitState& state) {
      if (state.passes.size() == 1) after_first = state;
    };
    fit.run(watch);
    CHECK(fit.result().target_met);
    CHECK(fit.result().check.stretch.overall.max < 1.0 + limit);
    CHECK(fit.result().embedding.p99 < 0.01);
    const double around = restCircumferences(cloth)[kTubeAlong / 2];
    CHECK(around > thickest / (1.0 + limit));
    CHECK(around < 1.005 * thickest / (1.0 + kGoal * limit));
    fitted.push_back(cloth.restEdges());

    Cloth later = tube.cloth();
    Fit resumed = tube.fit(later);
    resumed.resume(after_first, true);
    resumed.run({});
    CHECK(later.restEdges() == cloth.restEdges());
    CHECK(resumed.state().passes.size() == fit.state().passes.size());
  }
  double sum = 0.0;
  for (size_t t = 0; t < fitted[0].size(); ++t)
    sum += std::pow(fitted[0][t].col(1).norm() / fitted[1][t].col(1).norm() - 1.0, 2);
  CHECK(std::sqrt(sum / static_cast<double>(fitted[0].size())) < 0.01);
}

TEST_CASE("fitted to a cone, each ring of a tube is as long as the cone there asks for") {
  TubeFit tube({cylinder(0.08), cone()});
  tube.settings.friction = 0.3;  // otherwise the tube slides to the thin end
  const double limit = tube.scene.adaption->limit;
  Cloth cloth = tube.cloth();
  const std::vector<double> first = restCircumferences(cloth);
  Fit fit = tube.fit(cloth);
  fit.run({});
  CHECK(fit.result().target_met);
  const std::vector<double> rest = restCircumferences(cloth);
  for (int ring = 1; ring < kTubeAlong; ++ring) {
    const double needed = 2.0 * M_PI * (coneRadius(-0.06 + 0.01 * ring) + kTubeOffset);
    INFO("ring " << ring);
    CHECK(rest[ring] > 0.99 * needed / (1.0 + limit));
    CHECK(rest[ring] < 1.02 * std::max(first[ring], needed / (1.0 + kGoal * limit)));
  }
}

TEST_CASE("a tube that no cylinder stretches keeps its rest shape to the last bit, after one pass and the check") {
  const TubeFit tube(cylinders({0.08, 0.079}));
  Cloth cloth = tube.cloth();
  Fit fit = tube.fit(cloth);
  fit.run({});
  CHECK(fit.state().passes.size() == 1);
  CHECK(fit.result().target_met);
  CHECK(cloth.restEdges() == cloth.first().edges);
  CHECK(cloth.restPositions() == cloth.first().positions);
}

TEST_CASE("a fit that is interrupted leaves a rest shape that is embedded, and no result") {
  const TubeFit tube(cylinders({0.08, 0.1}));
  Cloth cloth = tube.cloth();
  Fit fit = tube.fit(cloth);
  std::atomic<bool> interrupted = false;
  FitWatch watch;
  watch.interrupted = &interrupted;
  watch.on_pass = [&](const FitState&) { interrupted = true; };
  fit.run(watch);
  CHECK(fit.state().passes.size() == 1);
  CHECK(fit.result().reason.empty());
  CHECK(cloth.restEdges() == fit.state().next_rest);
  CHECK(metricError(cloth, cloth.restPositions()).p99 < 0.01);
}

TEST_CASE("passes are solved to twice the tolerance until less than a hundredth of the triangles is over the limit") {
  std::vector<FitPass> passes;
  CHECK(toleranceOfPass(passes, 0.2) == 0.4);
  passes.resize(1);
  passes.back().record.stretch.overall.share_over_limit = 0.3;
  CHECK(toleranceOfPass(passes, 0.2) == 0.4);
  passes.back().record.stretch.overall.share_over_limit = 0.002;
  CHECK(toleranceOfPass(passes, 0.2) == 0.2);
}
