#include "garment/seam.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "collision/triangle_tree.h"
#include "garment/nearness.h"
#include "garment/seam_straightening.h"
#include "garment/surface_path.h"
#include "solver/base/error.h"

namespace ease {
namespace {

[[noreturn]] void refuse(const std::string& seam, const std::string& fault) {
  throw InputError(fmt::format("seam '{}': {}", seam, fault));
}

/// A point of a line that may slide along an edge of the mesh, to `t` of the way from `a` to `b`; where they are one
/// point it is fixed.
struct Sliding {
  Vec3 a, b;
  double t = 0.5;
  Vec3 at() const { return (1.0 - t) * a + t * b; }
};

/// Slides points along their edges until the line through them is as short as it can be: each to where the line from
/// its neighbour on one side to that on the other crosses the edge once both triangles are unfolded into a plane.
void tighten(bool is_closed, std::vector<Sliding>& points) {
  constexpr int kMaxSweeps = 2000;
  constexpr double kSettled = 1e-7;  // m
  const size_t n = points.size();
  double moved = INFINITY;
  for (int sweep = 0; sweep < kMaxSweeps && moved > kSettled; ++sweep) {
    moved = 0.0;
    for (size_t i = is_closed ? 0 : 1; i + (is_closed ? 0 : 1) < n; ++i) {
      Sliding& point = points[i];
      const Vec3 along = point.b - point.a;
      const double length2 = along.squaredNorm();
      if (length2 == 0.0) continue;
      const auto place = [&](const Vec3& x) {  // share of the edge, and distance from its line
        const double share = along.dot(x - point.a) / length2;
        return std::pair(share, (x - point.a - share * along).norm());
      };
      const auto [before, far_before] = place(points[(i + n - 1) % n].at());
      const auto [after, far_after] = place(points[(i + 1) % n].at());
      const double far = far_before + far_after;
      const double share = far > 0.0 ? (before * far_after + after * far_before) / far : 0.5 * (before + after);
      const double t = std::clamp(share, 0.0, 1.0);
      moved = std::max(moved, std::abs(t - point.t) * std::sqrt(length2));
      point.t = t;
    }
  }
}

class SeamFinder {
 public:
  explicit SeamFinder(const LoopedMesh& garment)
      : garment_(garment),
        surface_(garment.mesh.positions, garment.mesh.triangles),
        ends_(garment.loops),
        topology_(buildTopology(garment.mesh, "garment")),
        paths_(garment.mesh, topology_) {
    neighbours_ = vertexNeighbours(topology_, static_cast<int>(garment.mesh.positions.rows()));
    is_boundary_.resize(neighbours_.size(), 0);
    for (const std::vector<int>& loop : topology_.boundary_loops)
      for (const int v : loop) is_boundary_[v] = 1;
    edge_length_ = meanEdgeLength(topology_, garment.mesh.positions);
  }

  const Topology& topology() const { return topology_; }

  /// Adds a seam on which later seams may begin or end.
  void add(const Seam& seam) { ends_.push_back({seam.name, seam.vertices}); }

  SeamLine line(const SeamRequest& request) const {
    if (request.plane) return inPlane(request);
    for (size_t i = 0; i < request.points.size(); ++i)
      expectNear(garment_.mesh, request.points[i], kNearLine, fmt::format("seam '{}': point {}", request.name, i),
                 "the garment");
    return request.from.empty() ? closedThrough(request) : betweenLoops(request);
  }

  /// Finds the chain of mesh edges along a line.
  Seam chain(const SeamRequest& request, const SeamLine& line) const {
    const std::string& name = request.name;
    Seam seam{name, {}, line.is_closed};
    const size_t n = line.points.size();
    if (!line.is_closed) {
      const bool in_plane = request.plane.has_value();
      const int from = in_plane ? nearestVertex(line.points.front(), true)
                                : nearestOf(verticesOf(request.name, request.from), line.points.front());
      const int to = request.to.empty() ? nearestVertex(line.points.back(), in_plane)
                                        : nearestOf(verticesOf(request.name, request.to), line.points.back());
      seam.vertices = chainBetween(name, line, from, to, {});
    } else {  // in three parts, because the shortest closed path from a vertex to itself is to stay there
      std::vector<int> corners;
      for (size_t k = 0; k < 3; ++k) corners.push_back(nearestVertex(line.points[k * n / 3], false));
      for (size_t k = 0; k < 3; ++k) {
        const std::vector<int> part =
            chainBetween(name, line, corners[k], corners[(k + 1) % 3], {seam.vertices, corners[(k + 2) % 3]});
        seam.vertices.insert(seam.vertices.end(), part.begin(), part.end() - 1);
      }
    }
    removeDetours(neighbours_, seam.vertices);
    if (seam.vertices.size() < (seam.is_closed ? 3U : 2U))
      refuse(name, "it is shorter than a triangle's edge: expected a longer seam or smaller triangles");
    return seam;
  }

