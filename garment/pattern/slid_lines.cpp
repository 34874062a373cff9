#include "garment/pattern/slid_lines.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "garment/seam_straightening.h"
#include "garment/surface_path.h"
#include "garment/surface_place.h"
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

/// Takes edges in a plane with this normal, turned into that of triangle s, to rest.
Mat23 toRest(const RestGarment& garment, int s, const Vec3& normal) {
  const Mat32 edges = edgeMatrix(garment.mesh.positions, garment.mesh.triangles, s);
  const Mat23 inverse = (edges.transpose() * edges).inverse() * edges.transpose();
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(normal, edges.col(0).cross(edges.col(1)));
  return garment.rest_edges[s] * inverse * turn.toRotationMatrix();
}

/// Rest edges of triangle t at the positions that its vertices slid to; `places`: on the garment as it was.
Mat2 restEdgesOf(const TriangleMesh& slid, int t, const RestGarment& garment, const SurfacePlaces& places) {
  const Mat32 edges = edgeMatrix(slid.positions, slid.triangles, t);
  const Vec3 origin = slid.positions.row(slid.triangles(t, 0)), normal = edges.col(0).cross(edges.col(1));
  Mat2 mean = Mat2::Zero();
  int count = 0, hint = t;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < 2 * (kSamples - i) - 1; ++j) {  // rows of triangles that point up and down in turn
      const double third = (j % 2 + 1) / 3.0;
      const Vec3 x = origin + edges * Eigen::Vector2d(i + third, j / 2 + third) / kSamples;
      const SurfacePlace at = places.nearest(x, kReach, hint);
      if (at.triangle < 0) continue;
      hint = at.triangle;
      mean += toRest(garment, hint, normal) * edges;
      ++count;
    }
  return count > 0 ? Mat2(mean / count) : garment.rest_edges[t];
}

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
  const SurfacePlaces places(garment.mesh);
  std::vector<int> around(n, -1);
  for (int t = 0; t < m; ++t)
    for (int k = 0; k < 3; ++k) around[mesh.triangles(t, k)] = t;
  std::vector<char> moved(n, 0);
  for (int v = 0; v < n; ++v) {
    if (mesh.positions.row(v) == garment.mesh.positions.row(v)) continue;
    const SurfacePlace at = places.nearest(mesh.positions.row(v), kReach, around[v]);
    mesh.positions.row(v) = garment.mesh.positions.row(v);
    if (at.triangle < 0) continue;
    const auto corners = mesh.triangles.row(at.triangle);
    slid.vertices[v] = {{corners[0], corners[1], corners[2]}, at.share};
    moved[v] = 1;
  }
  for (int v = 0; v < n; ++v) {
    if (!moved[v]) continue;
    const auto& [from, share] = slid.vertices[v];
    mesh.positions.row(v).setZero();
    for (int k = 0; k < 3; ++k) mesh.positions.row(v) += share[k] * garment.mesh.positions.row(from[k]);
  }
  parallelFor(m, 64, [&](int t) {
    const auto corners = mesh.triangles.row(t);
    if (moved[corners[0]] || moved[corners[1]] || moved[corners[2]])
      slid.garment.rest_edges[t] = restEdgesOf(mesh, t, garment, places);
  });
  return slid;
}

}  // namespace ease
