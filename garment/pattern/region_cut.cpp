#include "garment/pattern/region_cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "garment/pattern/region_chains.h"

namespace ease {
namespace {

constexpr double kNear = 0.25;     // of an edge: a vertex nearer to a line slides onto it
constexpr double kThinnest = 0.3;  // share of its area that a triangle keeps at least when a corner slides
constexpr double kFromEnds = 0.1;  // of an edge: least distance of a new vertex from its ends

/// A vertex near a line: share `s` of the edge to `towards`.
struct Slide {
  double distance, s;  // m, 1
  int vertex, towards;
  bool operator<(const Slide& other) const {
    return std::tie(distance, vertex, towards) < std::tie(other.distance, other.vertex, other.towards);
  }
};

class RegionCutter {
 public:
  RegionCutter(const RestGarment& garment, const Pieces& pieces, const RestSurface& surface, const RegionMap& map)
      : garment_(garment),
        pieces_(pieces),
        surface_(surface),
        map_(map),
        positions_(surface.mesh.positions),
        rest_edges_(surface.rest_edges),
        on_line_(surface.vertexCount(), 0) {
    for (int v = 0; v < garment.mesh.positions.rows(); ++v) cut_.vertices.push_back({{v, v, v}, {1.0, 0.0, 0.0}});
    for (const Seam& seam : garment.seams) addEdges(seam, seam_edges_);
  }

  CutUp operator()() {
    endOnSeams();
    slideAll();
    for (int t = 0; t < surface_.triangleCount(); ++t) split(t);
    labelTrianglesOnLines();
    finish();
    return std::move(cut_);
  }

 private:
  bool isSeam(const Edge& edge) const {
    return seam_edges_.contains(edgeKey(pieces_.glue[edge.vertex[0]], pieces_.glue[edge.vertex[1]]));
  }

  void endOnSeams() {
    for (size_t e = 0; e < surface_.topology.edges.size(); ++e)
      if (const Edge& edge = surface_.topology.edges[e]; edge.isBoundary() && isCrossed(map_, edge) && isSeam(edge))
        on_line_[edge.vertex[map_.crossing[e] < 0.5 ? 0 : 1]] = 1;
  }

  void slideAll() {
    std::vector<Slide> slides;
    for (size_t e = 0; e < surface_.topology.edges.size(); ++e) {
      const Edge& edge = surface_.topology.edges[e];
      if (!isCrossed(map_, edge) || (edge.isBoundary() && isSeam(edge))) continue;
      const double length = (positions_.row(edge.vertex[0]) - positions_.row(edge.vertex[1])).norm();
      for (const int side : {0, 1}) {
        const double s = side == 0 ? map_.crossing[e] : 1.0 - map_.crossing[e];
        const int v = edge.vertex[side];
        if (s < kNear && (!surface_.on_border[v] || edge.isBoundary()))
          slides.push_back({s * length, s, v, edge.vertex[1 - side]});
      }
    }
    std::sort(slides.begin(), slides.end());
    for (const Slide& slide : slides)
      if (!on_line_[slide.vertex] && !on_line_[slide.towards]) tryToSlide(slide);
  }

  /// Whether a vertex of the pieces is one of two sides of a seam.
  bool isOnSeam(int v) const { return surface_.on_border[v] && seamVertex(pieces_.glue[v]); }
  bool seamVertex(int v) const {
    return std::any_of(garment_.seams.begin(), garment_.seams.end(), [&](const Seam& seam) {
      return std::find(seam.vertices.begin(), seam.vertices.end(), v) != seam.vertices.end();
    });
  }