 private:
  Vec3 at(int v) const { return garment_.mesh.positions.row(v); }

  SeamLine inPlane(const SeamRequest& request) const {
    const Vec3 normal = request.plane->normal.normalized();
    std::vector<double> heights(neighbours_.size());
    for (size_t v = 0; v < heights.size(); ++v) heights[v] = normal.dot(at(static_cast<int>(v)) - request.plane->point);
    SeamLine best{{}, false};
    double least = std::numeric_limits<double>::infinity();
    for (const EdgeCurve& curve : isolines(topology_, heights)) {
      const std::vector<Vec3> points = placed(curve, garment_.mesh.positions);
      const double distance = polygonDistance(points, curve.is_closed, request.plane->near);
      if (distance >= least) continue;
      least = distance;
      best = {points, curve.is_closed};
    }
    if (best.points.empty()) refuse(request.name, "its plane does not cut the garment");
    return best;
  }

  void append(const std::string& seam, int from, int to, std::vector<Sliding>& points) const {
    const auto path = paths_.shortest(from, to);
    if (!path) refuse(seam, "it joins parts of the garment that are not connected");
    for (const int node : *path) {
      const EdgePoint point = paths_.point(node);
      points.push_back({at(point.vertex[0]), at(point.vertex[1]), point.t});
    }
  }

  static Sliding fixed(const Vec3& x) { return {x, x, 0.0}; }
  Vec3 onSurface(const Vec3& x) const { return surface_.closest(x, 2.0 * kNearLine).point; }

  /// The shortest line through these points.
  static SeamLine tightened(std::vector<Sliding> points, bool is_closed) {
    tighten(is_closed, points);
    SeamLine line{{}, is_closed};
    for (const Sliding& point : points) line.points.push_back(point.at());
    return line;
  }

  SeamLine closedThrough(const SeamRequest& request) const {
    if (request.points.size() < 3)
      refuse(request.name, fmt::format("{} points: a closed seam needs at least 3", request.points.size()));
    std::vector<Sliding> points;
    for (size_t i = 0; i < request.points.size(); ++i) {
      points.push_back(fixed(onSurface(request.points[i])));
      append(request.name, paths_.nearestNode(request.points[i]),
             paths_.nearestNode(request.points[(i + 1) % request.points.size()]), points);
    }
    return tightened(std::move(points), true);
  }

  /// The vertices of a loop, or of a seam found before.
  const std::vector<int>& verticesOf(const std::string& seam, const std::string& name) const {
    return ends_[loopNamed(ends_, name, fmt::format("seam '{}': loop '{}'", seam, name))].vertices;
  }

  int nearestOf(const std::vector<int>& vertices, const Vec3& x) const {
    return *std::min_element(vertices.begin(), vertices.end(),
                             [&](int p, int q) { return (at(p) - x).squaredNorm() < (at(q) - x).squaredNorm(); });
  }

