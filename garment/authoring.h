// Makes a garment on a body: applies the tools boundary, region, extension, remeshing, seams and comfort in this order.
#pragma once

#include "garment/boundary_loop.h"
#include "garment/brush.h"
#include "garment/extension.h"
#include "garment/looped_mesh.h"
#include "garment/mesh_quality.h"
#include "garment/seam.h"
#include "solver/base/error.h"

namespace ease {

struct GarmentTools {
  std::vector<LoopRequest> boundaries;
  Vec3 seed = Vec3::Zero();  // m: a point on the part of the body that becomes cloth
  int resolution = 3000;     // number of vertices
  double edge_length = 0.0;  // m; replaces the resolution if it is above 0
  double smoothing = 0.01;   // smoothing length of loops through points, m (boundary_loop.h)
  std::vector<Extension> extensions;
  std::vector<SeamRequest> seams;
};

/// Distance that the garment keeps from the body, everywhere or by region.
struct Comfort {
  double offset = 0.005;  // m
  std::vector<Brush> regions;
};

struct AuthoredGarment {
  LoopedMesh garment;
  std::vector<BoundaryLoop> loops;  // on the body
  std::vector<Seam> seams;
  std::vector<double> offsets;     // comfort per vertex, m
  std::vector<int> body_triangle;  // body triangle under each vertex before it moved out; -1: none (extension)
  int held_vertices = 0;           // vertices between parts of the body that leave less room than two offsets
  MeshQuality quality;
  struct Times {
    double loops_s = 0.0, region_s = 0.0, extension_s = 0.0, remeshing_s = 0.0, seams_s = 0.0, comfort_s = 0.0;
    double total() const { return loops_s + region_s + extension_s + remeshing_s + seams_s + comfort_s; }
  };
  Times times;
};

/// Makes the garment on a body.  Throws InputError if a tool cannot do what was asked, ComputationError if a
/// tool fails.  `pause` is called between the tools and between the trials of remeshing.
AuthoredGarment authorGarment(const TriangleMesh& body, const GarmentTools& tools, const Comfort& comfort,
                              const Pause& pause = nullptr);

}  // namespace ease
