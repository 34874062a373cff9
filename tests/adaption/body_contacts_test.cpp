#include "adaption/body_contacts.h"

#include <catch2/catch.hpp>

#include "tests/collision/bodies.h"
#include "tests/sheet.h"

using namespace ease;

TEST_CASE("the body is where the parts of the time steps say, and cloth is as far from it as it is") {
  Schedule schedule;
  schedule.poses = 2;
  schedule.interpolation_steps = 2;
  schedule.steps_per_pose = 2;
  const Substeps substeps{3, 1};
  const TriangleMesh ball = bodies::sphere(0.1, 6);
  MovingBody body(ball.triangles, {ball.positions, bodies::moved(ball, Vec3(0.0, 0.04, 0.0)).positions}, 2,
                  LevelSetOptions{0.01, 0.05});
  const TriangleMesh sheet = bodies::moved(makeSheet(2, 2, 0.02, 0.02), Vec3(-0.01, 0.11, 0.0));
  const Cloth cloth(sheet, Vec3::UnitX(), Material());
  const std::vector<double> offsets(cloth.vertexCount(), 0.005);
  BodyContacts contacts(body, cloth, offsets, schedule, substeps, 0.01);
  const std::vector<Moment> moments = timeline(schedule);
  REQUIRE(moments.size() == 4);
  CHECK(contacts.bodyAt(StepsDone()) == 0.0);
  CHECK(contacts.bodyAt(moments[0], 3) == Approx(0.5));
  CHECK(contacts.bodyAt(moments[1], 1) == Approx(4.0 / 6.0));
  CHECK(contacts.bodyAt(moments[3].done) == Approx(2.0));

  contacts.prepareFirst(StepsDone(), sheet.positions);
  contacts.measure(0.0, sheet.positions);
  CHECK(contacts.distances()[1] == Approx(0.01).margin(1e-3));  // vertex (0, 0.11, 0) above the ball's top
  Penetration penetration;
  contacts.deepen(penetration);
  CHECK(penetration.vertices == 0.0);

  // In the first part of the first step the ball rises by a twelfth of its way, and so does what touches its top.
  const Positions lower = sheet.positions.rowwise() - Eigen::RowVector3d(0.0, 0.005, 0.0);
  const double part = contacts.bodyAt(moments[0], 1);
  Contacts found;
  contacts.find(part, lower, found, contacts.bodyAt(moments[0], 0));
  REQUIRE_FALSE(found.planes[1].normal.isZero());
  CHECK((found.motions[1] - Vec3(0.0, 0.04 / 12.0, 0.0)).norm() < 1e-6);
  contacts.find(part, lower, found);
  CHECK(found.motions.empty());
}
