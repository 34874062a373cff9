// Friction as a term of the incremental potential.
#include <catch2/catch.hpp>
#include <numeric>

#include "solver/energy/friction.h"
#include "tests/differences.h"
#include "tests/sheet.h"
#include "tests/step/potential_scene.h"

using namespace ease;

namespace {

/// A light sheet on which friction acts, without contact forces: the planes lie below it, the normal forces are given.
/// The step lasts a second, so that the slip length is a millimetre; some samples slip by less and some by more.
struct RubbedScene {
  TriangleMesh mesh = makeSheet(6, 5, 0.12, 0.1, 0.2);
  Cloth cloth;
  IncrementalPotential potential;
  State start;
  StepOptions options;
  Contacts contacts;
  Positions x;

  RubbedScene() : cloth(mesh, Vec3::UnitX(), weightless()), potential(cloth) {
    options.h = 1.0;
    options.friction = 0.4;
    start = {mesh.positions, Positions::Zero(mesh.positions.rows(), 3)};
    x = mesh.positions + 8e-4 * randomPositions(cloth.vertexCount(), 3);
    const int count = cloth.samples().count();
    contacts.planes.resize(count);
    start.normal_forces.assign(2 * count, 0.0);
    for (int s = 0; s < count; s += 2) {
      contacts.planes[s] = {Vec3(0.1, 0.2 * std::sin(0.1 * s), 1.0).normalized(), -0.1};
      start.normal_forces[s] = s % 3 == 0 ? 0.0 : 0.02 + 0.01 * std::sin(s);
      if (s % 4 != 0) continue;
      contacts.seconds.push_back({s, {Vec3(0.8, 0.0, 0.6), -0.2, 2e-3}});
      start.normal_forces[count + s] = 0.01;
    }
    for (size_t k = 0; k < contacts.planes.size() + contacts.seconds.size(); ++k)
      contacts.motions.push_back(3e-4 * Vec3(std::sin(k), std::cos(k), 0.5));
    potential.begin(start, options);
    potential.setContacts(contacts, start.normal_forces);
  }

  static Material weightless() {
    Material material;
    material.density = 1.5e-10;
    material.stretch_warp = material.stretch_weft = material.shear = 0.0;
    return material;
  }
  double energy(const Positions& at) {
    Positions unused(x.rows(), 3);
    return potential.gradient(at, unused);
  }
  Positions gradient(const Positions& at) {
    Positions gradient(x.rows(), 3);
    potential.gradient(at, gradient);
    return gradient;
  }
  Positions timesHessian(HessianKind kind, const Positions& d) {
    BlockMatrix hessian(cloth.vertexCount(), cloth.topology().edges);
    potential.hessian(x, kind, hessian);
    Positions product(x.rows(), 3);
    hessian.multiply(d, product);
    return product;
  }
};

}  // namespace

TEST_CASE("friction's gradient and Hessian are derivatives of the potential") {
  RubbedScene scene;
  const Positions gradient = scene.gradient(scene.x);
  REQUIRE(gradient.norm() > 1e-3);
  for (unsigned seed = 10; seed < 14; ++seed) {
    const Positions d = randomPositions(static_cast<int>(scene.x.rows()), seed);
    const auto energy = [&](double e) { return scene.energy(scene.x + e * d); };
    const auto force = [&](double e) { return scene.gradient(scene.x + e * d); };
    CHECK(sharpDifference(energy, 2e-6) == Approx(gradient.cwiseProduct(d).sum()).epsilon(1e-6));
    const Positions expected = sharpDifference(force, 2e-6);
    CHECK((scene.timesHessian(HessianKind::exact, d) - expected).norm() < 1e-4 * expected.norm());
  }
}

