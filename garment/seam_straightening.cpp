#include "garment/seam_straightening.h"

#include <algorithm>
#include <utility>

#include "collision/triangle_tree.h"
#include "solver/base/parallel.h"
#include "solver/mesh/segment.h"

namespace ease {
namespace {

constexpr int kPasses = 30;
constexpr int kRings = 4;        // number of rings of vertices around the chains that move with them
constexpr double kReach = 0.05;  // m: largest distance of a moved vertex from the surface

/// How each vertex moves.
struct Motion {
  std::vector<std::vector<int>> mean_of;  // by vertex: it moves to the mean of these vertices; empty: it does not move
  std::vector<int> line;                  // by vertex: number of the line that it moves onto; -1: none
};

/// Plans the motion of a chain's vertices: to the middle of their neighbours in the chain, then onto its line.  Marks
/// the chain's ends, and vertices that another chain holds too, as staying.
void leadChain(const Seam& chain, int line, Motion& motion, std::vector<char>& stays) {
  const std::vector<int>& vertices = chain.vertices;
  const size_t count = vertices.size();
  for (size_t i = 0; i < count; ++i) {
    const int v = vertices[i];
    const bool is_end = !chain.is_closed && (i == 0 || i + 1 == count);
    if (is_end || motion.line[v] >= 0) stays[v] = 1;
    motion.line[v] = line;
    motion.mean_of[v] = {vertices[(i + count - 1) % count], vertices[(i + 1) % count]};
  }
}

/// Counts the edges from each vertex to the nearest chain, at most kRings + 1.
std::vector<int> ringsFromChains(const Motion& motion, const std::vector<std::vector<int>>& neighbours) {
  std::vector<int> ring(neighbours.size(), kRings + 1);
  for (size_t v = 0; v < ring.size(); ++v)
    if (motion.line[v] >= 0) ring[v] = 0;
  for (int r = 0; r < kRings; ++r)
    for (size_t v = 0; v < ring.size(); ++v)
      for (const int w : neighbours[v])
        if (ring[v] == r) ring[w] = std::min(ring[w], r + 1);
  return ring;
}

Motion planMotion(const std::vector<Seam>& seams, const std::vector<Seam>& loops, const Topology& topology,
                  std::vector<char> stays) {
  const size_t vertices = stays.size();
  const std::vector<std::vector<int>> neighbours = vertexNeighbours(topology, static_cast<int>(vertices));
  Motion motion{neighbours, std::vector<int>(vertices, -1)};
  for (size_t s = 0; s < seams.size(); ++s) leadChain(seams[s], static_cast<int>(s), motion, stays);
  const std::vector<int> ring = ringsFromChains(motion, neighbours);
  for (size_t l = 0; l < loops.size(); ++l)
    for (size_t n = loops[l].vertices.size(), i = 0; i < n; ++i) {
      const int v = loops[l].vertices[i];
      motion.line[v] = static_cast<int>(seams.size() + l);
      motion.mean_of[v] = {loops[l].vertices[(i + n - 1) % n], loops[l].vertices[(i + 1) % n]};
    }
  for (size_t v = 0; v < vertices; ++v)
    if (stays[v] || ring[v] > kRings) motion.mean_of[v].clear();
  return motion;
}

/// Moves each chain end that lies on a boundary loop to the end of its line.
void moveEnds(const std::vector<Seam>& seams, const std::vector<SeamLine>& lines, const Motion& motion, Positions& x) {
  for (size_t s = 0; s < seams.size(); ++s) {
    if (seams[s].is_closed) continue;
    const std::pair<int, Vec3> ends[] = {{seams[s].vertices.front(), lines[s].points.front()},
                                         {seams[s].vertices.back(), lines[s].points.back()}};
    for (const auto& [v, end] : ends)
      if (motion.line[v] >= static_cast<int>(seams.size())) x.row(v) = nearestOn(lines[motion.line[v]], end);
  }
}

}  // namespace

Vec3 nearestOn(const SeamLine& line, const Vec3& x) {
  Vec3 nearest = line.points.front();
  const size_t n = line.points.size();
  for (size_t i = 0; i + (line.is_closed ? 0 : 1) < n; ++i) {
    const Vec3 p = nearestOnSegment(line.points[i], line.points[(i + 1) % n], x);
    if ((p - x).squaredNorm() < (nearest - x).squaredNorm()) nearest = p;
  }
  return nearest;
}

void straightenSeams(const std::vector<Seam>& seams, std::vector<SeamLine> lines, const Topology& topology,
                     TriangleMesh& mesh, const std::vector<char>& stays) {
  const int n = static_cast<int>(mesh.positions.rows());
  const TriangleTree surface(mesh.positions, mesh.triangles);
  std::vector<Seam> loops;
  for (const std::vector<int>& loop : topology.boundary_loops) {
    loops.push_back({"", loop, true});
    lines.push_back({positionsOf(loop, mesh.positions), true});
  }
  const Motion motion = planMotion(seams, loops, topology, stays.empty() ? std::vector<char>(n, 0) : stays);
  moveEnds(seams, lines, motion, mesh.positions);
  std::vector<int> hint(n, -1);
  for (int pass = 0; pass < kPasses; ++pass) {
    const Positions before = mesh.positions;
    parallelFor(n, 64, [&](int v) {
      const std::vector<int>& around = motion.mean_of[v];
      if (around.empty()) return;
      Vec3 mean = Vec3::Zero();
      for (const int w : around) mean += before.row(w).transpose() / static_cast<double>(around.size());
      Vec3 x = 0.5 * (mean + Vec3(before.row(v)));
      if (motion.line[v] >= 0) x = nearestOn(lines[motion.line[v]], x);
      const ClosestPoint on_surface = surface.closest(x, kReach, hint[v]);
      hint[v] = on_surface.triangle;
      if (on_surface.triangle >= 0) mesh.positions.row(v) = on_surface.point;
    });
  }
}

void removeDetours(const std::vector<std::vector<int>>& neighbours, std::vector<int>& chain) {
  for (size_t i = 1; i + 1 < chain.size();) {
    const std::vector<int>& around = neighbours[chain[i - 1]];
    if (std::find(around.begin(), around.end(), chain[i + 1]) != around.end())
      chain.erase(chain.begin() + static_cast<long>(i));
    else
      ++i;
  }
}

}  // namespace ease
