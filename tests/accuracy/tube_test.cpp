// A taut tube of cloth around a cylinder.
//
//   s = C/C0   stretch around, of circumferences now and at rest      T = k (s - 1)   tension, N/m
//   p = T/R    contact pressure, Pa                                   R   radius of the cloth, m
//   delta      limit of adaption
#include <catch2/catch.hpp>

#include "adaption/clip.h"
#include "adaption/stitch.h"
#include "apps/scene_run.h"
#include "tests/accuracy/equilibrium.h"
#include "tests/accuracy/meshes.h"
#include "tests/collision/bodies.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

constexpr double kOffset = 0.005;  // m
constexpr int kAround = 48, kAlong = 12;

// A capsule about the y axis whose round ends are far from the cloth; the same triangles for every radius.
TriangleMesh cylinder(double radius) {
  TriangleMesh body = bodies::capsule(0.15, 0.1, 24);
  body.positions.col(0) *= radius / 0.1;
  body.positions.col(2) *= radius / 0.1;
  return body;
}

// A tube on a cylinder of this radius, from y = -0.06 m to 0.06 m.
TriangleMesh tubeOn(double radius) {
  TriangleMesh tube = makeTube(kAround, kAlong, radius + kOffset, 0.12);
  tube.positions.col(1).array() -= 0.06;
  return tube;
}

void shrinkAround(Cloth& cloth, double factor) {
  Positions rest = cloth.restPositions();
  rest.col(0) /= factor;
  rest.col(2) /= factor;
  std::vector<Mat2> edges = cloth.restEdges();
  for (Mat2& D : edges) D.row(1) /= factor;  // weft: around
  cloth.setRest({rest, edges});
}

// Lengths of all rings at rest: their weft edges.
std::vector<double> restCircumferences(const Cloth& cloth) {
  std::vector<double> lengths(kAlong, 0.0);
  for (int t = 0; t < cloth.triangleCount(); t += 2)  // a, a + around, b
    lengths[t / (2 * kAround)] += cloth.restEdges()[t].col(1).norm();
  return lengths;
}

double ringLength(const Positions& x, int ring) {
  double length = 0.0;
  for (int i = 0; i < kAround; ++i)
    length += (x.row(ring * kAround + i) - x.row(ring * kAround + (i + 1) % kAround)).norm();
  return length;
}

// A cylinder of one radius, and the cloth's contacts with it.
class Cylinder {
 public:
  Cylinder(const Cloth& cloth, const Positions& x, double radius)
      : cloth_(cloth), mesh_(cylinder(radius)), body_(mesh_.triangles, {mesh_.positions}, 1, {}) {
    cloth.samples().positions(x, samples_);
    body_.prepare(0, samples_);
  }

  FindContacts contacts() {
    return [this](const Positions& x, Contacts& contacts) {
      cloth_.samples().positions(x, samples_);
      finder_.find(body_.at(0.0), samples_, std::vector<double>(samples_.size(), kOffset), 0.01, contacts);
    };
  }

 private:
  const Cloth& cloth_;
  TriangleMesh mesh_;
  MovingBody body_;
  ContactFinder finder_;
  std::vector<Vec3> samples_;
};

// V diag(max(1, sigma_i/(1 + limit))) Vᵀ of every triangle; returns whether one is more than the identity.
bool clipAtLimit(const std::vector<Stretch>& stretch, double limit, std::vector<Mat2>& growth) {
  bool any = false;
  growth.assign(stretch.size(), Mat2::Identity());
  for (size_t t = 0; t < stretch.size(); ++t) {
    const auto& [sigma_1, sigma_2, warp, weft, direction] = stretch[t];
    const double g_1 = std::max(1.0, sigma_1 / (1.0 + limit)), g_2 = std::max(1.0, sigma_2 / (1.0 + limit));
    growth[t] = g_2 * Mat2::Identity() + (g_1 - g_2) * direction * direction.transpose();
    any = any || g_1 > 1.0 + 1e-4;
  }
  return any;
}

}  // namespace

