#include "apps/studio/garment_maker.h"

#include <chrono>

#include "apps/pinned_vertices.h"
#include "apps/pose_files.h"
#include "apps/studio/parts.h"
#include "garment/comfort.h"
#include "garment/paint.h"
#include "solver/base/stopwatch.h"
#include "solver/mesh/topology.h"

namespace ease {

namespace {

/// The boundaries of a draft, each checked as for a garment.
std::vector<BoundaryLoop> draftLoops(const Scene& scene, const SceneInput& body, const MadeGarment* last) {
  if (!scene.garment.tools) return {};
  const TriangleMesh mesh{body.poses.front(), body.body_triangles};
  const GarmentTools& tools = *scene.garment.tools;
  // Loops of unchanged boundaries are taken over.
  const auto same = [](const LoopRequest& a, const LoopRequest& b) {
    return a.points == b.points && a.vertices == b.vertices && !a.plane && !b.plane;
  };
  std::vector<BoundaryLoop> loops;
  std::vector<LoopRequest> wanted;
  std::vector<size_t> places;
  for (const LoopRequest& request : tools.boundaries) {
    loops.push_back({request.name, {}});
    bool is_known = false;
    const bool comparable = last && last->scene.garment.tools &&
                            last->scene.garment.tools->smoothing == tools.smoothing &&
                            last->loops.size() == last->scene.garment.tools->boundaries.size();
    for (size_t k = 0; comparable && k < last->loops.size() && !is_known; ++k) {
      if (!same(request, last->scene.garment.tools->boundaries[k])) continue;
      loops.back().curve = last->loops[k].curve;
      is_known = true;
    }
    if (is_known) continue;
    places.push_back(loops.size() - 1);
    wanted.push_back(request);
  }
  if (wanted.empty()) return loops;
  const std::vector<BoundaryLoop> found = findLoops(mesh, buildTopology(mesh, "body"), wanted, tools.smoothing);
  for (size_t k = 0; k < found.size(); ++k) loops[places[k]] = found[k];
  return loops;
}

/// The mesh made before, with this scene's paint and pins.
SceneInput dressedAgain(const Scene& scene, const SceneInput& before) {
  SceneInput input = before;
  const Topology topology = buildTopology(input.garment, "garment");
  input.pins = pinnedVertices(scene, input, topology);
  input.paint.clear();
  if (!scene.garment.paint.empty()) input.paint = paintedScales(input.garment, scene.garment.paint);
  return input;
}

void nameEdges(MadeGarment& made) {
  const SceneInput& input = made.input;
  if (input.authored) {
    made.edges = input.authored->garment.loops;
    made.loops = input.authored->loops;
    for (const Seam& seam : input.authored->seams) {
      made.seams.push_back(positionsOf(seam.vertices, input.garment.positions));
      if (seam.is_closed) made.seams.back().push_back(made.seams.back().front());
    }
    return;
  }
  const Topology topology = buildTopology(input.garment, "garment");
  for (size_t k = 0; k < topology.boundary_loops.size(); ++k)
    made.edges.push_back({std::to_string(k), topology.boundary_loops[k]});
}

}  // namespace

MadeGarment makeGarment(const std::string& text, const Scene& scene, const SceneInput& body, const MadeGarment* last,
                        const Pause& pause) {
  MadeGarment made;
  std::vector<std::string> motion_warnings;
  {
    const Stopwatch stopwatch(made.seconds);
    made.scene = scene;
    made.mesh_key = meshKey(text);
    if (!last && !body.poses.empty())
      checkMotion(scene, body, [&](const std::string& warning) { motion_warnings.push_back(warning); });
    if (scene.garment.is_draft) {
      made.input = body;
      made.loops = draftLoops(scene, body, last);
    } else if (last && last->hasGarment() && last->mesh_key == made.mesh_key) {
      made.input = dressedAgain(scene, last->input);
    } else {
      made.input = readSceneInput(scene, nullptr, nullptr, pause, &body);
    }
    if (made.hasGarment()) nameEdges(made);
    made.input.warnings.insert(made.input.warnings.end(), motion_warnings.begin(), motion_warnings.end());
  }
  return made;
}

}  // namespace ease