  void tryToSlide(const Slide& slide) {
    const int v = slide.vertex;
    if (isOnSeam(v)) return;
    const Vec3 from = positions_.row(v), to = (1.0 - slide.s) * from + slide.s * Vec3(positions_.row(slide.towards));
    std::vector<Mat2> changed;
    for (const int t : surface_.triangles_around[v]) {
      const int k = cornerOf(surface_.mesh.triangles, t, v);
      const Vec3 p = positions_.row(surface_.mesh.triangles(t, (k + 1) % 3)),
                 q = positions_.row(surface_.mesh.triangles(t, (k + 2) % 3));
      std::array<Vec2, 3> x = {Vec2::Zero(), rest_edges_[t].col(0), rest_edges_[t].col(1)};
      // Lengths at rest change as those in space do; the side opposite to v stays, and with it the grain.
      const Vec2 base = x[(k + 2) % 3] - x[(k + 1) % 3];
      const double to_p = (x[k] - x[(k + 1) % 3]).norm() * (to - p).norm() / std::max((from - p).norm(), 1e-300),
                   to_q = (x[k] - x[(k + 2) % 3]).norm() * (to - q).norm() / std::max((from - q).norm(), 1e-300);
      const double along = (to_p * to_p - to_q * to_q + base.squaredNorm()) / (2.0 * base.norm());
      const double height2 = to_p * to_p - along * along;
      if (!(height2 > 0.0)) return;
      const Vec2 ahead = base.normalized(), up(-ahead.y(), ahead.x());
      x[k] = x[(k + 1) % 3] + along * ahead + std::sqrt(height2) * up;
      Mat2 edges;
      edges << x[1] - x[0], x[2] - x[0];
      if (edges.determinant() < kThinnest * rest_edges_[t].determinant()) return;
      if (doubleAreaNormal(to, p, q).dot(doubleAreaNormal(from, p, q)) <
          kThinnest * doubleAreaNormal(from, p, q).squaredNorm())
        return;
      changed.push_back(edges);
    }
    for (size_t i = 0; i < changed.size(); ++i) rest_edges_[surface_.triangles_around[v][i]] = changed[i];
    positions_.row(v) = to;
    cut_.vertices[pieces_.glue[v]] = {{pieces_.glue[v], pieces_.glue[slide.towards], pieces_.glue[v]},
                                      {1.0 - slide.s, slide.s, 0.0}};
    on_line_[v] = 1;
  }

  double crossingOn(int e) const { return std::clamp(map_.crossing[e], kFromEnds, 1.0 - kFromEnds); }

  /// The new vertex on an edge.
  int vertexOn(int e) {
    const auto [found, is_new] = on_edge_.emplace(e, static_cast<int>(cut_.vertices.size()));
    if (is_new) {
      const auto [a, b] = surface_.topology.edges[e].vertex;
      const double s = crossingOn(e);
      cut_.vertices.push_back({{pieces_.glue[a], pieces_.glue[b], pieces_.glue[a]}, {1.0 - s, s, 0.0}});
    }
    return found->second;
  }

  void split(int t) {
    const auto corner = surface_.mesh.triangles.row(t);
    std::array<int, 3> labels{}, kept{};
    int off = 0;
    for (int k = 0; k < 3; ++k) {
      labels[k] = on_line_[corner[k]] ? -1 : map_.label[corner[k]];
      if (labels[k] >= 0) kept[off++] = labels[k];
    }
    std::array<int, 7> vertex = {
        pieces_.glue[corner[0]], pieces_.glue[corner[1]], pieces_.glue[corner[2]], -1, -1, -1, -1};
    std::array<Vec2, 7> x;
    x[0].setZero();
    x[1] = rest_edges_[t].col(0);
    x[2] = rest_edges_[t].col(1);
    if (off < 2 || (kept[0] == kept[1] && (off == 2 || kept[1] == kept[2]))) {
      addPart(t, vertex, x, {0, 1, 2}, off == 0 ? -1 : kept[0]);
      return;
    }
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      if (labels[i] < 0 || labels[j] < 0 || labels[i] == labels[j]) continue;
      const int e = surface_.topology.triangle_edges(t, k);
      vertex[3 + k] = vertexOn(e);
      const double s = surface_.topology.edges[e].vertex[0] == corner[i] ? crossingOn(e) : 1.0 - crossingOn(e);
      x[3 + k] = (1.0 - s) * x[i] + s * x[j];
    }
    if (off == 2) {  // the line runs from the corner on it to the opposite side
      const int k = labels[0] < 0 ? 0 : labels[1] < 0 ? 1 : 2;
      addPart(t, vertex, x, {k, (k + 1) % 3, 3 + k}, labels[(k + 1) % 3]);
      addPart(t, vertex, x, {k, 3 + k, (k + 2) % 3}, labels[(k + 2) % 3]);
      return;
    }
    const Division division = divide(labels);
    if (division.line_count == 3) {
      vertex[6] = static_cast<int>(cut_.vertices.size());
      x[6] = (x[3] + x[4] + x[5]) / 3.0;
      Mat2 edges;
      edges << x[1], x[2];
      const Vec2 beta = edges.inverse() * x[6];
      cut_.vertices.push_back({{vertex[0], vertex[1], vertex[2]}, {1.0 - beta.sum(), beta[0], beta[1]}});
    }
    for (int i = 0; i < division.part_count; ++i) {
      Division::Part part = division.parts[i];
      if (division.part_count == 3 && i == 1) {          // the other diagonal, where it is shorter
        const Division::Part& last = division.parts[2];  // parts (p, i, q) and (i, j, q) of the quadrangle p i j q
        const auto [p, a, q] = part.points;
        const int b = last.points[1];
        if ((x[p] - x[b]).norm() < (x[a] - x[q]).norm()) {
          addPart(t, vertex, x, {p, a, b}, labels[part.corner]);
          addPart(t, vertex, x, {p, b, q}, labels[part.corner]);
          break;
        }
      }
      addPart(t, vertex, x, part.points, labels[part.corner]);
    }
  }

