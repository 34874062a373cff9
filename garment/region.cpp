#include "garment/region.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "collision/triangle_tree.h"
#include "garment/nearness.h"
#include "solver/base/error.h"
#include "solver/mesh/numbering.h"
#include "solver/mesh/topology.h"

namespace ease {
namespace {

using EdgeKey = std::array<int, 2>;

std::set<EdgeKey> edgesAlong(const std::vector<int>& loop) {
  std::set<EdgeKey> edges;
  for (size_t i = 0; i < loop.size(); ++i) edges.insert(edgeKey(loop[i], loop[(i + 1) % loop.size()]));
  return edges;
}

/// Marks the triangles that can be reached from triangle `start` without crossing a loop.
std::vector<char> flood(const Topology& topology, const std::vector<std::vector<int>>& curves, int start) {
  std::set<EdgeKey> walls;
  for (const std::vector<int>& curve : curves) walls.merge(edgesAlong(curve));
  std::vector<char> is_inside(topology.triangle_edges.rows(), 0);
  std::vector<int> front = {start};
  is_inside[start] = 1;
  while (!front.empty()) {
    const int t = front.back();
    front.pop_back();
    for (int k = 0; k < 3; ++k) {
      const Edge& edge = topology.edges[topology.triangle_edges(t, k)];
      if (edge.isBoundary() || walls.contains(edge.vertex)) continue;
      const int next = edge.triangleAcross(t);
      if (is_inside[next]) continue;
      is_inside[next] = 1;
      front.push_back(next);
    }
  }
  return is_inside;
}

/// Counts the sides of a loop on which there is cloth: 0, 1 or 2.
int sidesWithCloth(const Topology& topology, const std::vector<int>& loop, const std::vector<char>& is_inside) {
  int most = 0;
  for (const EdgeKey& key : edgesAlong(loop)) {
    const auto before = [](const Edge& edge, const EdgeKey& k) { return edge.vertex < k; };
    const auto edge = std::lower_bound(topology.edges.begin(), topology.edges.end(), key, before);
    int sides = 0;
    for (const int t : edge->triangle) sides += t >= 0 && is_inside[t] ? 1 : 0;
    most = std::max(most, sides);
  }
  return most;
}

void checkBounds(const CutMesh& cut, const Topology& topology, const std::vector<BoundaryLoop>& loops,
                 const std::vector<char>& is_inside, const Vec3& seed) {
  std::vector<std::string> bounding, others;
  for (size_t c = 0; c < loops.size(); ++c) {
    const int sides = sidesWithCloth(topology, cut.curves[c], is_inside);
    if (sides == 2)
      throw InputError(fmt::format("boundary '{}' encloses nothing: there is cloth on both sides", loops[c].name));
    (sides == 1 ? bounding : others).push_back("'" + loops[c].name + "'");
  }
  if (others.empty()) return;
  const std::string where = fmt::format("seed = [{:g}, {:g}, {:g}]", seed.x(), seed.y(), seed.z());
  if (bounding.empty()) throw InputError(fmt::format("{} lies on a part of the body that no boundary reaches", where));
  throw InputError(fmt::format("{} lies outside the boundaries: the part of the body around it ends at {}, not at {}",
                               where, fmt::join(bounding, ", "), fmt::join(others, ", ")));
}

LoopedMesh extract(const CutMesh& cut, const std::vector<BoundaryLoop>& loops, const std::vector<char>& is_inside) {
  std::vector<int> kept;
  for (int t = 0; t < cut.mesh.triangles.rows(); ++t)
    if (is_inside[t]) kept.push_back(t);
  const Numbering numbering = partNumbering(cut.mesh.triangles, std::move(kept));
  std::vector<int> number = newNumbers(numbering.vertices);
  number.resize(cut.mesh.positions.rows(), -1);
  LoopedMesh region;
  region.mesh = renumbered(cut.mesh, numbering);
  for (size_t c = 0; c < loops.size(); ++c) {
    region.loops.push_back({loops[c].name, {}});
    for (const int v : cut.curves[c]) region.loops.back().vertices.push_back(number[v]);
  }
  return region;
}

}  // namespace

LoopedMesh enclosedRegion(const TriangleMesh& body, const Topology& topology, const std::vector<BoundaryLoop>& loops,
                          const Vec3& seed) {
  expectNear(body, seed, kNearPart, "region: seed", "the body");
  const CutMesh cut = cutAlong(body, topology, loops);
  const Topology cut_topology = buildTopology(cut.mesh, "body");
  const TriangleTree tree(cut.mesh.positions, cut.mesh.triangles);
  const int start = tree.closest(seed, std::numeric_limits<double>::infinity()).triangle;
  const std::vector<char> is_inside = flood(cut_topology, cut.curves, start);
  checkBounds(cut, cut_topology, loops, is_inside, seed);
  return extract(cut, loops, is_inside);
}

}  // namespace ease
