// Coulomb friction against what it does to a block and to a rope.
//
//   mu      coefficient of friction        theta   angle of an incline
//   v_s     slip speed, m/s: the force of friction on a sample that moves at the speed v is mu lambda f1(v), with
//           f1 = 2 v/v_s - (v/v_s)^2 below v_s and 1 above (energy/friction.h)
//
// What the smoothing contributes: cloth that should stick creeps at the speed below v_s at which friction holds the
// load.  Where cloth slides, it contributes nothing.
#include <catch2/catch.hpp>
#include <numbers>

#include "tests/accuracy/equilibrium.h"
#include "tests/accuracy/meshes.h"

using namespace ease;

namespace {

constexpr double kGravity = 9.81;  // m/s^2

const std::vector<Method> kMethods = {Method::bw1, Method::newton, Method::pd, Method::pd_lbfgs, Method::automatic};

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
  CHECK(sheet.speed() == Approx(creep).epsilon(0.01));
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
  CHECK((sheet.speed() - before) / seconds == Approx(expected).epsilon(0.01));
}

TEST_CASE("a moving belt takes a sheet along with mu g until both are equally fast") {
  const Method method = GENERATE(from_range(kMethods));
  const double mu = 0.3, belt = 2.0;
  SheetOnIncline sheet(0.0, mu, method, belt);
  sheet.run(0.1);
  const double before = sheet.speed();
  sheet.run(0.2);
  INFO(nameOf(method) << ": " << (sheet.speed() - before) / 0.2 / (mu * kGravity) - 1.0);
  CHECK((sheet.speed() - before) / 0.2 == Approx(mu * kGravity).epsilon(0.01));
  sheet.run(1.0);
  CHECK(sheet.speed() == Approx(belt).epsilon(1e-3));
}