  void addPart(int t, const std::array<int, 7>& vertex, const std::array<Vec2, 7>& x, const std::array<int, 3>& points,
               int label) {
    triangles_.push_back({vertex[points[0]], vertex[points[1]], vertex[points[2]]});
    Mat2 edges;
    edges << x[points[1]] - x[points[0]], x[points[2]] - x[points[0]];
    cut_.garment.rest_edges.push_back(edges);
    cut_.source.push_back(t);
    labels_.push_back(label);
  }

  /// A triangle with all corners on lines joins the neighbour at the longest side that has a label.
  void labelTrianglesOnLines() {
    std::map<std::array<int, 2>, std::vector<int>> beside;
    for (size_t t = 0; t < triangles_.size(); ++t)
      for (int k = 0; k < 3; ++k)
        beside[edgeKey(triangles_[t][k], triangles_[t][(k + 1) % 3])].push_back(static_cast<int>(t));
    for (bool is_done = false; !is_done;) {
      is_done = true;
      for (size_t t = 0; t < triangles_.size(); ++t) {
        if (labels_[t] >= 0) continue;
        double longest = 0.0;
        for (int k = 0; k < 3; ++k) {
          const std::array<int, 2> key = edgeKey(triangles_[t][k], triangles_[t][(k + 1) % 3]);
          const Mat2& d = cut_.garment.rest_edges[t];
          const double length = (k == 0 ? Vec2(d.col(0)) : k == 1 ? Vec2(d.col(1) - d.col(0)) : Vec2(d.col(1))).norm();
          if (length <= longest || seam_edges_.contains(key)) continue;
          for (const int other : beside[key])
            if (labels_[other] >= 0) {
              longest = length;
              labels_[t] = labels_[other];
            }
        }
        if (labels_[t] >= 0) is_done = false;
      }
    }
    for (int& label : labels_) label = std::max(label, 0);
  }

  void finish() {
    RestGarment& garment = cut_.garment;
    garment.mesh.positions.resize(static_cast<int>(cut_.vertices.size()), 3);
    for (size_t v = 0; v < cut_.vertices.size(); ++v) {
      Vec3 x = Vec3::Zero();
      for (int k = 0; k < 3; ++k)
        x += cut_.vertices[v].share[k] * garment_.mesh.positions.row(cut_.vertices[v].from[k]).transpose();
      garment.mesh.positions.row(static_cast<int>(v)) = x;
    }
    garment.mesh.triangles.resize(static_cast<int>(triangles_.size()), 3);
    for (size_t t = 0; t < triangles_.size(); ++t)
      for (int k = 0; k < 3; ++k) garment.mesh.triangles(static_cast<int>(t), k) = triangles_[t][k];
    garment.seams = garment_.seams;
    const std::vector<Seam> chains =
        chainsAlong(garment.mesh, edgesBetween(garment.mesh, labels_, seam_edges_), seam_edges_);
    garment.seams.insert(garment.seams.end(), chains.begin(), chains.end());
    std::map<std::array<int, 2>, int> on_border;
    for (const auto& [e, vertex] : on_edge_)
      if (const Edge& edge = surface_.topology.edges[e]; edge.isBoundary())
        on_border[edgeKey(pieces_.glue[edge.vertex[0]], pieces_.glue[edge.vertex[1]])] = vertex;
    for (const NamedLoop& loop : garment_.loops) {
      NamedLoop longer{loop.name, {}};
      for (size_t i = 0; i < loop.vertices.size(); ++i) {
        longer.vertices.push_back(loop.vertices[i]);
        const auto found = on_border.find(edgeKey(loop.vertices[i], loop.vertices[(i + 1) % loop.vertices.size()]));
        if (found != on_border.end()) longer.vertices.push_back(found->second);
      }
      garment.loops.push_back(longer);
    }
  }

  const RestGarment& garment_;
  const Pieces& pieces_;
  const RestSurface& surface_;
  const RegionMap& map_;
  Positions positions_;
  std::vector<Mat2> rest_edges_;
  std::vector<char> on_line_;  // by vertex of the pieces
  EdgeSet seam_edges_;
  std::map<int, int> on_edge_;  // new vertex by edge
  std::vector<std::array<int, 3>> triangles_;
  std::vector<int> labels_;  // of the triangles; -1: all corners on lines
  CutUp cut_;
};

}  // namespace

CutUp cutAlongRegions(const RestGarment& garment, const Pieces& pieces, const RestSurface& surface,
                      const RegionMap& map) {
  return RegionCutter(garment, pieces, surface, map)();
}

}  // namespace ease