  /// Finds the line between two loops.  It begins and ends at the loop vertex nearest to the first or last point;
  /// without points, where the two loops are nearest to each other.  A dart ends at the inner vertex nearest to its
  /// last point.
  SeamLine betweenLoops(const SeamRequest& request) const {
    const std::vector<int>& from = verticesOf(request.name, request.from);
    const std::vector<int> to = request.to.empty() ? std::vector<int>{nearestVertex(request.points.back(), false)}
                                                   : verticesOf(request.name, request.to);
    const auto nearestTo = [&](const std::vector<int>& loop, const Vec3& x) { return nearestOf(loop, x); };
    int start = from.front(), end = to.front();
    if (!request.points.empty()) {
      start = nearestTo(from, request.points.front());
      end = nearestTo(to, request.points.back());
    } else {
      for (const int v : from)
        if ((at(v) - at(nearestTo(to, at(v)))).norm() < (at(start) - at(nearestTo(to, at(start)))).norm()) start = v;
      end = nearestTo(to, at(start));
    }
    if (start == end) refuse(request.name, "it begins where it ends");
    std::vector<Sliding> points = {fixed(at(start))};
    int node = paths_.nearestNodeOf(start);
    for (size_t i = 0; i + (request.to.empty() ? 1 : 0) < request.points.size(); ++i) {
      const int next = paths_.nearestNode(request.points[i]);
      append(request.name, node, next, points);
      points.push_back(fixed(onSurface(request.points[i])));
      node = next;
    }
    append(request.name, node, paths_.nearestNodeOf(end), points);
    points.push_back(fixed(at(end)));
    return tightened(std::move(points), false);
  }

  int nearestVertex(const Vec3& x, bool on_boundary) const {
    int nearest = -1;
    for (int v = 0; v < static_cast<int>(neighbours_.size()); ++v)
      if (static_cast<bool>(is_boundary_[v]) == on_boundary &&
          (nearest < 0 || (at(v) - x).squaredNorm() < (at(nearest) - x).squaredNorm()))
        nearest = v;
    return nearest;
  }

  /// Vertices that a part of a closed chain must avoid: the chain so far, and the corner between the other two parts.
  struct Taken {
    std::vector<int> chain;
    int corner = -1;
  };

  /// Finds the cheapest chain of edges by Dijkstra's algorithm; the cost of an edge grows with its distance from the
  /// line.  Only the ends of the chain may lie on the boundary.
  std::vector<int> chainBetween(const std::string& name, const SeamLine& line, int from, int to,
                                const Taken& taken) const {
    constexpr double kDetour = 4.0;  // added to the cost of an edge one mean edge length from the line, in its lengths
    std::vector<char> is_closed_off(is_boundary_);
    for (const int v : taken.chain) is_closed_off[v] = 1;
    if (taken.corner >= 0) is_closed_off[taken.corner] = 1;
    is_closed_off[from] = is_closed_off[to] = 0;
    std::vector<double> cost(neighbours_.size(), std::numeric_limits<double>::infinity()),
        off(neighbours_.size(), -1.0);
    std::vector<int> before(neighbours_.size(), -1);
    const auto offLine = [&](int v) {
      if (off[v] < 0.0) off[v] = (nearestOn(line, at(v)) - at(v)).squaredNorm() / (edge_length_ * edge_length_);
      return off[v];
    };
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    cost[from] = 0.0;
    front.push({0.0, from});
    while (!front.empty()) {
      const auto [reached, v] = front.top();
      front.pop();
      if (v == to) break;
      if (reached > cost[v]) continue;
      for (const int w : neighbours_[v]) {
        if (is_closed_off[w]) continue;
        const double next = reached + (at(v) - at(w)).norm() * (1.0 + 0.5 * kDetour * (offLine(v) + offLine(w)));
        if (next >= cost[w]) continue;
        cost[w] = next;
        before[w] = v;
        front.push({next, w});
      }
    }
    if (from == to || before[to] < 0) refuse(name, "no chain of edges leads along it: expected smaller triangles");
    std::vector<int> chain = {to};
    while (chain.back() != from) chain.push_back(before[chain.back()]);
    std::reverse(chain.begin(), chain.end());
    return chain;
  }

  const LoopedMesh& garment_;
  const TriangleTree surface_;
  std::vector<NamedLoop> ends_;  // what seams may begin and end on: the loops, and the seams found before
  Topology topology_;
  SurfacePaths paths_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<char> is_boundary_;
  double edge_length_;  // mean, m
};

}  // namespace

std::vector<Seam> findSeams(const std::vector<SeamRequest>& requests, LoopedMesh& garment) {
  std::vector<Seam> seams;
  if (requests.empty()) return seams;
  SeamFinder finder(garment);
  std::vector<SeamLine> lines;
  for (const SeamRequest& request : requests) {
    lines.push_back(finder.line(request));
    seams.push_back(finder.chain(request, lines.back()));
    finder.add(seams.back());
  }
  straightenSeams(seams, lines, finder.topology(), garment.mesh);
  return seams;
}

}  // namespace ease
