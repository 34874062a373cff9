// Tests that every element of the membrane must pass. Tests of a single element are in stretch_test, shear_test and
// isotropic_test.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "solver/energy/membrane.h"
#include "tests/differences.h"
#include "tests/energy/elements.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

using Mat6 = Eigen::Matrix<double, 6, 6>;

/// Scales for someGradient(): compressed, about as long as at rest, and stretched.
const std::vector<double> kScales = {0.4, 1.0, 1.6};

/// Returns F with e added to its entry k.
Mat32 moved(const Mat32& F, int k, double e) {
  Mat32 result = F;
  result.reshaped()[k] += e;
  return result;
}

}  // namespace

TEST_CASE("a membrane's stress is the derivative of its energy, stretched and compressed") {
  for (const Element& element : elements())
    for (const double scale : kScales) {
      INFO(element.name << " at " << scale);
      const Mat32 F = someGradient(scale), stress = element.stress(F);
      REQUIRE(stress.norm() > 1e-2);
      Mat32 differences;
      for (int k = 0; k < 6; ++k)
        differences.reshaped()[k] = sharpDifference([&](double e) { return element.energy(moved(F, k, e)); }, 4e-3);
      CHECK((differences - stress).norm() < 1e-9 * stress.norm());
    }
}

TEST_CASE("a membrane's exact Hessian is the derivative of its stress, projected it lacks the negative part") {
  for (const Element& element : elements())
    for (const double scale : kScales) {
      INFO(element.name << " at " << scale);
      const Mat32 F = someGradient(scale);
      const Mat6 exact = element.whole(F, HessianKind::exact);
      Mat6 differences;
      for (int k = 0; k < 6; ++k)
        differences.col(k) = sharpDifference([&](double e) { return element.stress(moved(F, k, e)); }, 4e-3).reshaped();
      CHECK((exact - differences).norm() < 1e-9 * exact.norm());
      const Eigen::SelfAdjointEigenSolver<Mat6> eigen(exact);
      const Mat6 projected =
          eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
      CHECK((element.whole(F, HessianKind::projected) - projected).norm() < 1e-9 * exact.norm());
    }
}

TEST_CASE("central differences of a membrane's energy and stress err by the square of their step") {
  Mat32 d;  // an arbitrary direction
  d << 0.3, -0.7, 0.5, 0.2, 0.6, 0.4;
  for (const Element& element : elements())
    for (const double scale : kScales) {
      INFO(element.name << " at " << scale);
      const Mat32 F = someGradient(scale);
      const double slope = element.stress(F).cwiseProduct(d).sum();
      const Eigen::Matrix<double, 6, 1> curvature = element.whole(F, HessianKind::exact) * d.reshaped();
      const auto energy = [&](double e) { return element.energy(F + e * d); };
      const auto stress = [&](double e) { return Mat32(element.stress(F + e * d)); };
      CHECK(orderOfDifference(energy, slope, 0.02) == Approx(2.0).margin(0.1));
      CHECK(orderOfDifference(stress, Mat32(curvature.reshaped(3, 2)), 0.02) == Approx(2.0).margin(0.1));
    }
}

TEST_CASE("every membrane term has a negative part where it is compressed or sheared enough") {
  for (const Element& element : elements()) {
    INFO(element.name);
    double least = 0.0;
    for (const double scale : {0.3, 1.0})
      least =
          std::min(least, Eigen::SelfAdjointEigenSolver<Mat6>(element.whole(someGradient(scale), HessianKind::exact))
                              .eigenvalues()
                              .minCoeff());
    CHECK(least < -1.0);
  }
}

TEST_CASE("eight triangles side by side are what each is alone") {
  for (const Element& element : elements()) {
    INFO(element.name);
    Deformation<Lanes> F = deformationOf<Lanes>(Mat32::Zero());
    std::vector<Mat32> each(kLanes);
    for (int l = 0; l < kLanes; ++l) {
      each[l] = someGradient(0.4 + 0.2 * l);
      F.u.x[l] = each[l](0, 0), F.u.y[l] = each[l](1, 0), F.u.z[l] = each[l](2, 0);
      F.v.x[l] = each[l](0, 1), F.v.y[l] = each[l](1, 1), F.v.z[l] = each[l](2, 1);
    }
    Deformation<Lanes> stress = deformationOf<Lanes>(Mat32::Zero());
    const Lanes energy = element.addLanes(F, stress);
    for (int l = 0; l < kLanes; ++l) {
      CHECK(energy[l] == Approx(element.energy(each[l])).epsilon(1e-12));
      CHECK(stress.u.x[l] == Approx(element.stress(each[l])(0, 0)).epsilon(1e-12));
      CHECK(stress.v.z[l] == Approx(element.stress(each[l])(2, 1)).margin(1e-10));
    }
  }
}

