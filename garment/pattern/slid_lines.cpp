#include "garment/pattern/slid_lines.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>

#include "collision/triangle_tree.h"
#include "garment/seam_straightening.h"
#include "garment/surface_path.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr double kThinnest = 0.25;          // of the quality that a triangle had (1: equilateral, 0: flat)
constexpr double kThin = 0.15;              // quality that is always good enough
constexpr double kReach = 0.02;             // m: largest distance of a slid triangle from the surface
constexpr int kSmoothings[] = {40, 15, 5};  // passes over a chain that cannot follow the shortest way
constexpr int kSamples = 3;                 // parts of an edge: a triangle is sampled at the centroids of 9 parts

using Mat23 = Eigen::Matrix<double, 2, 3>;

/// Area over that of the equilateral triangle with the same sum of squared edge lengths; negative where the triangle
/// faces away from `normal`.
double quality(const Mat32& edges, const Vec3& normal) {
  const Vec3 area = edges.col(0).cross(edges.col(1));
  const double squares = edges.squaredNorm() + (edges.col(1) - edges.col(0)).squaredNorm();
  return std::copysign(2.0 * std::sqrt(3.0) * area.norm() / squares, area.dot(normal));
}

/// The vertex of the cut mesh that is a garment's vertex in a triangle with another one.
int copyBeside(const Pieces& pieces, int v, int other) {
  for (int t = 0; t < pieces.mesh.triangles.rows(); ++t) {
    int copy = -1;
    bool has_other = false;
    for (int k = 0; k < 3; ++k) {
      const int w = pieces.mesh.triangles(t, k);
      if (pieces.glue[w] == v) copy = w;
      has_other = has_other || pieces.glue[w] == other;
    }
    if (copy >= 0 && has_other) return copy;
  }
  return -1;
}

/// The shortest way over the surface between the ends of a line, across no other line; without points where there is
/// none.
SeamLine shortestWay(const TriangleMesh& mesh, const std::vector<CutLine>& lines, size_t number) {
  std::vector<Seam> others;
  for (size_t l = 0; l < lines.size(); ++l)
    if (l != number) others.push_back(lines[l].seam);
  const Pieces pieces = cutIntoPieces(mesh, others);
  const Topology topology = buildTopology(pieces.mesh, "the pattern's pieces");
  const SurfacePaths paths(pieces.mesh, topology);
  const std::vector<int>& chain = lines[number].seam.vertices;
  const int from = copyBeside(pieces, chain.front(), chain[1]),
            to = copyBeside(pieces, chain.back(), chain[chain.size() - 2]);
  const auto way = paths.shortest(paths.nearestNodeOf(from), paths.nearestNodeOf(to));
  if (!way) return {{}, false};
  SeamLine line{{mesh.positions.row(chain.front())}, false};
  for (const int node : *way) line.points.push_back(paths.position(node));
  line.points.push_back(mesh.positions.row(chain.back()));
  return line;
}

/// The chain itself, its vertices moved to the middle of their neighbours and themselves so many times.
SeamLine smoothed(const Positions& x, const std::vector<int>& chain, int passes) {
  SeamLine line{positionsOf(chain, x), false};
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Vec3> before = line.points;
    for (size_t i = 1; i + 1 < before.size(); ++i)
      line.points[i] = 0.25 * before[i - 1] + 0.5 * before[i] + 0.25 * before[i + 1];
  }
  return line;
}

/// Whether no triangle became too thin or turned over.
bool isSound(const TriangleMesh& mesh, const Positions& before) {
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Mat32 was = edgeMatrix(before, mesh.triangles, t), is = edgeMatrix(mesh.positions, mesh.triangles, t);
    const Vec3 normal = was.col(0).cross(was.col(1));
    if (was != is && quality(is, normal) < std::min(kThin, kThinnest * quality(was, normal))) return false;
  }
  return true;
}

/// The garment before its vertices slid: what cloth lay where.
class UnslidCloth {
 public:
  explicit UnslidCloth(const RestGarment& garment)
      : garment_(garment), tree_(garment.mesh.positions, garment.mesh.triangles) {}

  /// Puts a vertex onto the surface; `around` is a triangle that is likely near.
  CutVertex place(Vec3& x, int around) const {
    const ClosestPoint at = tree_.closest(x, kReach, around);
    const int t = at.triangle >= 0 ? at.triangle : around;
    const auto corners = garment_.mesh.triangles.row(t);
    const Vec3 origin = garment_.mesh.positions.row(corners[0]);
    const Mat32 edges = edgeMatrix(garment_.mesh.positions, garment_.mesh.triangles, t);
    const Eigen::Vector2d share = edges.colPivHouseholderQr().solve((at.triangle >= 0 ? at.point : x) - origin);
    x = origin + edges * share;
    return {{corners[0], corners[1], corners[2]}, {1.0 - share.sum(), share[0], share[1]}};
  }

