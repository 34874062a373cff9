#include "solver/mesh/topology.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "solver/base/error.h"
#include "solver/base/joined.h"

namespace ease {
namespace {

/// One side of a triangle, from vertex `from` to `to` in the triangle's own order, opposite to its corner `corner`.
struct Side {
  int from, to, triangle, corner;
  int low() const { return std::min(from, to); }
  int high() const { return std::max(from, to); }
};

/// Lists all sides, sorted by edge and then by triangle, so that the sides of one edge are adjacent.
std::vector<Side> sortedSides(const Triangles& triangles) {
  std::vector<std::pair<std::uint64_t, int>> order;  // both vertices as one key, 3 triangle + corner
  order.reserve(3 * triangles.rows());
  const auto side = [&](int s) {
    return Side{triangles(s / 3, (s + 1) % 3), triangles(s / 3, (s + 2) % 3), s / 3, s % 3};
  };
  for (int s = 0; s < 3 * triangles.rows(); ++s) {
    order.emplace_back(static_cast<std::uint64_t>(side(s).low()) << 32 | static_cast<std::uint64_t>(side(s).high()), s);
  }
  std::ranges::sort(order);
  std::vector<Side> sides;
  sides.reserve(order.size());
  for (const auto& [key, s] : order) sides.push_back(side(s));
  return sides;
}

/// Faults of one kind: the first is told, and how many there are.
struct Faults {
  std::string first;
  int count = 0;

  void add(const std::string& text) {
    if (count++ == 0) first = text;
  }
  void refuse(const std::string& name, const char* remedy) const {
    if (count == 0) return;
    throw InputError(
        joined(name, ": ", first, count > 1 ? joined(" (", count, " such in all)") : std::string(), ": ", remedy));
  }
};

struct EdgeFaults {
  Faults crowded, opposed;
};

void checkManifold(const Side* sides, std::size_t count, const std::string& name, EdgeFaults& faults) {
  const Side& first = sides[0];
  if (first.from == first.to) {
    throw InputError(
        joined(name, ": triangle ", first.triangle, " has vertex ", first.from, " twice: dissolve degenerate faces"));
  }
  if (count > 2) {
    std::string triangles = joined(first.triangle);
    for (std::size_t s = 1; s < count; ++s) triangles += joined(", ", sides[s].triangle);
    faults.crowded.add(joined("the edge of vertices ", first.low(), " and ", first.high(), " has ", count,
                              " triangles (", triangles, "); expected one or two"));
  }
  if (count == 2 && first.from == sides[1].from) {
    faults.opposed.add(joined("triangles ", first.triangle, " and ", sides[1].triangle,
                              " are oriented against each other along the edge of vertices ", first.low(), " and ",
                              first.high()));
  }
}

void buildEdges(const Triangles& triangles, const std::string& name, Topology& topology) {
  const std::vector<Side> sides = sortedSides(triangles);
  topology.triangle_edges.resize(triangles.rows(), 3);
  EdgeFaults faults;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low() == sides[begin].low() && sides[end].high() == sides[begin].high()) {
      ++end;
    }
    checkManifold(&sides[begin], end - begin, name, faults);
    if (end - begin > 2) continue;
    Edge edge{{sides[begin].low(), sides[begin].high()}, {-1, -1}, {-1, -1}};
    // The triangle that runs from the lower to the higher vertex comes first; a boundary edge has only one.
    for (std::size_t s = begin; s < end; ++s) {
      const int slot = end - begin == 2 && sides[s].from != edge.vertex[0] ? 1 : 0;
      edge.triangle[slot] = sides[s].triangle;
      edge.opposite[slot] = triangles(sides[s].triangle, sides[s].corner);
      topology.triangle_edges(sides[s].triangle, sides[s].corner) = static_cast<int>(topology.edges.size());
    }
    topology.edges.push_back(edge);
  }
  faults.crowded.refuse(name, "delete doubled and inner faces");
  faults.opposed.refuse(name, "recalculate the normals so that all faces look outwards");
}