TEST_CASE("friction's potential is the sum over the samples' planes") {
  RubbedScene scene;
  std::vector<Vec3> from, to;
  scene.cloth.samples().positions(scene.start.positions, from);
  scene.cloth.samples().positions(scene.x, to);
  const double e = kSlipSpeed * scene.options.h;
  const size_t count = from.size();
  double expected = 0.0;
  int below = 0, above = 0;
  const auto add = [&](int s, const Vec3& normal, double force, const Vec3& motion) {
    const Vec3 d = to[s] - from[s] - motion;
    const double y = (d - normal * normal.dot(d)).norm();
    if (force > 0.0) ++(y < e ? below : above);
    expected += scene.options.friction * force * frictionPotential(y, e);
  };
  for (size_t s = 0; s < count; ++s)
    add(s, scene.contacts.planes[s].normal, scene.start.normal_forces[s], scene.contacts.motions[s]);
  for (size_t k = 0; k < scene.contacts.seconds.size(); ++k) {
    const Contacts::Second& second = scene.contacts.seconds[k];
    add(second.sample, second.plane.normal, scene.start.normal_forces[count + second.sample],
        scene.contacts.motions[count + k]);
  }
  REQUIRE(below > 5);
  REQUIRE(above > 5);
  // A plane that does not rub, above which all samples are, changes nothing.
  const int sample = scene.contacts.seconds.front().sample;
  REQUIRE(scene.start.normal_forces[count + sample] > 0.0);
  scene.contacts.seconds.push_back({sample, {Vec3::UnitX(), -100.0, 1e-3}, false});
  scene.potential.setContacts(scene.contacts, scene.start.normal_forces);
  const double with = scene.energy(scene.x);
  scene.potential.setContacts(scene.contacts);
  CHECK(with - scene.energy(scene.x) == Approx(expected).epsilon(1e-9));
}

TEST_CASE("friction's Hessian is below its bound, and both are below the lumped diagonal") {
  RubbedScene scene;
  std::vector<double> diagonal;
  scene.potential.contactDiagonal(scene.x, false, diagonal);
  double sum = 0.0;
  for (const double force : scene.start.normal_forces) sum += scene.options.friction * force;
  CHECK(std::accumulate(diagonal.begin(), diagonal.end(), 0.0) ==
        Approx(2.0 * sum / (kSlipSpeed * scene.options.h)).epsilon(1e-9));
  for (unsigned seed = 10; seed < 13; ++seed) {
    const Positions d = randomPositions(static_cast<int>(scene.x.rows()), seed);
    const double exact = scene.timesHessian(HessianKind::exact, d).cwiseProduct(d).sum();
    const double bound = scene.timesHessian(HessianKind::projected, d).cwiseProduct(d).sum();
    double lumped = 0.0;
    for (size_t i = 0; i < diagonal.size(); ++i) lumped += diagonal[i] * d.row(i).squaredNorm();
    CHECK(exact < bound);
    CHECK(bound < lumped);
  }
}

TEST_CASE("the normal forces are those of the contact planes at the positions asked for") {
  const TriangleMesh mesh = makeSheet(3, 3, 0.1, 0.1);
  const Cloth cloth(mesh, Vec3::UnitX(), Material());
  const int count = cloth.samples().count();
  IncrementalPotential potential(cloth);
  StepOptions options;
  options.friction = 0.3;
  potential.begin({mesh.positions, Positions::Zero(mesh.positions.rows(), 3)}, options);
  Contacts contacts;
  contacts.planes.assign(count, ContactPlane{Vec3::UnitZ(), 1e-3});
  contacts.seconds.push_back({4, {Vec3::UnitZ(), 2e-3}});
  contacts.seconds.push_back({4, {Vec3::UnitZ(), 3e-3}, false});  // kept from an earlier round: friction leaves it out
  potential.setContacts(contacts);
  std::vector<double> forces;
  potential.normalForces(mesh.positions, forces);
  REQUIRE(forces.size() == static_cast<size_t>(2 * count));
  double sum = 0.0;
  for (int s = 0; s < count; ++s) sum += forces[s];
  CHECK(sum == Approx(0.01 * contactPressure(1e-3, options.contact_stiffness, 1e-3)));
  for (int s = 0; s < count; ++s) {
    const double area = cloth.samples().area(s, cloth.vertexAreas(), cloth.restAreas());
    CHECK(forces[s] == Approx(area * contactPressure(1e-3, options.contact_stiffness, 1e-3)));
    CHECK(forces[count + s] ==
          (s == 4 ? Approx(area * contactPressure(2e-3, options.contact_stiffness, 1e-3)) : Approx(0.0)));
  }
}