TEST_CASE("a taut tube presses on a cylinder with its tension over the radius") {
  const Method method = GENERATE(Method::newton, Method::pd_lbfgs, Method::bw1);
  const double radius = 0.1, stretch = 1.1;
  const TriangleMesh mesh = tubeOn(radius);
  Material material;
  Cloth cloth(mesh, Vec3::UnitY(), material);
  shrinkAround(cloth, stretch);
  Cylinder body(cloth, mesh.positions, radius);
  State state = atRest(mesh.positions);
  TimeStep step = makeStep(cloth, {method, 1e-3, 1e-2});
  // At rest up to the contacts' planes, which are found anew in every step.
  REQUIRE(settle(step, state, {{0.0025, Vec3::Zero()}, {}, 2e-5, 100, {}, body.contacts()}));

  std::vector<double> pressure;
  step.potential().contactPressure(state.positions, pressure);
  double mean = 0.0, distance = 0.0, spread = 0.0;
  const int rings = kAlong - 3;  // not those near the open ends
  for (int j = 2; j < 2 + rings; ++j)
    for (int i = 0; i < kAround; ++i) {
      mean += pressure[j * kAround + i] / (rings * kAround);
      const Vec3 x = state.positions.row(j * kAround + i);
      distance += std::hypot(x[0], x[2]) / (rings * kAround);
    }
  for (int j = 2; j < 2 + rings; ++j)
    for (int i = 0; i < kAround; ++i) spread = std::max(spread, std::abs(pressure[j * kAround + i] / mean - 1.0));
  const double tension = material.stretch_weft * (distance / (radius + kOffset) * stretch - 1.0);
  CHECK(mean == Approx(tension / distance).epsilon(1e-3));
  CHECK(spread < 0.06);
}

