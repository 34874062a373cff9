#include "garment/boundary_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>

#include "garment/nearness.h"
#include "garment/surface_path.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"
#include "solver/linear/gradient_system.h"

namespace ease {
namespace {

[[noreturn]] void refuse(const std::string& loop, const std::string& fault) {
  throw InputError(fmt::format("boundary '{}': {}", loop, fault));
}

/// Solves the heat equation on a surface by implicit steps.  The matrix is factored at the first call.
class Heat {
 public:
  Heat(const TriangleMesh& mesh, double smoothing) : mesh_(mesh), time_(0.5 * smoothing * smoothing) {}

  void diffuse(std::vector<double>& values) {
    if (!system_) factor();
    const std::vector<Mat32> flat(mesh_.triangles.rows(), Mat32::Zero());
    Positions u = Positions::Zero(mesh_.positions.rows(), 3);
    for (size_t v = 0; v < values.size(); ++v) u(v, 0) = values[v];
    for (int step = 0; step < kSteps; ++step) {
      const Positions before = u;
      system_->solve(flat, before, u);
    }
    for (size_t v = 0; v < values.size(); ++v) values[v] = u(v, 0);
  }

 private:
  static constexpr int kSteps = 2;

  void factor() {
    const int vertices = static_cast<int>(mesh_.positions.rows()), triangles = static_cast<int>(mesh_.triangles.rows());
    std::vector<Mat2> rest_inverse(triangles);
    std::vector<double> weights(triangles), mass(vertices, 0.0);
    for (int t = 0; t < triangles; ++t) {
      const Mat32 edges = edgeMatrix(mesh_.positions, mesh_.triangles, t);
      rest_inverse[t] = (planeFrame(edges, edges.col(0)).transpose() * edges).inverse();
      const double area = triangleArea(mesh_.positions, mesh_.triangles, t);
      weights[t] = time_ / kSteps * area;
      for (int k = 0; k < 3; ++k) mass[mesh_.triangles(t, k)] += area / 3.0;
    }
    system_ = std::make_unique<GradientSystem>(vertices, mesh_.triangles);
    if (!system_->factor(rest_inverse, weights, mass))
      throw ComputationError("boundary: the body's Laplacian is not positive definite");
  }

