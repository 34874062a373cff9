#include "collision/body/mannequin.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "collision/body/mannequin_shape.h"
#include "collision/body_self_overlap.h"
#include "collision/triangle_tree.h"
#include "solver/base/error.h"
#include "solver/mesh/topology.h"
#include "tests/collision/bodies.h"

using namespace ease;
using namespace ease::bodies;

namespace {

/// The vertex at the tip of the left hand in the T-pose.
int leftHand() {
  int hand;
  mannequin("t").positions.col(0).maxCoeff(&hand);
  return hand;
}

}  // namespace

TEST_CASE("the mannequin is one closed surface that encloses a person's volume in every pose") {
  for (const std::string& pose : mannequinPoses()) {
    INFO(pose);
    const TriangleMesh body = mannequin(pose);
    const Topology topology = buildTopology(body, pose);
    CHECK(topology.boundary_loops.empty());
    CHECK(body.positions.rows() - static_cast<long>(topology.edges.size()) + body.triangles.rows() == 2);
    CHECK(volume(body) > 0.05);
    CHECK(volume(body) < 0.09);
  }
}

TEST_CASE("the mannequin stands on the ground, 1.70 m tall, with 8 to 14 thousand vertices") {
  const TriangleMesh body = mannequin("t");
  CHECK(std::abs(body.positions.col(1).minCoeff()) < 0.001);
  CHECK(body.positions.col(1).maxCoeff() == Approx(1.70).margin(0.01));
  CHECK(body.positions.rows() > 8000);
  CHECK(body.positions.rows() < 14000);
}

TEST_CASE("the mannequin's left is the mirror image of its right") {
  for (const std::string& pose : mannequinPoses()) {
    INFO(pose);
    const Positions x = mannequin(pose).positions;
    CHECK(x.col(0).maxCoeff() == Approx(-x.col(0).minCoeff()).margin(0.003));
  }
  for (const Vec3& x : {Vec3(0.21, 1.30, 0.03), Vec3(0.05, 0.80, -0.1), Vec3(0.7, 1.4, 0.05)}) {
    const Distance left = mannequinDistance(x), right = mannequinDistance({-x.x(), x.y(), x.z()});
    CHECK(left.value == right.value);
    CHECK(left.gradient.x() == -right.gradient.x());
    CHECK(left.gradient.y() == right.gradient.y());
  }
}

TEST_CASE("no pose of the mannequin passes through itself") {
  for (const std::string& pose : mannequinPoses()) {
    INFO(pose);
    const TriangleMesh body = mannequin(pose);
    const TriangleTree tree(body.positions, body.triangles);
    const std::vector<unsigned char> asked(body.triangles.rows(), 1);
    BodySelfOverlap overlap;
    overlap.find(tree, asked);
    CHECK(overlap.crossing() == 0);
    CHECK(overlap.buried() == 0);
  }
}

TEST_CASE("triangles are well shaped in every pose") {
  CHECK(smallestAngle(mannequin("t")) > 20.0);
  for (const std::string& pose : mannequinPoses()) {
    INFO(pose);
    CHECK(smallestAngle(mannequin(pose)) > 12.0);
  }
}

TEST_CASE("all poses have the same triangles, and edges that stretch moderately") {
  const TriangleMesh rest = mannequin("t");
  const Topology topology = buildTopology(rest, "t");
  for (const std::string& pose : mannequinPoses()) {
    INFO(pose);
    const TriangleMesh body = mannequin(pose);
    REQUIRE(body.triangles == rest.triangles);
    double shortest = 1.0, longest = 1.0;
    for (const Edge& edge : topology.edges) {
      const auto length = [&](const Positions& x) { return (x.row(edge.vertex[0]) - x.row(edge.vertex[1])).norm(); };
      const double ratio = length(body.positions) / length(rest.positions);
      shortest = std::min(shortest, ratio);
      longest = std::max(longest, ratio);
    }
    CHECK(shortest > 0.4);
    CHECK(longest < 2.5);
    CHECK((pose == "t" || longest > 1.2));
  }
}

TEST_CASE("only the arms and what is near them move from pose to pose") {
  const Positions rest = mannequin("t").positions;
  for (const std::string& pose : mannequinPoses()) {
    INFO(pose);
    const Positions x = mannequin(pose).positions;
    double furthest = 0.0;
    for (int v = 0; v < rest.rows(); ++v) {
      const bool is_head = rest(v, 1) > 1.56, is_leg = rest(v, 1) < 1.0;
      if (is_head || is_leg) furthest = std::max(furthest, (x.row(v) - rest.row(v)).norm());
    }
    CHECK(furthest < 1e-12);
  }
}

TEST_CASE("each pose puts the left hand where its name says") {
  const int hand = leftHand();
  const auto direction = [&](const std::string& pose) {
    return Vec3(Vec3(mannequin(pose).positions.row(hand)) - mannequin_joints::kShoulder);
  };
  CHECK(direction("t").normalized().x() > 0.99);

  const Vec3 a = direction("a");
  CHECK(std::atan2(-a.y(), a.x()) * 180.0 / M_PI == Approx(45.0).margin(8.0));

  const Vec3 up = direction("up");
  CHECK(up.x() > 0.0);
  CHECK(std::atan2(up.y(), std::hypot(up.x(), up.z())) * 180.0 / M_PI == Approx(68.0).margin(8.0));

  const Vec3 front = direction("front");
  CHECK(front.normalized().z() > 0.98);
  CHECK(std::abs(front.y()) < 0.08);
}

TEST_CASE("an unknown pose is refused by name") {
  CHECK_THROWS_AS(mannequin("sitting"), InputError);
  CHECK_THROWS_WITH(mannequin("sitting"),
                    "the mannequin has no pose \"sitting\"; its poses are \"t\", \"a\", \"up\", \"front\"");
}
