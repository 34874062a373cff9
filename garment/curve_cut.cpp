#include "garment/curve_cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "solver/base/error.h"

namespace ease {
namespace {

using Polygon = std::vector<int>;  // vertices, counter-clockwise

/// Part of a curve that crosses one triangle, from border to border.
struct Chord {
  int from, to;  // vertices
  int curve;
};

/// Smallest height of triangle (a, b, c), m: the one on its longest side.
double leastHeight(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return longest > 0.0 ? doubleAreaNormal(a, b, c).norm() / longest : 0.0;
}

class Cutter {
 public:
  Cutter(const TriangleMesh& mesh, const Topology& topology, const std::vector<BoundaryLoop>& loops)
      : mesh_(mesh), topology_(topology), loops_(loops) {
    for (const auto& x : mesh.positions.rowwise()) positions_.push_back(x.transpose());
  }

  CutMesh operator()() {
    addCurves();
    for (auto& [edge, points] : on_edge_) sortAlong(points);
    for (int t = 0; t < mesh_.triangles.rows(); ++t) cutTriangle(t);
    result_.mesh.positions.resize(positions_.size(), 3);
    for (size_t v = 0; v < positions_.size(); ++v) result_.mesh.positions.row(v) = positions_[v];
    result_.mesh.triangles.resize(triangles_.size(), 3);
    for (size_t t = 0; t < triangles_.size(); ++t)
      result_.mesh.triangles.row(t) << triangles_[t][0], triangles_[t][1], triangles_[t][2];
    return std::move(result_);
  }

 private:
  struct OnEdge {
    double t;
    int vertex, curve;
  };

  void addCurves() {
    for (size_t c = 0; c < loops_.size(); ++c) {
      const EdgeCurve& curve = loops_[c].curve;
      const std::vector<Vec3> points = placed(curve, mesh_.positions);
      const int first = static_cast<int>(positions_.size()), n = static_cast<int>(points.size());
      result_.curves.emplace_back();
      for (int i = 0; i < n; ++i) {
        positions_.push_back(points[i]);
        result_.curves.back().push_back(first + i);
        on_edge_[curve.points[i].edge].push_back({curve.points[i].t, first + i, static_cast<int>(c)});
        if (i + 1 < n || curve.is_closed)
          chords_[triangleBetween(curve.points[i].edge, curve.points[(i + 1) % n].edge)].push_back(
              {first + i, first + (i + 1) % n, static_cast<int>(c)});
      }
    }
  }

  int triangleBetween(int edge, int other) const {
    for (const int t : topology_.edges[edge].triangle)
      if (t >= 0 && (topology_.triangle_edges.row(t).array() == other).any()) return t;
    return -1;
  }

  void sortAlong(std::vector<OnEdge>& points) const {
    std::sort(points.begin(), points.end(), [](const OnEdge& p, const OnEdge& q) { return p.t < q.t; });
    for (size_t i = 0; i + 1 < points.size(); ++i)
      if (points[i].t == points[i + 1].t) refuseCrossing(points[i].curve, points[i + 1].curve);
  }

  [[noreturn]] void refuseCrossing(int p, int q) const {
    throw InputError(fmt::format("boundaries '{}' and '{}' cross or touch: expected loops that share no point",
                                 loops_[std::min(p, q)].name, loops_[std::max(p, q)].name));
  }

  /// Lists the triangle's corners and the curve points on its edges counter-clockwise.
  Polygon outline(int t) const {
    Polygon outline;
    for (int k = 0; k < 3; ++k) {
      const int a = mesh_.triangles(t, k);
      outline.push_back(a);
      const int edge = topology_.triangle_edges(t, (k + 2) % 3);  // from corner k to k + 1
      const auto found = on_edge_.find(edge);
      if (found == on_edge_.end()) continue;
      const size_t before = outline.size();
      for (const OnEdge& p : found->second) outline.push_back(p.vertex);
      if (topology_.edges[edge].vertex[0] != a)
        std::reverse(outline.begin() + static_cast<long>(before), outline.end());
    }
    return outline;
  }

  void cutTriangle(int t) {
    std::vector<Polygon> pieces = {outline(t)};
    const auto passing = chords_.find(t);
    for (size_t i = 0; passing != chords_.end() && i < passing->second.size(); ++i)
      split(pieces, passing->second, passing->second[i]);
    for (Polygon& piece : pieces) triangulate(piece, t);
  }

  void split(std::vector<Polygon>& pieces, const std::vector<Chord>& chords, const Chord& chord) const {
    for (Polygon& piece : pieces) {
      const auto from = std::find(piece.begin(), piece.end(), chord.from);
      if (from == piece.end()) continue;
      std::rotate(piece.begin(), from, piece.end());
      const auto to = std::find(piece.begin(), piece.end(), chord.to);
      if (to == piece.end()) continue;
      Polygon rest(to, piece.end());
      rest.push_back(chord.from);
      piece.erase(to + 1, piece.end());
      pieces.push_back(std::move(rest));
      return;
    }
    for (const Chord& other : chords)
      if (other.curve != chord.curve) refuseCrossing(other.curve, chord.curve);
    refuseCrossing(chord.curve, chord.curve);
  }

  /// Triangulates the polygon: repeatedly cuts off the ear whose smallest height is largest.
  void triangulate(Polygon& polygon, int t) {
    while (polygon.size() >= 3) {
      const int n = static_cast<int>(polygon.size());
      int best = 0;
      double most = -1.0;
      for (int i = 0; i < n; ++i) {
        const double height =
            leastHeight(positions_[polygon[i]], positions_[polygon[(i + 1) % n]], positions_[polygon[(i + 2) % n]]);
        if (height <= most) continue;
        most = height;
        best = i;
      }
      triangles_.push_back({polygon[best], polygon[(best + 1) % n], polygon[(best + 2) % n]});
      result_.source.push_back(t);
      polygon.erase(polygon.begin() + (best + 1) % n);
    }
  }

  const TriangleMesh& mesh_;
  const Topology& topology_;
  const std::vector<BoundaryLoop>& loops_;
  std::vector<Vec3> positions_;
  std::vector<std::array<int, 3>> triangles_;
  std::map<int, std::vector<OnEdge>> on_edge_;
  std::map<int, std::vector<Chord>> chords_;  // by triangle
  CutMesh result_;
};

}  // namespace

CutMesh cutAlong(const TriangleMesh& mesh, const Topology& topology, const std::vector<BoundaryLoop>& loops) {
  return Cutter(mesh, topology, loops)();
}

}  // namespace ease