TEST_CASE("a rotation costs nothing, nor does it change what a stretch costs") {
  const Mat3 R = Eigen::AngleAxisd(0.8, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  for (const Element& element : elements()) {
    INFO(element.name);
    const Mat32 F = someGradient(1.2);
    CHECK(element.energy(R * F) == Approx(element.energy(F)).epsilon(1e-12));
    CHECK((element.stress(R * F) - R * element.stress(F)).norm() < 1e-10);
  }
  for (const Element& element : elements()) {
    INFO(element.name);
    CHECK((element.stress(R.leftCols<2>()).norm() < 1e-10) == element.rests);
  }
}

TEST_CASE("cloth flattened to a line or a point has a finite energy and stress") {
  Mat32 line = Mat32::Zero();
  line(0, 0) = 1.0;
  for (const Element& element : elements())
    for (const Mat32& F : {line, Mat32(Mat32::Zero())}) {
      INFO(element.name);
      CHECK(std::isfinite(element.energy(F)));
      CHECK(element.stress(F).allFinite());
      CHECK(element.whole(F, HessianKind::projected).allFinite());
    }
}

TEST_CASE(
    "projective weights bound the Hessian at rest, and count compressed threads with a mean of their stiffnesses") {
  Material woven, bw98, isotropic;
  bw98.shear_form = ShearForm::bw98;
  isotropic.membrane = Membrane::isotropic;
  isotropic.lambda = 300.0;
  Mat32 rest = Mat32::Zero();
  rest(0, 0) = rest(1, 1) = 1.0;
  for (const Material& material : {woven, bw98, isotropic}) {
    const Cloth cloth(makeSheet(1, 1, 0.1, 0.1), Vec3::UnitX(), material);
    MembraneEnergy membrane(cloth);
    membrane.begin(cloth.restPositions(), 0.01);
    const FrameHessian h = membrane.hessian(rest, 0, HessianKind::exact);
    const Eigen::Vector2d w = membrane.projectiveWeights();
    Mat6 left;
    left << w[0] * Mat3::Identity() - h.uu, -h.uv, -h.uv.transpose(), w[1] * Mat3::Identity() - h.vv;
    CHECK(Eigen::SelfAdjointEigenSolver<Mat6>(left).eigenvalues().minCoeff() > -1e-9 * w.maxCoeff());
    CHECK(membrane.projectiveWeightsAt(0.9 * rest) == w);  // as stiff compressed as stretched
  }
  Material soft;
  soft.compression = 0.25;
  const Cloth cloth(makeSheet(1, 1, 0.1, 0.1), Vec3::UnitX(), soft);
  MembraneEnergy membrane(cloth);
  membrane.begin(cloth.restPositions(), 0.01);
  Mat32 F = rest;
  F(0, 0) = 0.9;  // warp compressed, weft as at rest
  const Eigen::Vector2d w = membrane.projectiveWeightsAt(F);
  CHECK(w[0] == Approx(0.5 * soft.stretch_warp + 2.0 * soft.shear));
  CHECK(w[1] == Approx(soft.stretch_weft + 2.0 * soft.shear));
}

TEST_CASE("of the stretch stiffness, compressed cloth has the share that its material says") {
  Material material;
  material.compression = 0.1;
  const Cloth cloth(makeSheet(1, 1, 0.1, 0.1), Vec3::UnitX(), material);
  MembraneEnergy membrane(cloth);
  membrane.begin(cloth.restPositions(), 0.01);
  RestConditions rest;
  for (int lane = 0; lane < kLanes; ++lane) membrane.setRestConditions(0, lane, rest);
  for (const double stretch : {0.8, 1.2}) {
    Mat32 F = Mat32::Zero();
    F(0, 0) = stretch;
    F(1, 1) = 1.0;
    const auto lanes = [](double value) { return Lanes(Lanes::Constant(value)); };
    const Deformation<Lanes> eight{{lanes(stretch), lanes(0.0), lanes(0.0)}, {lanes(0.0), lanes(1.0), lanes(0.0)}};
    Deformation<Lanes> stress{{lanes(0.0), lanes(0.0), lanes(0.0)}, {lanes(0.0), lanes(0.0), lanes(0.0)}};
    const double stiffness = (stretch < 1.0 ? 0.1 : 1.0) * material.stretch_warp;
    CHECK(membrane.add(eight, rest, stress)[0] == Approx(0.5 * stiffness * 0.04));
    CHECK(stress.u.x[0] == Approx(stiffness * (stretch - 1.0)));
    CHECK(membrane.hessian(F, 0, HessianKind::exact).uu(0, 0) == Approx(stiffness));
  }
}
