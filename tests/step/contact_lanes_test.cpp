#include "solver/step/contact_lanes.h"

#include <catch2/catch.hpp>
#include <map>

#include "tests/sheet.h"

using namespace ease;

namespace {

constexpr int kGroup = 2 * kLanes;  // the sheet's 60 triangles make four groups, the last of which is not full

struct Samples {
  TriangleMesh mesh = makeSheet(6, 5, 0.3, 0.2, 0.2);
  Cloth cloth{mesh, -Vec3::UnitY(), Material()};
  Positions x = mesh.positions + 0.02 * randomPositions(static_cast<int>(mesh.positions.rows()), 1);
  int vertices = cloth.vertexCount(), edges = static_cast<int>(cloth.topology().edges.size());
  int count = vertices + edges + cloth.triangleCount();

  /// Position of sample s: the vertices come first, then the edge midpoints, then the centroids (samples.h).
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
  TriangleEdges hosts(int block) const {
    TriangleEdges edges_of;
    for (int l = 0; l < kLanes; ++l) {
      const int t = std::min(block * kLanes + l, cloth.triangleCount() - 1);
      const Vec3 first = x.row(cloth.triangles()(t, 0));
      const Mat32 edges_at = edgeMatrix(x, cloth.triangles(), t);
      const auto put = [&](Column<Lanes>& column, const Vec3& value) {
        column.x[l] = value[0], column.y[l] = value[1], column.z[l] = value[2];
      };
      put(edges_of.first, first);
      put(edges_of.edge_1, edges_at.col(0));
      put(edges_of.edge_2, edges_at.col(1));
    }
    return edges_of;
  }
};

/// Calls visit(contact, lane) for every sample in the layout.
template <class Visit>
void forAll(const ContactLayout& layout, const Visit& visit) {
  for (int g = 0; g < layout.groupCount(); ++g)
    for (const ContactLanes& contact : layout.group(g))
      for (int l = 0; l < kLanes; ++l)
        if (contact.sample[l] >= 0) visit(contact, l);
}

}  // namespace

TEST_CASE("every sample has one host, which holds it: vertex, midpoint or centroid") {
  const Samples samples;
  std::vector<int> times(samples.count, 0);
  int before = 0;
  for (const auto& [s, t] : hostedSamples(samples.cloth)) {
    ++times[s];
    CHECK(t >= before);
    before = t;
    const auto corners = samples.cloth.triangles().row(t).array();
    if (s < samples.vertices) {
      CHECK((corners == s).any());
    } else if (s < samples.vertices + samples.edges) {
      for (int v : samples.cloth.topology().edges[s - samples.vertices].vertex) CHECK((corners == v).any());
    } else {
      CHECK(t == s - samples.vertices - samples.edges);
    }
  }
  CHECK(times == std::vector<int>(samples.count, 1));
}

TEST_CASE("each lane's depth is that of its sample's place below its plane") {
  const Samples samples;
  ContactLayout layout(samples.cloth, kGroup);
  Contacts contacts;
  for (int s = 0; s < samples.count; ++s) contacts.planes.push_back(Samples::plane(s));
  layout.set(contacts);
  CHECK(layout.groupCount() == 4);
  CHECK(layout.sampleCount() == samples.count);
  int deep = 0, above = 0;
  forAll(layout, [&](const ContactLanes& contact, int l) {
    const int s = contact.sample[l];
    const ContactPlane plane = Samples::plane(s);
    const Lanes depth = contact.depth(samples.hosts(contact.block));
    CHECK(contact.give[l] == plane.give);
    CHECK(contact.normalOf(l) == plane.normal);
    CHECK(depth[l] == Approx(plane.depth(samples.place(s))).margin(1e-15));
    ++(depth[l] > 0.0 ? deep : above);
  });
  CHECK(deep + above == samples.count);
  CHECK(deep > 40);
  CHECK(above > 20);
}

TEST_CASE("the layout holds a lane for every plane, first or second, and no other") {
  const Samples samples;
  ContactLayout layout(samples.cloth, kGroup);
  CHECK(layout.empty());
  Contacts contacts;
  std::map<int, int> planes;
  for (int s = 0; s < samples.count; ++s) {
    contacts.planes.push_back(s % 3 == 0 ? Samples::plane(s) : ContactPlane());
    if (s % 3 == 0) ++planes[s];
  }
  for (const int s : {samples.count - 1, 3, 0, 3}) {
    contacts.seconds.push_back({s, Samples::plane(s + 1)});
    ++planes[s];
  }
  layout.set(contacts);
  CHECK_FALSE(layout.empty());
  std::map<int, int> held;
  forAll(layout, [&](const ContactLanes& contact, int l) { ++held[contact.sample[l]]; });
  CHECK(held == planes);
  for (int g = 0; g < layout.groupCount(); ++g)
    for (size_t k = 1; k < layout.group(g).size(); ++k) CHECK(layout.group(g)[k - 1].block <= layout.group(g)[k].block);

  layout.set({});
  CHECK(layout.empty());
  forAll(layout, [](const ContactLanes&, int) { FAIL("nothing is near"); });
}

TEST_CASE("vertices, edges and triangles each stand for a third of the cloth's area") {
  const Samples samples;
  double area[3] = {};
  for (const HostedSample& hosted : hostedSamples(samples.cloth)) {
    const int s = hosted.sample;
    ContactLanes lanes(hosted.triangle / kLanes);
    lanes.set(5, samples.cloth, hosted, Samples::plane(s));
    area[s < samples.vertices ? 0 : s < samples.vertices + samples.edges ? 1 : 2] += lanes.area[5];
  }
  for (const double third : area) CHECK(third == Approx(0.3 * 0.2 / 3.0));
}

TEST_CASE("a lane without a sample is never deep and has no area") {
  const Samples samples;
  ContactLanes lanes(0);
  lanes.set(3, samples.cloth, hostedSamples(samples.cloth).front(), {Vec3::UnitZ(), 1.0});
  const Lanes depth = lanes.depth(samples.hosts(0));
  for (int l = 0; l < kLanes; ++l) {
    if (l == 3) continue;
    CHECK(lanes.sample[l] == -1);
    CHECK(depth[l] == 0.0);
    CHECK(lanes.area[l] == 0.0);
    CHECK(lanes.give[l] > 0.0);  // not zero, because depth is divided by it
  }
  CHECK(depth[3] > 0.5);
}
