#include "garment/authoring.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "collision/triangle_tree.h"
#include "garment/comfort.h"
#include "garment/region.h"
#include "garment/remesh.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr int kMaxVertices = 200000;

using Clock = std::chrono::steady_clock;

/// Measures the seconds since its last call, or since its start at the first call.  Every call is also a pause.
class Lap {
 public:
  explicit Lap(const Pause& pause) : pause_(pause) {}

  double operator()() {
    pauseIn(pause_);
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  const Pause& pause_;
  Clock::time_point last_ = Clock::now();
};

LoopedMesh remeshedGarment(const LoopedMesh& garment, const GarmentTools& tools, const Pause& pause) {
  int vertices = tools.resolution;
  if (tools.edge_length > 0.0) {  // vertices of a mesh of equilateral triangles: area / (sqrt(3)/2 edge^2)
    const double wanted = totalArea(garment.mesh) / (0.5 * std::sqrt(3.0) * tools.edge_length * tools.edge_length);
    if (wanted > kMaxVertices)
      throw InputError(fmt::format("edge_length = {:g}: {:.0f} vertices: expected at most {}", tools.edge_length,
                                   wanted, kMaxVertices));
    vertices = static_cast<int>(std::lround(wanted));
  }
  return withLoopNames(remeshedTo(garment.mesh, vertices, "garment", pause), garment);
}

/// Remeshes the region, then adds the extensions: their rows thus begin from evenly spaced vertices.
void addExtensions(const GarmentTools& tools, LoopedMesh& region) {
  constexpr double kShortest = 0.006, kLongest = 0.02;  // m
  const double asked =
      tools.edge_length > 0.0 ? tools.edge_length : std::sqrt(totalArea(region.mesh) / tools.resolution);
  const double edge = std::clamp(asked, kShortest, kLongest);
  region = withLoopNames(remeshed(region.mesh, edge), region);
  for (const Extension& extension : tools.extensions) extend(extension, edge, region);
}

/// Finds the body's triangle under every vertex; -1 where the vertex is further than kOnSurface from the body.
std::vector<int> trianglesUnder(const TriangleTree& body, const Positions& positions) {
  constexpr double kOnSurface = 0.01;  // m: edges of the remeshed garment cut through the body's bulges
  std::vector<int> under(positions.rows());
  parallelFor(static_cast<int>(under.size()), 256,
              [&](int v) { under[v] = body.closest(positions.row(v), kOnSurface).triangle; });
  return under;
}

}  // namespace

AuthoredGarment authorGarment(const TriangleMesh& body, const GarmentTools& tools, const Comfort& comfort,
                              const Pause& pause) {
  AuthoredGarment result;
  Lap lap(pause);
  const Topology topology = buildTopology(body, "body");
  result.loops = findLoops(body, topology, tools.boundaries, tools.smoothing);
  result.times.loops_s = lap();

  LoopedMesh region = enclosedRegion(body, topology, result.loops, tools.seed);
  result.times.region_s = lap();

  if (!tools.extensions.empty()) addExtensions(tools, region);
  result.times.extension_s = lap();

  result.garment = remeshedGarment(region, tools, pause);
  result.times.remeshing_s = lap();

  result.seams = findSeams(tools.seams, result.garment);
  result.times.seams_s = lap();

  const TriangleTree tree(body.positions, body.triangles);
  result.body_triangle = trianglesUnder(tree, result.garment.mesh.positions);
  result.offsets = comfortOffsets(result.garment.mesh.positions, comfort.offset, comfort.regions);
  result.held_vertices = moveClear(tree, result.offsets, result.garment);
  result.times.comfort_s = lap();
  result.quality = meshQuality(result.garment.mesh, tree, result.offsets);
  return result;
}

}  // namespace ease