/// Counts the triangles around `vertex` from triangle `t` on, in one direction: each step crosses the edge opposite to
/// corner + `side` (1 or 2), until the boundary or, where the fan `closes`, until `t` is reached again.
int trianglesAlong(const Triangles& triangles, const Topology& topology, int vertex, int t, int side, bool& closes) {
  int count = 0;
  for (int current = t;;) {
    ++count;
    const int corner = cornerOf(triangles, current, vertex);
    const Edge& edge = topology.edges[topology.triangle_edges(current, (corner + side) % 3)];
    const int next = edge.triangleAcross(current);
    closes = next == t;
    if (next < 0 || closes) return count;
    current = next;
  }
}

/// Checks that the triangles of each vertex form one fan, closed or open: all are reached across shared edges.
void checkFans(const TriangleMesh& mesh, const Topology& topology, const std::string& name) {
  std::vector<int> triangle_count(mesh.positions.rows(), 0), any_triangle(mesh.positions.rows(), -1);
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k) {
      ++triangle_count[mesh.triangles(t, k)];
      any_triangle[mesh.triangles(t, k)] = t;
    }
  }
  Faults pinched;
  for (int vertex = 0; vertex < mesh.positions.rows(); ++vertex) {
    const int t = any_triangle[vertex];
    if (t < 0) continue;
    bool closes = false;
    int reached = trianglesAlong(mesh.triangles, topology, vertex, t, 1, closes);
    if (!closes) reached += trianglesAlong(mesh.triangles, topology, vertex, t, 2, closes) - 1;
    if (reached != triangle_count[vertex]) {
      pinched.add(joined("vertex ", vertex, " joins two fans of triangles that share no edge there"));
    }
  }
  pinched.refuse(name, "split such vertices in two");
}

double loopLength(const Positions& positions, const std::vector<int>& loop) {
  double length = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    length += (positions.row(loop[(k + 1) % loop.size()]) - positions.row(loop[k])).norm();
  }
  return length;
}

/// Follows the boundary in the direction of its triangles.  Each vertex has one fan of triangles, so that at most one
/// boundary edge leaves it.
std::vector<std::vector<int>> followBoundary(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<int> next(mesh.positions.rows(), -1);
  for (const Edge& edge : topology.edges) {
    if (!edge.isBoundary()) continue;
    const int t = edge.triangle[0], corner = cornerOf(mesh.triangles, t, edge.opposite[0]);
    next[mesh.triangles(t, (corner + 1) % 3)] = mesh.triangles(t, (corner + 2) % 3);
  }
  std::vector<std::vector<int>> loops;
  for (int start = 0; start < mesh.positions.rows(); ++start) {
    if (next[start] < 0) continue;
    std::vector<int>& loop = loops.emplace_back();
    for (int vertex = start; next[vertex] >= 0;) {
      loop.push_back(vertex);
      vertex = std::exchange(next[vertex], -1);
    }
  }
  std::vector<std::pair<double, int>> order;  // longest first, by lowest vertex where equal
  for (std::size_t l = 0; l < loops.size(); ++l) {
    order.emplace_back(-loopLength(mesh.positions, loops[l]), static_cast<int>(l));
  }
  std::ranges::sort(order);
  std::vector<std::vector<int>> sorted;
  sorted.reserve(loops.size());
  for (const auto& [negative_length, l] : order) sorted.push_back(std::move(loops[l]));
  return sorted;
}

}  // namespace

Topology buildTopology(const TriangleMesh& mesh, const std::string& name) {
  Topology topology;
  buildEdges(mesh.triangles, name, topology);
  checkFans(mesh, topology, name);
  topology.boundary_loops = followBoundary(mesh, topology);
  return topology;
}

std::vector<std::vector<int>> vertexNeighbours(const Topology& topology, int vertex_count) {
  std::vector<std::vector<int>> neighbours(vertex_count);
  for (const Edge& edge : topology.edges)
    for (const int k : {0, 1}) neighbours[edge.vertex[k]].push_back(edge.vertex[1 - k]);
  return neighbours;
}

double meanEdgeLength(const Topology& topology, const Positions& positions) {
  double sum = 0.0;
  for (const Edge& edge : topology.edges) sum += (positions.row(edge.vertex[0]) - positions.row(edge.vertex[1])).norm();
  return sum / static_cast<double>(topology.edges.size());
}

}  // namespace ease