TEST_CASE("clipped at the limit itself, a tube grows to the thickest cylinder's circumference over 1 + limit") {
  const Method method = GENERATE(Method::newton, Method::pd_lbfgs);
  const auto radii = GENERATE(std::vector<double>{0.1}, std::vector<double>{0.1, 0.09}, std::vector<double>{0.09, 0.1});
  const double limit = 0.1;
  Cloth cloth(tubeOn(0.08), Vec3::UnitY(), Material());
  Stitcher stitcher(cloth, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  TimeStep step = makeStep(cloth, {method, 1e-3, 1e-2});
  std::vector<Stretch> stretch;
  std::vector<Mat2> growth;
  double thickest = 0.0;  // circumference of the cloth as worn
  for (const double radius : radii) {
    State state = atRest(tubeOn(radius).positions);
    Cylinder body(cloth, state.positions, radius);
    bool grows = true;
    for (int round = 0; grows && round < 50; ++round) {
      settle(step, state, {{0.0025, Vec3::Zero()}, {}, 2e-5, 20, {}, body.contacts()});
      measureStretch(cloth, state.positions, stretch);
      grows = clipAtLimit(stretch, limit, growth);
      if (grows) stitcher.stitch(cloth, growth);
    }
    CHECK_FALSE(grows);
    thickest = std::max(thickest, ringLength(state.positions, kAlong / 2));
  }
  CHECK(restCircumferences(cloth)[kAlong / 2] == Approx(thickest / (1.0 + limit)).epsilon(5e-4));
  CHECK(thickest == Approx(2.0 * M_PI * (0.1 + kOffset)).epsilon(3e-3));  // pressed in a little, and of straight edges
}

TEST_CASE("a tube on a cylinder too thick for it adapts until it is within the limit, whatever came first") {
  const double limit = 0.1;
  std::vector<double> adapted;
  for (const bool thick_first : {true, false}) {
    SceneInput input;
    Scene scene;
    const std::vector<double> radii =
        thick_first ? std::vector<double>{0.08, 0.1, 0.09} : std::vector<double>{0.08, 0.09, 0.1};
    for (const double radius : radii) {
      input.poses.push_back(cylinder(radius).positions);
      input.body_triangles = cylinder(radius).triangles;
    }
    input.pose_names.assign(3, "cylinder");
    input.garment = tubeOn(0.08);
    input.offsets.assign(input.garment.positions.rows(), scene.collision.offset);
    scene.body.emplace();
    scene.body->poses = input.pose_names;
    scene.body->steps = 20;
    scene.solver.gravity.setZero();
    scene.adaption.emplace();
    scene.adaption->mode = AdaptionMode::sequential;
    scene.adaption->limit = limit;
    scene.adaption->every = 4;
    scene.adaption->settle = 80;
    Cloth cloth(input.garment, Vec3::UnitY(), scene.material);
    const double first = restCircumferences(cloth)[kAlong / 2];
    MovingBody body = movingBody(scene, input);
    const RunInput run_input = runInput(scene, input, &body);
    Run run(runSettings(scene, adaptingSchedule(scene)), run_input, cloth);
    run.run();
    adapted.push_back(restCircumferences(cloth)[kAlong / 2]);
    // Adaption acts above one stretch, less than 1 + limit, and lets out to another, less than that (StretchGoal).
    const double thickest = 2.0 * M_PI * (0.1 + kOffset);
    const StretchGoal goal = stretchGoal(limit, adapted.back() / first);
    CHECK(adapted.back() > thickest / (1.0 + limit));
    CHECK(adapted.back() > 0.995 * thickest / goal.act_above);
    CHECK(adapted.back() < 1.005 * thickest / goal.grow_to);
    CHECK(run.record().stretch.overall.max > 1.0 + 0.7 * limit);
  }
  CHECK(adapted[0] == Approx(adapted[1]).epsilon(0.01));
}

namespace {

/// A tube on cylinders of these radii in turn, without gravity, to be fitted in passes.
struct TubeFit {
  Scene scene;
  SceneInput input;
  std::optional<MovingBody> body;
  RunInput run_input;
  RunSettings settings;

  explicit TubeFit(const std::vector<double>& radii) {
    for (const double radius : radii) {
      input.poses.push_back(cylinder(radius).positions);
      input.body_triangles = cylinder(radius).triangles;
    }
    input.pose_names.assign(radii.size(), "cylinder");
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
  const double thickest = 2.0 * M_PI * (0.1 + kOffset);
  std::vector<std::vector<Mat2>> fitted;
  for (const bool thick_first : {true, false}) {
    const TubeFit tube(thick_first ? std::vector<double>{0.08, 0.1, 0.09} : std::vector<double>{0.08, 0.09, 0.1});
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
    const double around = restCircumferences(cloth)[kAlong / 2];
    CHECK(around > thickest / (1.0 + limit));
    CHECK(around < 1.005 * thickest / (1.0 + Margin().goal * limit));
    fitted.push_back(cloth.restEdges());

    Cloth later = tube.cloth();
    Fit resumed = tube.fit(later);
    resumed.resume(after_first);
    resumed.run({});
    CHECK(later.restEdges() == cloth.restEdges());
    CHECK(resumed.state().passes.size() == fit.state().passes.size());
  }
  double sum = 0.0;
  for (size_t t = 0; t < fitted[0].size(); ++t)
    sum += std::pow(fitted[0][t].col(1).norm() / fitted[1][t].col(1).norm() - 1.0, 2);
  CHECK(std::sqrt(sum / static_cast<double>(fitted[0].size())) < 0.01);
}

TEST_CASE("a tube that no cylinder stretches keeps its rest shape to the last bit, after one pass and the check") {
  const TubeFit tube({0.08, 0.079});
  Cloth cloth = tube.cloth();
  Fit fit = tube.fit(cloth);
  fit.run({});
  CHECK(fit.state().passes.size() == 1);
  CHECK(fit.result().target_met);
  CHECK(cloth.restEdges() == cloth.first().edges);
  CHECK(cloth.restPositions() == cloth.first().positions);
}

TEST_CASE("a fit that is interrupted leaves a rest shape that is embedded, and no result") {
  const TubeFit tube({0.08, 0.1});
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
