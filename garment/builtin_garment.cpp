#include "garment/builtin_garment.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "collision/body/iso_surface.h"
#include "collision/body/mannequin_shape.h"
#include "garment/garment_fit.h"
#include "garment/plane_cut.h"
#include "garment/remesh.h"
#include "solver/base/error.h"

namespace ease {
namespace {

constexpr double kWidestOffset = 0.05;  // m
constexpr double kBeyondCut = 0.025;    // m: the surface reaches this far past the planes before it is cut

/// Shape of a garment: what is added to the body, and where the result is cut.
struct GarmentShape {
  Limb filler;        // shape added to the body: bridges the hollow of the back, or forms the skirt
  double blend;       // width of the rounded joint of body and filler, m
  double hem;         // height y of the hem, m
  Vec3 lower, upper;  // corners of a box that holds the garment, m
};

constexpr double kArmHeight = 1.385, kSleeve = 0.30;                                  // |x| of the sleeves' ends, m
constexpr double kEaseAtShoulder = 0.001, kEaseAtHem = 0.003, kEaseAtSleeve = 0.001;  // m beyond the offset

GarmentShape findShape(const std::string& name) {
  const Vec3 deep = Vec3::UnitZ();
  if (name == "t-shirt")
    return {taperedLimb({0, 0.98, 0.002}, {0, 1.20, 0.002}, 0.140, 0.130, deep, 0.72),
            0.05,
            0.86,
            {-0.44, 0.80, -0.32},
            {0.44, 1.64, 0.32}};
  if (name == "dress")
    return {taperedLimb({0, 1.08, 0.002}, {0, 0.38, 0.0}, 0.126, 0.300, deep, 0.80),
            0.05,
            0.50,
            {-0.44, 0.44, -0.38},
            {0.44, 1.64, 0.38}};
  throw InputError(fmt::format("there is no built-in garment \"{}\"; there are \"t-shirt\" and \"dress\"", name));
}

/// Planes that cut the garment at neck, sleeves and hem.  The neck's plane leans forward and rises with the offset, so
/// that it passes above the shoulders.  The sleeves' planes lean so that they pass beside a skirt.
std::vector<Plane> cutsOf(const GarmentShape& garment_shape, double offset) {
  constexpr double kLean = 0.25;
  return {{{0.0, 1.47 + offset, 0.0}, Vec3(0.0, 0.90, 0.44).normalized()},
          {{kSleeve, kArmHeight, 0.0}, Vec3(1.0, kLean, 0.0).normalized()},
          {{-kSleeve, kArmHeight, 0.0}, Vec3(-1.0, kLean, 0.0).normalized()},
          {{0.0, garment_shape.hem, 0.0}, -Vec3::UnitY()}};
}

/// Distance that the garment keeps at `x` in addition to the offset, m: least at the shoulders, most at the hem.
double easeAt(const GarmentShape& garment_shape, const Vec3& x) {
  constexpr double kShoulderWidth = 0.17;
  const double down = std::clamp((kArmHeight - x.y()) / (kArmHeight - garment_shape.hem), 0.0, 1.0);
  const double out = std::clamp((std::abs(x.x()) - kShoulderWidth) / (kSleeve - kShoulderWidth), 0.0, 1.0);
  return kEaseAtShoulder + down * (kEaseAtHem - kEaseAtShoulder) + out * (kEaseAtSleeve - kEaseAtShoulder);
}

/// Signed distance to the garment as a closed shape, before it is cut.
DistanceField garmentField(const GarmentShape& garment_shape, double offset) {
  return [=](const Vec3& x) {
    Distance shape = smoothUnion(mannequinDistance(x), limbDistance(garment_shape.filler, x), garment_shape.blend);
    shape.value -= offset + easeAt(garment_shape, x);
    return shape;
  };
}

TriangleMesh cutGarment(const DistanceField& field, const GarmentShape& garment_shape, const std::vector<Plane>& cuts,
                        double voxel) {
  const DistanceField ended = [&](const Vec3& x) {
    Distance shape = field(x);
    for (const Plane& cut : cuts)
      shape = smoothIntersection(shape, {planeDistance(cut, x) - kBeyondCut, cut.normal}, 0.0);
    return shape;
  };
  TriangleMesh mesh = isoSurface(ended, garment_shape.lower, garment_shape.upper, voxel);
  for (const Plane& cut : cuts) mesh = cutByPlane(mesh, cut, 0.25 * voxel);
  return mesh;
}

}  // namespace

TriangleMesh builtinGarment(const std::string& name, int vertices, double offset, const BodyMeasures& measures) {
  const GarmentShape garment_shape = findShape(name);
  if (vertices < kMinBuiltinVertices || vertices > kMaxBuiltinVertices)
    throw InputError(fmt::format("vertices = {}: expected {} to {} for the built-in garment '{}'", vertices,
                                 kMinBuiltinVertices, kMaxBuiltinVertices, name));
  if (!(offset >= 0.0 && offset <= kWidestOffset))
    throw InputError(
        fmt::format("builtin = '{}': [collision] offset = {:g} m: expected 0 to {:g} m", name, offset, kWidestOffset));

  const BodySize size(measures);
  const double own_offset = offset / size.minScale();  // on the mannequin's own size: at least `offset` in this one
  const DistanceField field = garmentField(garment_shape, own_offset);
  const std::vector<Plane> cuts = cutsOf(garment_shape, own_offset);
  const double rough_edge = std::sqrt(1.0 / vertices);  // m: edge length for about a square metre of cloth
  const TriangleMesh uniform = cutGarment(field, garment_shape, cuts, std::clamp(rough_edge, 0.006, 0.016));
  TriangleMesh garment = remeshedTo(uniform, vertices, fmt::format("built-in garment \"{}\"", name));
  settleOnSurface(field, cuts, garment);
  keepClear(mannequinDistance, cuts, own_offset, garment);
  for (int v = 0; v < garment.positions.rows(); ++v)
    garment.positions.row(v) = size.height() * size.warped(garment.positions.row(v));
  return garment;
}

}  // namespace ease