  /// Rest edges of triangle t at the positions that its vertices slid to.
  Mat2 restEdges(const TriangleMesh& slid, int t) const {
    const Mat32 edges = edgeMatrix(slid.positions, slid.triangles, t);
    const Vec3 origin = slid.positions.row(slid.triangles(t, 0)), normal = edges.col(0).cross(edges.col(1));
    Mat2 mean = Mat2::Zero();
    int count = 0, hint = t;
    for (int i = 0; i < kSamples; ++i)
      for (int j = 0; j < 2 * (kSamples - i) - 1; ++j) {  // rows of triangles that point up and down in turn
        const double u = (i + (j % 2 + 1) / 3.0) / kSamples, v = (j / 2 + (j % 2 + 1) / 3.0) / kSamples;
        const ClosestPoint at = tree_.closest(origin + edges * Eigen::Vector2d(u, v), kReach, hint);
        if (at.triangle < 0) continue;
        hint = at.triangle;
        mean += toRest(hint, normal) * edges;
        ++count;
      }
    return count > 0 ? Mat2(mean / count) : garment_.rest_edges[t];
  }

 private:
  /// From edges in a plane with this normal, turned into that of triangle s, to rest.
  Mat23 toRest(int s, const Vec3& normal) const {
    const Mat32 edges = edgeMatrix(garment_.mesh.positions, garment_.mesh.triangles, s);
    const Mat23 inverse = (edges.transpose() * edges).inverse() * edges.transpose();
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(normal, edges.col(0).cross(edges.col(1)));
    return garment_.rest_edges[s] * inverse * turn.toRotationMatrix();
  }

  const RestGarment& garment_;
  const TriangleTree tree_;
};

}  // namespace

CutUp slideLines(const RestGarment& garment, std::vector<CutLine>& lines) {
  const int n = static_cast<int>(garment.mesh.positions.rows()), m = static_cast<int>(garment.mesh.triangles.rows());
  CutUp slid{garment, {}, {}};
  for (int v = 0; v < n; ++v) slid.vertices.push_back({{v, v, v}, {1.0, 0.0, 0.0}});
  for (int t = 0; t < m; ++t) slid.source.push_back(t);
  const Topology topology = buildTopology(garment.mesh, "the garment");
  const std::vector<std::vector<int>> neighbours = vertexNeighbours(topology, n);
  std::vector<char> stays(n, 0);
  for (const std::vector<int>& loop : topology.boundary_loops)
    for (const int v : loop) stays[v] = 1;
  for (const CutLine& line : lines)
    for (const int v : line.seam.vertices) stays[v] = 1;
  TriangleMesh& mesh = slid.garment.mesh;
  for (size_t l = 0; l < lines.size(); ++l) {
    if (lines[l].kind == LineKind::seam) continue;
    std::vector<int>& chain = lines[l].seam.vertices;
    removeDetours(neighbours, chain);
    if (chain.size() < 3) continue;
    const Positions before = mesh.positions;
    std::vector<SeamLine> ways = {shortestWay(mesh, lines, l)};
    for (const int passes : kSmoothings) ways.push_back(smoothed(before, chain, passes));
    for (size_t i = 1; i + 1 < chain.size(); ++i) stays[chain[i]] = 0;
    for (const SeamLine& way : ways) {
      if (way.points.empty()) continue;
      straightenSeams({lines[l].seam}, {way}, topology, mesh, stays);
      if (isSound(mesh, before)) break;
      mesh.positions = before;
    }
    for (size_t i = 1; i + 1 < chain.size(); ++i) stays[chain[i]] = 1;
  }
  const UnslidCloth cloth(garment);
  std::vector<int> around(n, -1);
  for (int t = 0; t < m; ++t)
    for (int k = 0; k < 3; ++k) around[mesh.triangles(t, k)] = t;
  std::vector<char> moved(n, 0);
  for (int v = 0; v < n; ++v)
    if (mesh.positions.row(v) != garment.mesh.positions.row(v)) {
      Vec3 x = mesh.positions.row(v);
      slid.vertices[v] = cloth.place(x, around[v]);
      mesh.positions.row(v) = x;
      moved[v] = 1;
    }
  parallelFor(m, 64, [&](int t) {
    const auto corners = mesh.triangles.row(t);
    if (moved[corners[0]] || moved[corners[1]] || moved[corners[2]])
      slid.garment.rest_edges[t] = cloth.restEdges(mesh, t);
  });
  return slid;
}

}  // namespace ease
