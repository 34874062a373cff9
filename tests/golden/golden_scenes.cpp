#include "tests/golden/golden_scenes.h"

#include <fmt/format.h>

#include <fstream>
#include <limits>
#include <numeric>

#include "apps/scene_run.h"
#include "solver/base/error.h"
#include "tests/accuracy/meshes.h"
#include "tests/collision/bodies.h"
#include "tests/sheet.h"

namespace ease {

namespace {

struct Prepared {
  Scene scene;
  SceneInput input;
  double rest_scale = 1.0;  // lengths of the rest shape over those of the start shape; below 1 the cloth starts taut
};

void addPose(Prepared& prepared, const TriangleMesh& body) {
  prepared.input.body_triangles = body.triangles;
  prepared.input.poses.push_back(body.positions);
  prepared.input.pose_names.push_back(fmt::format("pose {}", prepared.input.poses.size()));
}

void hold(Prepared& prepared, std::vector<int> vertices, bool to_body = false) {
  prepared.scene.garment.pins = {{vertices, to_body}};
  prepared.input.pins = {std::move(vertices)};
}

/// Turned about the origin, so that no vertex of the body lies just opposite to one of the cloth: there rounding would
/// decide which triangle of the body is the nearest.
TriangleMesh turned(TriangleMesh mesh, double angle, const Vec3& axis) {
  mesh.positions *= Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix().transpose();
  return mesh;
}

/// A sheet of n x n irregular cells, 0.3 m x 0.3 m, from x = 0 on and to z = 0; it faces up.
TriangleMesh levelSheet(int n) {
  TriangleMesh sheet = makeSheet(n, n, 0.3, 0.3, 0.2);
  sheet.positions.col(1).swap(sheet.positions.col(2));
  sheet.positions.col(2) *= -1.0;
  return sheet;
}

Prepared hung() {
  Prepared p;
  p.input.garment = levelSheet(9);
  hold(p, {90, 99});
  p.scene.garment.grain = {1.0, 0.0, 0.0};
  p.scene.material.bending = 1e-5;
  p.scene.material.damping_stretch = 1.0;
  p.scene.solver.time_step = 0.0025;  // with 0.005 s the rounding of `bw1` grows to 6e-7 m
  p.scene.solver.steps = 48;
  return p;
}

Prepared pressed() {
  Prepared p;
  p.input.garment = levelSheet(10);
  std::vector<int> edge;
  for (int i = 0; i < 121; ++i)
    if (i % 11 == 0 || i % 11 == 10 || i / 11 == 0 || i / 11 == 10) edge.push_back(i);
  hold(p, edge);
  p.scene.garment.grain = {1.0, 0.0, 0.0};
  p.rest_scale = 0.9;  // a taut sheet has one equilibrium; wrinkles would amplify rounding
  p.scene.material.bending = 1e-6;
  p.scene.material.damping_stretch = 2.0;
  const TriangleMesh ball = turned(bodies::sphere(0.08, 12), 0.7, {1.0, 2.0, -1.5});
  for (const double height : {-0.09, -0.05}) addPose(p, bodies::moved(ball, {0.1531, height, -0.1473}));
  p.scene.body.emplace();
  p.scene.body->poses = p.input.pose_names;
  p.scene.body->steps = 10;
  return p;
}

Prepared letOut() {
  Prepared p;
  p.input.garment = makeTube(20, 6, 0.085, 0.1);
  p.input.garment.positions.col(1).array() -= 0.05;
  TriangleMesh thick = turned(bodies::capsule(0.1, 0.08, 12), 0.037, Vec3::UnitY());
  addPose(p, thick);
  thick.positions.col(0) *= 1.2;
  thick.positions.col(2) *= 1.2;
  addPose(p, thick);
  std::vector<int> bottom(20);
  std::iota(bottom.begin(), bottom.end(), 0);
  hold(p, bottom, true);  // so that nothing slides
  p.scene.body.emplace();
  p.scene.body->poses = p.input.pose_names;
  p.scene.body->steps = 20;
  p.scene.material.damping_stretch = 2.0;
  p.scene.solver.gravity.setZero();
  p.scene.adaption = AdaptionScene{0.08, 8, 1, 16, false, AdaptionMode::sequential, {}};
  return p;
}

Prepared prepare(const std::string& scene) {
  return scene == "hung" ? hung() : scene == "pressed" ? pressed() : letOut();
}

void writeRows(std::ofstream& out, const char* what, const Positions& x) {
  out << fmt::format("{} {}\n", what, x.rows());
  for (int i = 0; i < x.rows(); ++i) out << fmt::format("{:.12f} {:.12f} {:.12f}\n", x(i, 0), x(i, 1), x(i, 2));
}

Positions readRows(std::ifstream& in, const std::string& what) {
  std::string word;
  int rows = 0;
  if (!(in >> word >> rows) || word != what || rows < 0) return {};
  Positions x(rows, 3);
  for (double& value : x.reshaped<Eigen::RowMajor>()) in >> value;
  return x;
}

double largest(const Positions& a, const Positions& b) {
  if (a.rows() != b.rows()) return std::numeric_limits<double>::infinity();
  return (a - b).cwiseAbs().maxCoeff();
}

}  // namespace

std::vector<GoldenCase> goldenCases() {
  std::vector<GoldenCase> cases;
  for (const char* scene : {"hung", "pressed", "let_out"})
    for (const char* method : {"bw1", "newton", "pd", "pd-lbfgs", "auto"}) cases.push_back({scene, method});
  return cases;
}

GoldenResult runGolden(const GoldenCase& which, double disturbance) {
  Prepared p = prepare(which.scene);
  const auto disturb = [&](Positions& x, unsigned seed) {
    x += disturbance * randomPositions(static_cast<int>(x.rows()), seed);
  };
  disturb(p.input.garment.positions, 11);
  for (Positions& pose : p.input.poses) disturb(pose, 12);
  p.scene.solver.method = methodNamed(which.method);
  p.scene.solver.tolerance = 1e-8;
  p.scene.solver.residual = 1e-5;
  Cloth cloth(p.input.garment, p.scene.garment.grain, p.scene.material);
  RestShape rest = cloth.rest();
  rest.positions *= p.rest_scale;
  for (Mat2& edges : rest.edges) edges *= p.rest_scale;
  cloth.setFirst(rest);
  p.input.offsets.assign(p.input.garment.positions.rows(), p.scene.collision.offset);
  std::optional<MovingBody> body;
  if (p.scene.body) body.emplace(movingBody(p.scene, p.input));
  const RunInput input = runInput(p.scene, p.input, body ? &*body : nullptr);
  Run run(runSettings(p.scene, adaptingSchedule(p.scene)), input, cloth);
  run.run();
  return {run.state().positions, cloth.restPositions()};
}

std::string buildName() {
  std::string name = __VERSION__;
#if defined(__AVX512F__)
  name += ", AVX-512";
#elif defined(__AVX2__)
  name += ", AVX2";
#else
  name += ", no AVX2";
#endif
#if defined(__FMA__)
  name += ", FMA";
#endif
#if !defined(__OPTIMIZE__)
  name += ", not optimised";
#endif
  return name;
}

void writeKept(const std::filesystem::path& file, const GoldenResult& result) {
  std::ofstream out(file);
  out << "build " << buildName() << '\n';
  writeRows(out, "positions_m", result.positions);
  writeRows(out, "rest_positions_m", result.rest_positions);
  out.close();
  if (!out) throw ComputationError(fmt::format("{}: cannot be written", file.string()));
}

KeptResult readKept(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string word;
  KeptResult kept;
  in >> word;
  std::getline(in >> std::ws, kept.build);
  kept.result.positions = readRows(in, "positions_m");
  kept.result.rest_positions = readRows(in, "rest_positions_m");
  if (!in) throw InputError(fmt::format("{}: expected a kept result, as script/renew_golden writes it", file.string()));
  return kept;
}

double difference(const GoldenResult& a, const GoldenResult& b) {
  return std::max(largest(a.positions, b.positions), largest(a.rest_positions, b.rest_positions));
}

}  // namespace ease