  const TriangleMesh& mesh_;
  double time_;  // diffusion time, m^2
  std::unique_ptr<GradientSystem> system_;
};

/// Lists the triangles that a curve passes: entry i is the triangle between points i and i + 1.
std::vector<int> trianglesAlong(const EdgeCurve& curve, const Topology& topology) {
  const int n = static_cast<int>(curve.points.size());
  std::vector<int> triangles(n);
  for (int i = 0; i < n; ++i) {
    const Edge &here = topology.edges[curve.points[i].edge], &next = topology.edges[curve.points[(i + 1) % n].edge];
    const int t = here.triangle[0];
    triangles[i] = t == next.triangle[0] || t == next.triangle[1] ? t : here.triangle[1];
  }
  return triangles;
}

/// Position of a point along a triangle's border, 0 to 3: k + s lies at the share s of the edge from corner k to k + 1.
/// Returns -1 if the point is on none of the edges.
double placeAround(const EdgePoint& p, int triangle, const Triangles& triangles) {
  for (int k = 0; k < 3; ++k) {
    const int a = triangles(triangle, k), b = triangles(triangle, (k + 1) % 3);
    if (a == p.vertex[0] && b == p.vertex[1]) return k + p.t;
    if (b == p.vertex[0] && a == p.vertex[1]) return k + 1.0 - p.t;
  }
  return -1.0;
}

/// Whether the curve crosses or touches itself: it passes a triangle twice, and the ends of the two passages alternate
/// around the triangle's border or coincide.
bool crossesItself(const EdgeCurve& curve, const std::vector<int>& passed, const Triangles& triangles) {
  const int n = static_cast<int>(curve.points.size());
  std::vector<std::pair<int, int>> passages;  // triangle, point
  for (int i = 0; i < n; ++i) passages.emplace_back(passed[i], i);
  std::sort(passages.begin(), passages.end());
  const auto ends = [&](int i, int triangle) {
    const double a = placeAround(curve.points[i], triangle, triangles);
    const double b = placeAround(curve.points[(i + 1) % n], triangle, triangles);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  for (int p = 0; p < n; ++p)
    for (int q = p + 1; q < n && passages[q].first == passages[p].first; ++q) {
      const auto [a, b] = ends(passages[p].second, passages[p].first);
      const auto [c, d] = ends(passages[q].second, passages[q].first);
      const auto isBetween = [&](double x) { return x >= a && x <= b; };
      if (isBetween(c) != isBetween(d) || c == a || d == b || c == b || d == a) return true;
    }
  return false;
}

/// Side of a closed curve on which each vertex lies: +1 left, -1 right.  Empty if the curve does not divide the
/// surface.
std::vector<signed char> sidesOf(const EdgeCurve& curve, const std::vector<int>& passed, const Triangles& triangles,
                                 const Topology& topology, Eigen::Index vertices) {
  std::vector<char> is_odd(topology.edges.size(), 0);  // edges that the curve crosses an odd number of times
  for (const EdgePoint& p : curve.points) is_odd[p.edge] ^= 1;
  std::vector<std::vector<int>> edges_of(vertices);
  for (size_t e = 0; e < topology.edges.size(); ++e)
    for (const int v : topology.edges[e].vertex) edges_of[v].push_back(static_cast<int>(e));

  // The search starts at an edge through which the curve enters a triangle.  The end of this edge that comes first
  // counter-clockwise in the triangle lies left of the curve.
  std::vector<signed char> side(vertices, 0);
  std::deque<int> front;
  for (size_t i = 0; i < curve.points.size() && front.empty(); ++i) {
    const EdgePoint& p = curve.points[i];
    if (!is_odd[p.edge]) continue;
    int corner = 0;
    while (topology.triangle_edges(passed[i], corner) != p.edge) ++corner;
    front.push_back(triangles(passed[i], (corner + 1) % 3));
    side[front.back()] = 1;
  }
  while (!front.empty()) {
    const int v = front.front();
    front.pop_front();
    for (const int e : edges_of[v]) {
      const auto [a, b] = topology.edges[e].vertex;
      const int other = a == v ? b : a;
      const auto expected = static_cast<signed char>(is_odd[e] ? -side[v] : side[v]);
      if (side[other] == 0) {
        side[other] = expected;
        front.push_back(other);
      } else if (side[other] != expected) {
        return {};
      }
    }
  }
  return side;
}

/// Signed distance of each vertex to the curve, m, limited to +-`reach`.  The search spreads from the crossed edges to
/// neighbours and stops at vertices further than `reach`; all others have the limit value.
std::vector<double> signedDistances(const EdgeCurve& curve, const std::vector<signed char>& side,
                                    const TriangleMesh& mesh, const Topology& topology, double reach) {
  const std::vector<Vec3> points = placed(curve, mesh.positions);
  const int vertices = static_cast<int>(mesh.positions.rows());
  const std::vector<std::vector<int>> neighbours = vertexNeighbours(topology, vertices);
  std::vector<char> is_known(vertices, 0);
  std::vector<double> values(vertices);
  for (int v = 0; v < vertices; ++v) values[v] = side[v] * reach;
  std::vector<int> ring;
  for (const EdgePoint& p : curve.points) ring.insert(ring.end(), p.vertex.begin(), p.vertex.end());
  while (!ring.empty()) {
    std::vector<int> next;
    for (const int v : ring) {
      if (is_known[v]) continue;
      is_known[v] = 1;
      const double distance = polygonDistance(points, true, mesh.positions.row(v));
      if (distance >= reach) continue;
      values[v] = side[v] * distance;
      next.insert(next.end(), neighbours[v].begin(), neighbours[v].end());
    }
    ring.swap(next);
  }
  return values;
}

/// Mean distance of the points from the curve, m.
double meanDistance(const EdgeCurve& curve, const Positions& positions, const std::vector<Vec3>& points) {
  const std::vector<Vec3> polygon = placed(curve, positions);
  double sum = 0.0;
  for (const Vec3& x : points) sum += polygonDistance(polygon, curve.is_closed, x);
  return sum / static_cast<double>(points.size());
}

EdgeCurve nearestOf(const std::vector<EdgeCurve>& curves, const Positions& positions, const std::vector<Vec3>& points) {
  const auto nearer = [&](const EdgeCurve& p, const EdgeCurve& q) {
    return meanDistance(p, positions, points) < meanDistance(q, positions, points);
  };
  return *std::min_element(curves.begin(), curves.end(), nearer);
}

class LoopFinder {
 public:
  LoopFinder(const TriangleMesh& body, const Topology& topology, double smoothing)
      : body_(body), topology_(topology), paths_(body, topology), heat_(body, smoothing), smoothing_(smoothing) {}

  EdgeCurve find(const LoopRequest& request) {
    return request.plane ? inPlane(request.name, *request.plane) : throughPoints(request);
  }

 private:
  EdgeCurve inPlane(const std::string& name, const PlaneNear& plane) const {
    const Vec3 normal = plane.normal.normalized();
    std::vector<double> heights(body_.positions.rows());
    for (size_t v = 0; v < heights.size(); ++v) heights[v] = normal.dot(Vec3(body_.positions.row(v)) - plane.point);
    const std::vector<EdgeCurve> curves = isolines(topology_, heights);
    if (curves.empty()) refuse(name, "its plane does not cut the body");
    return nearestOf(curves, body_.positions, {plane.near});
  }

  EdgeCurve throughPoints(const LoopRequest& request) {
    const std::vector<int> nodes = controlNodes(request);
    std::vector<int> joined;
    for (size_t i = 0; i < nodes.size(); ++i) {
      const auto path = paths_.shortest(nodes[i], nodes[(i + 1) % nodes.size()]);
      if (!path)
        refuse(request.name, fmt::format("its points {} and {} lie on parts of the body that are not connected", i,
                                         (i + 1) % nodes.size()));
      joined.insert(joined.end(), path->begin(), path->end() - 1);
    }
    const EdgeCurve rough = paths_.curve(joined, true);
    if (rough.points.size() < 3) refuse(request.name, "it goes there and back, and encloses nothing");
    return smoothed(request.name, rough, nodes);
  }

  std::vector<int> controlNodes(const LoopRequest& request) const {
    std::vector<int> nodes;
    for (const Vec3& x : request.points) {
      expectNear(body_, x, kNearLine, fmt::format("boundary '{}': point {}", request.name, nodes.size()), "the body");
      nodes.push_back(paths_.nearestNode(x));
    }
    for (const int v : request.vertices) {
      if (v >= body_.positions.rows())
        refuse(request.name,
               fmt::format("vertex {}: expected 0 to {}, the vertices of the body", v, body_.positions.rows() - 1));
      nodes.push_back(paths_.nearestNodeOf(v));
    }
    if (nodes.size() < 3) refuse(request.name, fmt::format("{} points: expected at least 3", nodes.size()));
    return nodes;
  }

  EdgeCurve smoothed(const std::string& name, const EdgeCurve& rough, const std::vector<int>& nodes) {
    const std::vector<int> passed = trianglesAlong(rough, topology_);
    if (crossesItself(rough, passed, body_.triangles)) refuse(name, "it crosses itself");
    const std::vector<signed char> side = sidesOf(rough, passed, body_.triangles, topology_, body_.positions.rows());
    if (side.empty()) refuse(name, "it does not divide the body in two");
    std::vector<double> values = signedDistances(rough, side, body_, topology_, 4.0 * smoothing_);
    heat_.diffuse(values);
    const std::vector<EdgeCurve> curves = isolines(topology_, values);
    if (curves.empty())
      refuse(name, fmt::format("{:.3g} m long: too small, smoothing leaves nothing of it",
                               polygonLength(placed(rough, body_.positions), true)));
    std::vector<Vec3> points;
    for (const int node : nodes) points.push_back(paths_.position(node));
    return nearestOf(curves, body_.positions, points);
  }

  const TriangleMesh& body_;
  const Topology& topology_;
  SurfacePaths paths_;
  Heat heat_;
  double smoothing_;
};

}  // namespace

std::vector<BoundaryLoop> findLoops(const TriangleMesh& body, const Topology& topology,
                                    const std::vector<LoopRequest>& requests, double smoothing) {
  LoopFinder finder(body, topology, smoothing);
  std::vector<BoundaryLoop> loops;
  for (const LoopRequest& request : requests) loops.push_back({request.name, finder.find(request)});
  return loops;
}

}  // namespace ease
