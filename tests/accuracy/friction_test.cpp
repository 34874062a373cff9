// Coulomb friction against what it does to a block and to a rope.
//
//   mu      coefficient of friction        theta   angle of an incline
//   v_s     slip speed, m/s: the force of friction on a sample that moves at the speed v is mu lambda f1(v), with
//           f1 = 2 v/v_s - (v/v_s)^2 below v_s and 1 above (energy/friction.h)
//
// What the smoothing contributes: cloth that should stick creeps at the speed below v_s at which friction holds the
// load.  Where cloth slides faster than v_s, it contributes nothing.
#include <catch2/catch.hpp>
#include <numbers>

#include "tests/accuracy/equilibrium.h"
#include "tests/accuracy/meshes.h"

using namespace ease;

namespace {

constexpr double kGravity = 9.81;  // m/s^2

const std::vector<Method> kMethods = {Method::bw1, Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic};

// Relative error of an acceleration.  `bw1` takes a single iteration with a quadratic bound of friction's potential,
// which is stiffer than the potential itself: it moves a sheet that slides with the speed v less by mu g cos(theta)
// h/v.
double tolerance(Method method) {
  return method == Method::bw1 ? 0.01 : 1e-4;
}

// An incline about the x axis: the unit direction down the slope, and the unit normal.
struct Incline {
  explicit Incline(double degrees) : theta(degrees * std::numbers::pi / 180.0) {}
  double theta;
  Vec3 down() const { return {0.0, -std::sin(theta), std::cos(theta)}; }
  Vec3 normal() const { return {0.0, std::cos(theta), std::sin(theta)}; }
};

// A sheet that lies on an incline, pressed in by as much as its weight takes.
class SheetOnIncline {
 public:
  // `belt_speed`: of the incline's surface, downwards, m/s.
  SheetOnIncline(double degrees, double mu, Method method, double belt_speed = 0.0)
      : incline_(degrees),
        mesh_(lying(incline_)),
        cloth_(mesh_, Vec3::UnitX(), Material()),
        step_(makeStep(cloth_, {method, 1e-4, 1e-5, 300})),
        state_(atRest(mesh_.positions)),
        belt_speed_(belt_speed) {
    options_.friction = mu;
    // Contact as soft as inertia in a step: `pd` otherwise needs thousands of iterations to move the cloth at all.
    options_.contact_stiffness = 3e3;
    const double depth = cloth_.material().density * kGravity * std::cos(incline_.theta) / options_.contact_stiffness;
    state_.positions.rowwise() -= depth * incline_.normal().transpose();
  }

  void run(double seconds) {
    const FindContacts contacts = [&](const Positions&, Contacts& found) {
      found.planes.assign(cloth_.samples().count(), {incline_.normal(), 0.0, 1.0});
      found.motions.assign(found.planes.size(), options_.h * belt_speed_ * incline_.down());
    };
    for (int n = 0; n < std::lround(seconds / options_.h); ++n) step_.step(state_, options_, {}, contacts);
  }

  // Mean speed down the slope, m/s.
  double speed() const { return Vec3(state_.velocities.colwise().mean()).dot(incline_.down()); }

 private:
  static TriangleMesh lying(const Incline& incline) {
    TriangleMesh sheet = makeGrid(4, 4, 0.1, 0.1);
    for (int i = 0; i < sheet.positions.rows(); ++i) {
      const Vec3 flat = sheet.positions.row(i);
      sheet.positions.row(i) = flat[0] * Vec3::UnitX() + flat[1] * incline.down();
    }
    return sheet;
  }

  Incline incline_;
  TriangleMesh mesh_;
  Cloth cloth_;
  StepOptions options_;
  TimeStep step_;
  State state_;
  double belt_speed_;
};

}  // namespace

TEST_CASE("below the angle of friction a sheet holds, but for the creep that the smoothing costs") {
  const Method method = GENERATE(from_range(kMethods));
  const double mu = 0.5, degrees = 20.0;
  SheetOnIncline sheet(degrees, mu, method);
  sheet.run(0.1);
  const double share = std::tan(degrees * std::numbers::pi / 180.0) / mu;  // of Coulomb's force that must act
  const double creep = kSlipSpeed * (1.0 - std::sqrt(1.0 - share));
  INFO(nameOf(method) << ": " << sheet.speed() / creep - 1.0);
  CHECK(sheet.speed() < kSlipSpeed);
  CHECK(sheet.speed() == Approx(creep).epsilon(1e-4));
}

TEST_CASE("above the angle of friction a sheet slides with g (sin theta - mu cos theta)") {
  const Method method = GENERATE(from_range(kMethods));
  const double mu = 0.3, degrees = 30.0;
  SheetOnIncline sheet(degrees, mu, method);
  sheet.run(0.5);
  const double before = sheet.speed(), seconds = 0.5;
  sheet.run(seconds);
  const double theta = degrees * std::numbers::pi / 180.0;
  const double expected = kGravity * (std::sin(theta) - mu * std::cos(theta));
  INFO(nameOf(method) << ": " << (sheet.speed() - before) / seconds / expected - 1.0);
  CHECK((sheet.speed() - before) / seconds == Approx(expected).epsilon(tolerance(method)));
}

