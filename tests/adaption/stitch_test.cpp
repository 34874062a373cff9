#include "adaption/stitch.h"

#include <Eigen/SVD>
#include <algorithm>
#include <catch2/catch.hpp>

#include "adaption/stretch_measure.h"
#include "solver/step/time_step.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

double largestGrowth(const std::vector<Mat2>& first_inverse, const Cloth& cloth, int t) {
  const Mat2 map = cloth.restEdges()[t] * first_inverse[t];
  return principalStretch(map.transpose() * map).sigma_1;
}

Mat2 projectionOn(double angle) {
  const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
  return u * u.transpose();
}

}  // namespace

TEST_CASE("the polar factor in closed form is that of the singular value decomposition") {
  const Positions random = randomPositions(20, 9);
  for (int i = 0; i < 20; i += 2) {
    const Mat32 A = random.middleRows<2>(i).transpose();
    const Eigen::JacobiSVD<Mat32> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    CHECK((nearestRotation(A) - svd.matrixU().leftCols<2>() * svd.matrixV().transpose()).norm() < 1e-9);
  }
}

TEST_CASE("without growth the rest shape does not change") {
  const TriangleMesh mesh = makeTube(24, 10, 0.1, 0.3);
  Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
  Stitcher stitcher(cloth, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  stitcher.stitch(cloth, std::vector<Mat2>(cloth.triangleCount(), Mat2::Identity()));
  CHECK((cloth.restPositions() - mesh.positions).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("a tube that grows evenly around becomes a wider tube, and the grain stays along it") {
  const TriangleMesh mesh = makeTube(32, 12, 0.1, 0.3);
  Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
  const std::vector<Mat2> first_inverse = cloth.restInverse();
  Stitcher stitcher(cloth, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  Mat2 growth = Mat2::Identity();
  growth(1, 1) = 1.2;  // weft: around
  stitcher.stitch(cloth, std::vector<Mat2>(cloth.triangleCount(), growth));
  CHECK(foldedEdges(cloth, mesh.positions) == 0);
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    const Mat2 map = cloth.restEdges()[t] * first_inverse[t];
    CHECK(map(0, 0) == Approx(1.0).margin(0.03));
    CHECK(map(1, 1) == Approx(1.2).margin(0.04));
    CHECK(std::abs(map(0, 1)) < 0.03);
  }
}

TEST_CASE("where one patch grows, cloth far from it stays as it was") {
  const TriangleMesh mesh = makeSheet(20, 20, 1.0, 1.0);
  Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
  const std::vector<Mat2> first_inverse = cloth.restInverse();
  std::vector<Mat2> growth(cloth.triangleCount(), Mat2::Identity());
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    const double x = mesh.positions(mesh.triangles(t, 0), 0), y = mesh.positions(mesh.triangles(t, 0), 1);
    if (x < 0.15 && y < 0.15) growth[t] *= 1.3;
  }
  Stitcher stitcher(cloth, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  stitcher.stitch(cloth, growth);
  CHECK(largestGrowth(first_inverse, cloth, 0) > 1.2);
  for (int t = 0; t < cloth.triangleCount(); ++t) {
    CHECK(cloth.restAreas()[t] > 0.0);
    if (mesh.positions(mesh.triangles(t, 0), 0) > 0.7) CHECK(largestGrowth(first_inverse, cloth, t) < 1.01);
  }
}

TEST_CASE("adjacent triangles may grow by amounts as different as adaption allows without folding the rest shape") {
  // Each triangle by 2 % at a time, along a direction of its own or not at all, until some have doubled.
  const TriangleMesh mesh = makeSheet(12, 12, 0.3, 0.3, 0.2);
  Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
  Stitcher stitcher(cloth, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  std::vector<Mat2> growth(cloth.triangleCount());
  const Positions random = randomPositions(cloth.triangleCount(), 3);
  for (int round = 0; round < 35; ++round) {
    for (int t = 0; t < cloth.triangleCount(); ++t)
      growth[t] = Mat2::Identity() + (random(t, 1) > 0.0 ? 0.02 : 0.0) * projectionOn(M_PI * random(t, 0));
    stitcher.stitch(cloth, growth);
  }
  CHECK(*std::min_element(cloth.restAreas().begin(), cloth.restAreas().end()) > 0.0);
  CHECK(foldedEdges(cloth, mesh.positions) == 0);
}

TEST_CASE(
    "a stitch that folds is counted, it has triangles of positive area, and cloth with that rest shape stays finite") {
  const double most = GENERATE(10.0, 30.0);  // growth in a single step
  const TriangleMesh mesh = makeSheet(12, 12, 0.3, 0.3, 0.3);
  Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
  Stitcher stitcher(cloth, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  std::vector<Mat2> growth(cloth.triangleCount());
  for (int t = 0; t < cloth.triangleCount(); ++t)
    growth[t] = Mat2::Identity() + (most - 1.0) * projectionOn(t % 2 == 0 ? 0.0 : 0.5 * M_PI);
  stitcher.stitch(cloth, growth);
  CHECK(foldedEdges(cloth, mesh.positions) > 0);
  CHECK(*std::min_element(cloth.restAreas().begin(), cloth.restAreas().end()) > 1e-3 * 0.09 / cloth.triangleCount());
  TimeStep step(cloth, {}, systemOrdering(cloth.vertexCount(), cloth.triangles()));
  State state{mesh.positions, Positions::Zero(cloth.vertexCount(), 3)};
  for (int n = 0; n < 10; ++n) step.step(state, {}, {}, [](const Positions&, Contacts& none) { none.planes.clear(); });
  CHECK(state.positions.rowwise().norm().maxCoeff() < 10.0);
}

TEST_CASE("cloth rescaled in a patch grows or shrinks there, and nowhere else") {
  const TriangleMesh mesh = makeTube(48, 24, 0.1, 0.4);
  for (const double scale : {1.3, 0.8}) {
    Cloth cloth(mesh, Vec3(0.0, -1.0, 0.0), Material());
    const std::vector<double> first_areas = cloth.restAreas();
    std::vector<double> scales(cloth.triangleCount(), 1.0);
    double patch = 0.0, rest = 0.0, first_patch = 0.0, first_rest = 0.0;
    const auto isInPatch = [&](int t) { return std::abs(mesh.positions(mesh.triangles(t, 0), 1) - 0.2) < 0.06; };
    for (int t = 0; t < cloth.triangleCount(); ++t)
      if (isInPatch(t)) scales[t] = scale;
    Stitcher(cloth, systemOrdering(cloth.vertexCount(), cloth.triangles())).rescale(cloth, scales);
    for (int t = 0; t < cloth.triangleCount(); ++t) {
      (isInPatch(t) ? patch : rest) += cloth.restAreas()[t];
      (isInPatch(t) ? first_patch : first_rest) += first_areas[t];
    }
    INFO(scale << ": " << patch / first_patch << ", " << rest / first_rest);
    CHECK(patch / first_patch == Approx(scale * scale).epsilon(0.12));
    CHECK(rest / first_rest == Approx(1.0).epsilon(0.05));
  }
}
