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
#include "tests/accuracy/tube.h"

using namespace ease;

namespace {

void shrinkAround(Cloth& cloth, double factor) {
  Positions rest = cloth.restPositions();
  rest.col(0) /= factor;
  rest.col(2) /= factor;
  std::vector<Mat2> edges = cloth.restEdges();
  for (Mat2& D : edges) D.row(1) /= factor;  // weft: around
  cloth.setRest({rest, edges});
}

double ringLength(const Positions& x, int ring) {
  double length = 0.0;
  for (int i = 0; i < kTubeAround; ++i)
    length += (x.row(ring * kTubeAround + i) - x.row(ring * kTubeAround + (i + 1) % kTubeAround)).norm();
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
      finder_.find(body_.at(0.0), samples_, std::vector<double>(samples_.size(), kTubeOffset), 0.01, contacts);
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
  const int rings = kTubeAlong - 3;  // not those near the open ends
  for (int j = 2; j < 2 + rings; ++j)
    for (int i = 0; i < kTubeAround; ++i) {
      mean += pressure[j * kTubeAround + i] / (rings * kTubeAround);
      const Vec3 x = state.positions.row(j * kTubeAround + i);
      distance += std::hypot(x[0], x[2]) / (rings * kTubeAround);
    }
  for (int j = 2; j < 2 + rings; ++j)
    for (int i = 0; i < kTubeAround; ++i)
      spread = std::max(spread, std::abs(pressure[j * kTubeAround + i] / mean - 1.0));
  const double tension = material.stretch_weft * (distance / (radius + kTubeOffset) * stretch - 1.0);
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
    thickest = std::max(thickest, ringLength(state.positions, kTubeAlong / 2));
  }
  CHECK(restCircumferences(cloth)[kTubeAlong / 2] == Approx(thickest / (1.0 + limit)).epsilon(5e-4));
  CHECK(thickest ==
        Approx(2.0 * M_PI * (0.1 + kTubeOffset)).epsilon(3e-3));  // pressed in a little, and of straight edges
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
    const double first = restCircumferences(cloth)[kTubeAlong / 2];
    MovingBody body = movingBody(scene, input);
    const RunInput run_input = runInput(scene, input, &body);
    Run run(runSettings(scene, adaptingSchedule(scene)), run_input, cloth);
    run.run();
    adapted.push_back(restCircumferences(cloth)[kTubeAlong / 2]);
    // Adaption acts above one stretch, less than 1 + limit, and lets out to another, less than that (StretchGoal).
    const double thickest = 2.0 * M_PI * (0.1 + kTubeOffset);
    const StretchGoal goal = stretchGoal(limit, adapted.back() / first);
    CHECK(adapted.back() > thickest / (1.0 + limit));
    CHECK(adapted.back() > 0.995 * thickest / goal.act_above);
    CHECK(adapted.back() < 1.005 * thickest / goal.grow_to);
    CHECK(run.record().stretch.overall.max > 1.0 + 0.7 * limit);
  }
  CHECK(adapted[0] == Approx(adapted[1]).epsilon(0.01));
}