TEST_CASE("a moving belt takes a sheet along with mu g until both are equally fast") {
  const Method method = GENERATE(from_range(kMethods));
  const double mu = 0.3, belt = 2.0;
  SheetOnIncline sheet(0.0, mu, method, belt);
  sheet.run(0.1);
  const double before = sheet.speed();
  sheet.run(0.2);
  INFO(nameOf(method) << ": " << (sheet.speed() - before) / 0.2 / (mu * kGravity) - 1.0);
  CHECK((sheet.speed() - before) / 0.2 == Approx(mu * kGravity).epsilon(tolerance(method)));
  sheet.run(1.0);
  CHECK(sheet.speed() == Approx(belt).epsilon(1e-3));
}

namespace {

// A cylinder about the y axis at which cloth is in contact wherever it is near; it stands still.
class StillCylinder {
 public:
  StillCylinder(const Cloth& cloth, double radius) : cloth_(cloth), radius_(radius) {}

  FindContacts contacts() {
    return [this](const Positions& x, Contacts& found) {
      cloth_.samples().positions(x, samples_);
      found.planes.assign(samples_.size(), {});
      for (size_t s = 0; s < samples_.size(); ++s) {
        const Vec3 away(samples_[s][0], 0.0, samples_[s][2]);
        if (away.norm() > radius_ + 0.005) continue;
        found.planes[s] = {away.normalized(), radius_, 2e-3};
      }
    };
  }

 private:
  const Cloth& cloth_;
  double radius_;
  std::vector<Vec3> samples_;
};

// A band in the xz plane, `width` wide along y, half around a cylinder about the y axis, with straight legs along -x.
// Vertex (i, j) is j (n + 1) + i: i along the band, j across.
struct Band {
  double radius = 0.1, leg = 0.06, width = 0.02;  // m
  int along = 120, across = 1;
  double length() const { return 2.0 * leg + std::numbers::pi * radius; }

  // The point at the distance s along the band, and the direction in which s grows.
  Vec3 point(double s) const {
    const double angle = (s - leg) / radius;
    if (angle < 0.0) return {s - leg, 0.0, -radius};
    if (angle > std::numbers::pi) return {-(angle - std::numbers::pi) * radius, 0.0, radius};
    return {radius * std::sin(angle), 0.0, -radius * std::cos(angle)};
  }
  TriangleMesh mesh() const {
    TriangleMesh band = makeGrid(along, across, length(), width);
    for (int i = 0; i < band.positions.rows(); ++i) {
      const double y = band.positions(i, 1);
      band.positions.row(i) = point(band.positions(i, 0)) + y * Vec3::UnitY();
    }
    return band;
  }
};

}  // namespace

TEST_CASE("a band dragged over a cylinder is pulled e^(mu phi) times as hard at one end as at the other") {
  // Both ends move at the same speed, 200 times the slip speed, so that the whole band slides and the smoothing
  // contributes nothing.  phi is the angle by which the band turns, between the pulls at its two ends.
  const Method method = GENERATE(from_range(kMethods));
  const double mu = 0.3, drag = 0.2;  // m/s
  const Band band;
  const TriangleMesh mesh = band.mesh();
  Material material;
  material.stretch_warp = 800.0;
  material.shear = 20.0;
  Cloth cloth(mesh, Vec3::UnitX(), material);
  // The rest lengths of the whole band are shorter, so that it is taut at the start.
  std::vector<Mat2> edges = cloth.restEdges();
  for (Mat2& D : edges) D /= 1.04;
  cloth.setRest({cloth.restPositions() / 1.04, edges});

  StepOptions options;
  options.gravity.setZero();
  options.friction = mu;
  options.contact_stiffness = 3e6;
  TimeStep step = makeStep(cloth, {method, 1e-3, 1e-2, 300});
  StillCylinder cylinder(cloth, band.radius);
  State state = atRest(mesh.positions);
  const auto end = [&](int i) { return i % (band.along + 1) == 0 ? 0 : i % (band.along + 1) == band.along ? 1 : -1; };
  Pins pins = pinsWhere(mesh.positions, [&](int i) { return end(i) >= 0; });
  for (int n = 1; n <= 80; ++n) {
    for (size_t k = 0; k < pins.vertices.size(); ++k)
      pins.positions[k] += options.h * drag * (end(pins.vertices[k]) == 0 ? 1.0 : -1.0) * Vec3::UnitX();
    step.step(state, options, pins, cylinder.contacts());
  }

  const Positions forces = internalForces(cloth, state.positions);
  Vec3 pull[2] = {Vec3::Zero(), Vec3::Zero()};
  for (const int v : pins.vertices) pull[end(v)] += forces.row(v);
  const double phi = std::numbers::pi - std::acos(pull[0].normalized().dot(pull[1].normalized()));
  REQUIRE(phi == Approx(std::numbers::pi).epsilon(0.01));
  const double ratio = pull[1].norm() / pull[0].norm();
  INFO(nameOf(method) << ": " << ratio / std::exp(mu * phi) - 1.0);
  CHECK(ratio == Approx(std::exp(mu * phi)).epsilon(5e-3));
}
