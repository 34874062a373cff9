#include "bench/sheets.h"

#include <cmath>
#include <numbers>

#include "solver/base/error.h"
#include "solver/linear/gradient_system.h"
#include "tests/sheet.h"

namespace ease {

namespace {

constexpr double kDensity = 0.2;  // kg/m^2

// The taut sheet:
constexpr double kWiden = 1.05;
// Shaken pins:
constexpr double kTravel = 0.15;    // m, from end to end
constexpr double kFrequency = 2.0;  // Hz
// The hanging sheet:
constexpr double kNarrow = 0.9;
constexpr double kRipple = 5e-3;  // m: initial ripple, so that the sheet does not have to buckle out of a plane
// The thrown sheet:
constexpr double kThrown = 2.0;  // m/s

/// Returns the displacement of shaken pins at a time, m.  The motion starts at rest.
double shake(double time) {
  return kTravel * std::pow(std::sin(std::numbers::pi * kFrequency * time), 2);
}

Material woven(double k) {
  Material material;
  material.density = kDensity;
  material.stretch_warp = material.stretch_weft = k;
  material.shear = 0.25 * k;
  material.bending = 1e-5;
  return material;
}

std::unique_ptr<Sheet> sheetOf(const std::string& name, const TriangleMesh& mesh, const Vec3& grain,
                               const Material& material) {
  auto sheet = std::make_unique<Sheet>(
      Sheet{name, Cloth(mesh, grain, material), {}, {mesh.positions, Positions::Zero(mesh.positions.rows(), 3)}, {}});
  sheet->ordering = systemOrdering(sheet->cloth.vertexCount(), sheet->cloth.triangles());
  return sheet;
}

/// Pins the vertices at their start positions and shakes them along `direction`.
void holdShaken(Sheet& sheet, std::vector<int> vertices, const Vec3& direction) {
  std::vector<Vec3> places;
  for (int v : vertices) places.push_back(sheet.start.positions.row(v));
  sheet.hold = [vertices = std::move(vertices), places = std::move(places), direction](double time, Pins& pins) {
    pins.vertices = vertices;
    pins.positions = places;
    for (Vec3& place : pins.positions) place += shake(time) * direction;
  };
}

/// Makes the mesh of drape-2pin: vertex i side + j is at (j, 0, i)/(side - 1), and diagonals alternate.
TriangleMesh drapeMesh(int side) {
  TriangleMesh mesh;
  mesh.positions.resize(side * side, 3);
  mesh.triangles.resize(2 * (side - 1) * (side - 1), 3);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) mesh.positions.row(i * side + j) << j / (side - 1.0), 0.0, i / (side - 1.0);
  int t = 0;
  for (int i = 0; i + 1 < side; ++i)
    for (int j = 0; j + 1 < side; ++j) {
      const int diagonal = i % 2 == j % 2 ? 1 : 0, a = i * side + j, below = a + side;
      mesh.triangles.row(t++) << a, a + 1, below + diagonal;
      mesh.triangles.row(t++) << below + 1, below, a + 1 - diagonal;
    }
  return mesh;
}

}  // namespace

std::unique_ptr<Sheet> makeTautSheet(int side, double k) {
  TriangleMesh mesh = makeSheet(side - 1, side - 1, 1.0, 1.0);
  mesh.positions.col(2) = -mesh.positions.col(1);
  mesh.positions.col(1).setZero();
  auto sheet = sheetOf("taut", mesh, Vec3::UnitX(), woven(k));
  sheet->start.positions *= kWiden;
  std::vector<int> edges;
  for (int v = 0; v < side * side; ++v)
    if (v / side == 0 || v / side == side - 1 || v % side == 0 || v % side == side - 1) edges.push_back(v);
  holdShaken(*sheet, std::move(edges), Vec3::UnitY());
  return sheet;
}

std::unique_ptr<Sheet> makeHangingSheet(int side, double k) {
  const TriangleMesh mesh = makeSheet(side - 1, side - 1, 1.0, 1.0);
  auto sheet = sheetOf("hanging", mesh, -Vec3::UnitY(), woven(k));
  Positions& x = sheet->start.positions;
  for (int v = 0; v < x.rows(); ++v) x(v, 2) = kRipple * std::sin(5.0 * std::numbers::pi * x(v, 0));
  x.col(0) *= kNarrow;
  holdShaken(*sheet, {side * (side - 1), side * side - 1}, Vec3::UnitZ());
  return sheet;
}

std::unique_ptr<Sheet> makeThrownSheet(int side, double k) {
  auto sheet = sheetOf("thrown", makeSheet(side - 1, side - 1, 1.0, 1.0), -Vec3::UnitY(), woven(k));
  sheet->start.velocities.col(2).setConstant(kThrown);
  sheet->hold = [](double, Pins&) {};
  return sheet;
}

std::unique_ptr<Sheet> makeDrape2Pin(int side, double k) {
  Material material;
  material.density = kDensity;
  material.membrane = Membrane::isotropic;
  material.mu = 0.5 * k;
  material.lambda = 0.0;
  material.bending = 3e-5;  // 1e-5 in the usual hinge form (bending.h)
  auto sheet = sheetOf("drape-2pin", drapeMesh(side), Vec3::UnitX(), material);
  const std::vector<int> corners = {0, side - 1};
  sheet->hold = [corners, start = sheet->start.positions](double, Pins& pins) {
    pins.vertices = corners;
    pins.positions.clear();
    for (int v : corners) pins.positions.push_back(start.row(v));
  };
  return sheet;
}

std::unique_ptr<Sheet> makeSheetNamed(const std::string& name, int side, double k) {
  if (name == "taut") return makeTautSheet(side, k);
  if (name == "hanging") return makeHangingSheet(side, k);
  if (name == "thrown") return makeThrownSheet(side, k);
  if (name == "drape-2pin") return makeDrape2Pin(side, k);
  throw InputError("no sheet \"" + name + "\": expected taut, hanging, thrown or drape-2pin");
}

void findNoContacts(const Positions&, Contacts& contacts) {
  contacts = {};
}

}  // namespace ease
