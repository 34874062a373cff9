#include "solver/step/contact_lanes.h"

#include <catch2/catch.hpp>

#include "tests/sheet.h"

using namespace ease;

namespace {

struct Samples {
  TriangleMesh mesh = makeSheet(3, 2, 0.3, 0.2, 0.2);
  Cloth cloth{mesh, -Vec3::UnitY(), Material()};
  Positions x = mesh.positions + 0.02 * randomPositions(static_cast<int>(mesh.positions.rows()), 1);
  int vertices = cloth.vertexCount(), edges = static_cast<int>(cloth.topology().edges.size());
  int count = vertices + edges + cloth.triangleCount();

  /// In the order of contact.h.
  Vec3 place(int s) const {
    if (s < vertices) return x.row(s);
    if (s < vertices + edges) {
      const Edge& edge = cloth.topology().edges[s - vertices];
      return 0.5 * (x.row(edge.vertex[0]) + x.row(edge.vertex[1]));
    }
    const auto corners = cloth.triangles().row(s - vertices - edges);
    return (x.row(corners[0]) + x.row(corners[1]) + x.row(corners[2])) / 3.0;
  }
  static ContactPlane plane(int s) {
    ContactPlane plane;
    plane.normal = Vec3(std::sin(s), 0.3, 1.0).normalized();
    plane.offset = 0.02 * std::cos(2.0 * s) + 0.08;
    plane.give = 1e-3 + 1e-4 * s;
    return plane;
  }
};

}  // namespace

TEST_CASE("each lane's depth is that of its sample's place below its plane: vertex, midpoint or centroid") {
  const Samples samples;
  int deep = 0, above = 0;
  for (int first = 0; first < samples.count; first += kLanes) {
    ContactLanes lanes;
    const int used = std::min(kLanes, samples.count - first);
    for (int l = 0; l < used; ++l) lanes.set(l, samples.cloth, first + l, Samples::plane(first + l));
    const Lanes depth = lanes.depth(samples.x);
    for (int l = 0; l < used; ++l) {
      const ContactPlane plane = Samples::plane(first + l);
      CHECK(lanes.sample[l] == first + l);
      CHECK(lanes.give[l] == plane.give);
      CHECK(depth[l] == Approx(plane.depth(samples.place(first + l))).margin(1e-16));
      ++(depth[l] > 0.0 ? deep : above);
    }
  }
  CHECK(deep > 10);
  CHECK(above > 5);
}

TEST_CASE("vertices, edges and triangles each stand for a third of the cloth's area") {
  const Samples samples;
  double area[3] = {};
  for (int s = 0; s < samples.count; ++s) {
    ContactLanes lanes;
    lanes.set(5, samples.cloth, s, Samples::plane(s));
    area[s < samples.vertices ? 0 : s < samples.vertices + samples.edges ? 1 : 2] += lanes.area[5];
  }
  for (const double third : area) CHECK(third == Approx(0.3 * 0.2 / 3.0));
}

TEST_CASE("a lane without a sample is never deep and has no area") {
  const Samples samples;
  ContactLanes lanes;
  lanes.set(3, samples.cloth, 2, {Vec3::UnitZ(), 1.0});
  const Lanes depth = lanes.depth(samples.x);
  for (int l = 0; l < kLanes; ++l) {
    if (l == 3) continue;
    CHECK(lanes.sample[l] == -1);
    CHECK(depth[l] == 0.0);
    CHECK(lanes.area[l] == 0.0);
    CHECK(lanes.give[l] > 0.0);  // divided by
  }
  CHECK(depth[3] > 0.9);
}
