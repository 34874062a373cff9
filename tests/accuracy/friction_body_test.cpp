// Friction between a taut tube of cloth and a body that is found by its level set, as in a run.
#include <catch2/catch.hpp>
#include <numbers>

#include "collision/moving_body.h"
#include "tests/accuracy/equilibrium.h"
#include "tests/collision/bodies.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

constexpr double kOffset = 0.005;  // m
constexpr int kAround = 48, kAlong = 12;

// Scales x and z of every vertex so that a radius of 0.1 m becomes 0.1 m + slope y.
void makeCone(double slope, Positions& x) {
  for (int i = 0; i < x.rows(); ++i)
    for (const int k : {0, 2}) x(i, k) *= 1.0 + slope * x(i, 1) / 0.1;
}

TriangleMesh cone(double slope) {
  TriangleMesh body = bodies::capsule(0.15, 0.1, 24);
  makeCone(slope, body.positions);
  return body;
}

TriangleMesh tubeOn(double slope) {
  TriangleMesh tube = makeTube(kAround, kAlong, 0.1 + kOffset, 0.12);
  tube.positions.col(1).array() -= 0.06;
  makeCone(slope, tube.positions);
  return tube;
}

// A tube, three per cent too tight, on a body that passes through these poses in `steps` time steps each.
class DressedBody {
 public:
  DressedBody(const TriangleMesh& body, const std::vector<Positions>& poses, int steps, const TriangleMesh& tube,
              double friction, Method method)
      : cloth_(tube, Vec3::UnitY(), Material()),
        body_(body.triangles, poses, steps, {}),
        step_(makeStep(cloth_, {method})),
        state_(atRest(tube.positions)),
        offsets_(cloth_.samples().count(), kOffset) {
    std::vector<Mat2> edges = cloth_.restEdges();
    for (Mat2& D : edges) D.row(1) /= 1.03;  // weft: around
    cloth_.setRest({cloth_.restPositions(), edges});
    options_.friction = friction;
  }

  void run(int steps) {
    std::vector<Vec3> samples;
    for (int end = taken_ + steps; taken_ < end;) {
      cloth_.samples().positions(state_.positions, samples);
      if (taken_ == 0) body_.prepare(0, samples);
      body_.prepare(++taken_, samples);
      step_.step(state_, options_, {}, [&](const Positions& x, Contacts& contacts) {
        cloth_.samples().positions(x, samples);
        const BodyMoment start = body_.at(taken_ - 1);
        finder_.find(body_.at(taken_), samples, offsets_, 0.01, contacts, options_.friction > 0.0 ? &start : nullptr);
      });
    }
  }

  double height() const { return state_.positions.col(1).mean(); }
  // Mean angle by which the tube has turned about the y axis from the positions `x`.
  double turnFrom(const Positions& x) const {
    double angle = 0.0;
    for (int i = 0; i < x.rows(); ++i) {
      const auto now = state_.positions.row(i);
      angle += std::atan2(x(i, 2) * now[0] - x(i, 0) * now[2], x(i, 0) * now[0] + x(i, 2) * now[2]);
    }
    return angle / static_cast<double>(x.rows());
  }
  const Positions& positions() const { return state_.positions; }

 private:
  Cloth cloth_;
  MovingBody body_;
  ContactFinder finder_;
  StepOptions options_;
  TimeStep step_;
  State state_;
  std::vector<double> offsets_;  // one a sample, m
  int taken_ = 0;                // time steps
};

}  // namespace

TEST_CASE("a tube stays with friction on a cone that narrows downwards, and slides off without") {
  const Method method = GENERATE(Method::bw1, Method::automatic);
  const double slope = 0.1;  // below the coefficient of friction
  const TriangleMesh body = cone(slope), tube = tubeOn(slope);
  const auto fall = [&](double friction) {
    DressedBody dressed(body, {body.positions}, 1, tube, friction, method);
    dressed.run(40);
    return -dressed.height();
  };
  const double with = fall(0.3), without = fall(0.0);
  INFO(nameOf(method) << ": falls by " << with << " m with friction, " << without << " m without");
  CHECK(with < 1e-3);
  CHECK(without > 0.1);
}

TEST_CASE("a cylinder that turns takes a taut tube with it, and leaves it behind without friction") {
  const Method method = GENERATE(Method::bw1, Method::automatic);
  const double turn = 0.5;  // rad, in 40 steps of 2.5 ms: the surface moves at half a metre per second
  const TriangleMesh body = cone(0.0), tube = tubeOn(0.0);
  const Mat3 rotation = Eigen::AngleAxisd(turn, Vec3::UnitY()).toRotationMatrix();
  const std::vector<Positions> poses = {body.positions, body.positions * rotation.transpose()};
  DressedBody rough(body, poses, 40, tube, 0.3, method), smooth(body, poses, 40, tube, 0.0, method);
  rough.run(10);
  const Positions before = rough.positions();
  rough.run(30);
  smooth.run(40);
  INFO(nameOf(method) << ": " << rough.turnFrom(before) / (0.75 * turn) - 1.0 << ", without friction "
                      << smooth.turnFrom(tube.positions) << " rad");
  CHECK(rough.turnFrom(before) == Approx(0.75 * turn).epsilon(0.01));
  CHECK(std::abs(smooth.turnFrom(tube.positions)) < 0.1 * turn);
}
