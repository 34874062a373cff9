#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "tests/energy/elements.h"
#include "tests/sheet.h"

using namespace ease;

namespace {

using Mat6 = Eigen::Matrix<double, 6, 6>;

// Sheared; stretched, about as it was, or compressed.
Mat32 someGradient(double scale) {
  Mat32 F;
  F << 0.9, 0.5, 0.1, 0.8, -0.4, 0.3;
  return scale * F;
}

Mat6 differenceHessian(const Element& element, const Mat32& F) {
  Mat6 H;
  for (int k = 0; k < 6; ++k) {
    Mat32 up = F, down = F;
    up.reshaped()[k] += 1e-5;
    down.reshaped()[k] -= 1e-5;
    H.col(k) = (element.stress(up) - element.stress(down)).reshaped() / 2e-5;
  }
  return H;
}

}  // namespace

TEST_CASE("a membrane's stress is the derivative of its energy, stretched and compressed") {
  for (const Element& element : elements())
    for (const double scale : {0.4, 1.0, 1.6}) {
      INFO(element.name << " at " << scale);
      const Mat32 F = someGradient(scale), stress = element.stress(F);
      REQUIRE(stress.norm() > 1e-2);
      for (int k = 0; k < 6; ++k) {
        const auto energy = [&](double e) {
          Mat32 moved = F;
          moved.reshaped()[k] += e;
          return element.energy(moved);
        };
        CHECK(centralDifference(energy, 1e-5) == Approx(stress.reshaped()[k]).margin(1e-5));
      }
    }
}

TEST_CASE("a membrane's exact Hessian is the derivative of its stress; projected it lacks the negative part") {
  for (const Element& element : elements())
    for (const double scale : {0.4, 1.0, 1.6}) {
      INFO(element.name << " at " << scale);
      const Mat32 F = someGradient(scale);
      const Mat6 exact = element.whole(F, Curvature::exact);
      CHECK((exact - differenceHessian(element, F)).norm() < 1e-6 * exact.norm());
      const Eigen::SelfAdjointEigenSolver<Mat6> eigen(exact);
      const Mat6 projected =
          eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
      CHECK((element.whole(F, Curvature::projected) - projected).norm() < 1e-9 * exact.norm());
    }
}

TEST_CASE("every membrane term has a negative part where it is compressed or sheared enough") {
  for (const Element& element : elements()) {
    INFO(element.name);
    double least = 0.0;
    for (const double scale : {0.3, 1.0})
      least = std::min(least, Eigen::SelfAdjointEigenSolver<Mat6>(element.whole(someGradient(scale), Curvature::exact))
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
  for (const Element& element : {elements().front(), elements()[1], elements()[2], elements().back()})
    CHECK(element.stress(R.leftCols<2>()).norm() < 1e-10);
}

TEST_CASE("cloth flattened to a line or a point has a finite energy and stress") {
  Mat32 line = Mat32::Zero();
  line(0, 0) = 1.0;
  for (const Element& element : elements())
    for (const Mat32& F : {line, Mat32(Mat32::Zero())}) {
      INFO(element.name);
      CHECK(std::isfinite(element.energy(F)));
      CHECK(element.stress(F).allFinite());
      CHECK(element.whole(F, Curvature::projected).allFinite());
    }
}

TEST_CASE("both shears equal the squared cosine to second order, and the orthogonal one a distance exactly") {
  for (const double angle : {1e-2, 1e-3}) {
    Mat32 F;
    F << 1.0, std::sin(angle), 0.0, std::cos(angle), 0.0, 0.0;
    const double cosine = F.col(0).dot(F.col(1));
    for (const Element& element : {elements()[1], elements()[2]})
      CHECK(element.energy(F) == Approx(0.5 * 200.0 * cosine * cosine).epsilon(angle * angle));
  }
  // 2 dist^2 = A - sqrt(A^2 - 4 D^2), A = |f_u|^2 + |f_v|^2, D = f_u . f_v.
  const Mat32 F = someGradient(1.0);
  const double A = F.squaredNorm(), D = F.col(0).dot(F.col(1));
  CHECK(elements()[1].energy(F) == Approx(0.5 * 200.0 * (A - std::sqrt(A * A - 4.0 * D * D))).epsilon(1e-12));
}

TEST_CASE("the isotropic membrane has the modulus and Poisson ratio of its constants") {
  // Pulled along u, free across: the stress across vanishes at the width that -nu predicts.
  const double mu = 400.0, lambda = 300.0, strain = 1e-6;
  const Element element = elements().back();
  const double nu = lambda / (2.0 * mu + lambda), modulus = 4.0 * mu * (mu + lambda) / (2.0 * mu + lambda);
  Mat32 F = Mat32::Zero();
  F(0, 0) = 1.0 + strain;
  F(1, 1) = 1.0 - nu * strain;
  const Mat32 stress = element.stress(F);
  CHECK(std::abs(stress(1, 1)) < 1e-9);
  CHECK(stress(0, 0) == Approx(modulus * strain).epsilon(1e-6));
}

TEST_CASE("damping adds the force of the condition's rate") {
  const double damping_over_h = 300.0, start = 1.2, now = 1.1;
  const Spring with = damped({800.0, 1.0}, damping_over_h, start);
  Column<double> stress{0.0, 0.0, 0.0};
  addStretch(Column<double>{now, 0.0, 0.0}, with.k, with.c, stress);
  CHECK(stress.x == Approx(800.0 * (now - 1.0) + damping_over_h * (now - start)).epsilon(1e-12));
}
