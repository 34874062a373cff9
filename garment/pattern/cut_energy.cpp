#include "garment/pattern/cut_energy.h"

#include <algorithm>
#include <limits>

namespace ease {
namespace {

/// A part of a cell as an element: its values are 0 at points that are no corners of the triangle.
struct Element {
  std::array<int, 3> points;        // of the cell
  std::array<int, 3> corners;       // of the triangle; -1: none
  double area = 0.0;                // m^2
  Mat32 gradients = Mat32::Zero();  // of its shape functions, one a row
};

/// The cells of a triangle and the elements of a cell, which all share its first corner of the triangle.
class Elements {
 public:
  Elements(const RestSurface& surface, const RegionLevels& levels) : surface_(surface), levels_(levels) {}

  /// Calls visit(triangle, cell, places of the cell's points, m) for all cells of these triangles.
  template <class Visit>
  void eachCell(const std::vector<int>& triangles, const Visit& visit) {
    for (const int t : triangles) {
      cells_.find(levels_, surface_.mesh.triangles, t);
      for (int i = 0; i < cells_.count(); ++i) {
        places_.clear();
        for (const CellPoint& point : cells_[i].points)
          places_.push_back(point.beta[1] * surface_.corner(t, 1) + point.beta[2] * surface_.corner(t, 2));
        visit(t, cells_[i], places_);
      }
    }
  }

  /// Calls visit(element) for the elements of a cell; there are none where it holds no corner of the triangle.
  template <class Visit>
  static void each(const Cell& cell, const std::vector<Vec2>& places, const Visit& visit) {
    const int n = static_cast<int>(cell.points.size());
    int apex = -1;
    for (int i = 0; i < n; ++i)
      if (const int c = cornerAt(cell.points[i]); c >= 0 && (apex < 0 || c < cornerAt(cell.points[apex]))) apex = i;
    for (int i = 1; apex >= 0 && i + 1 < n; ++i) {
      Element element;
      element.points = {apex, (apex + i) % n, (apex + i + 1) % n};
      for (int k = 0; k < 3; ++k) element.corners[k] = cornerAt(cell.points[element.points[k]]);
      Mat2 edges;
      edges.col(0) = places[element.points[1]] - places[apex];
      edges.col(1) = places[element.points[2]] - places[apex];
      element.area = 0.5 * edges.determinant();
      if (!(element.area > kEmpty)) continue;
      element.gradients = shapeGradients(edges.inverse());
      visit(element);
    }
  }

 private:
  static constexpr double kEmpty = 1e-16;  // m^2

  const RestSurface& surface_;
  const RegionLevels& levels_;
  Cells cells_;
  std::vector<Vec2> places_;
};

Vec3 valuesAt(const std::vector<double>& values, const Triangles& triangles, int t, const Element& element) {
  Vec3 at = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    if (element.corners[k] >= 0) at[k] = values[triangles(t, element.corners[k])];
  return at;
}

Vec3 valuesAt(const std::vector<double>& values, const Triangles& triangles, int t) {
  return {values[triangles(t, 0)], values[triangles(t, 1)], values[triangles(t, 2)]};
}

/// Mean of u^2 over a triangle with these corner values.
double meanSquare(const Vec3& u) {
  return (u.squaredNorm() + u.sum() * u.sum()) / 12.0;
}

}  // namespace

CutEnergy::CutEnergy(const RestSurface& surface, const CutWeights& weights)
    : surface_(surface),
      weights_(weights),
      scale_(1000.0 * weights.distortion / (surface.side * surface.side)),
      matrix_(surface.vertexCount(), surface.mesh.triangles),
      u_(surface.vertexCount(), 0.0),
      p_(surface.vertexCount(), 0.0) {
  for (const Mat2& edges : surface.rest_edges) stiffness_.push_back(stiffnessBlock(edges));
}

void CutEnergy::findCrossed() {
  const int n = surface_.vertexCount();
  std::vector<int> lowest(n, 0);
  for (int k = 1; k < levels_.labels; ++k)
    for (int v = 0; v < n; ++v)
      if (levels_.of(k)[v] < levels_.of(lowest[v])[v]) lowest[v] = k;
  crossed_.clear();
  whole_.clear();
  for (int t = 0; t < surface_.triangleCount(); ++t) {
    const auto corner = surface_.mesh.triangles.row(t);
    const bool is_whole = lowest[corner[0]] == lowest[corner[1]] && lowest[corner[1]] == lowest[corner[2]];
    (is_whole ? whole_ : crossed_).push_back(t);
  }
}

double CutEnergy::operator()(const RegionLevels& levels) {
  levels_ = levels;
  findCrossed();
  const Triangles& triangles = surface_.mesh.triangles;
  Elements elements(surface_, levels_);
  matrix_.clear();
  std::fill(u_.begin(), u_.end(), 0.0);
  for (const int t : whole_) {
    matrix_.add(t, stiffness_[t]);
    for (int k = 0; k < 3; ++k) u_[triangles(t, k)] -= surface_.curvature[t] * surface_.area[t] / 3.0;
  }
  double sides = 0.0;  // length of the lines, once from either side, m
  elements.eachCell(crossed_, [&](int t, const Cell& cell, const std::vector<Vec2>& places) {
    const size_t n = places.size();
    for (size_t i = 0; i < n; ++i)
      if (cell.points[i].side > 2) sides += (places[(i + 1) % n] - places[i]).norm();
    Mat3 block = Mat3::Zero();
    Elements::each(cell, places, [&](const Element& element) {
      const Mat3 stiffness = element.area * element.gradients * element.gradients.transpose();
      for (int k = 0; k < 3; ++k) {
        if (element.corners[k] < 0) continue;
        for (int l = 0; l < 3; ++l)
          if (element.corners[l] >= 0) block(element.corners[k], element.corners[l]) += stiffness(k, l);
        u_[triangles(t, element.corners[k])] -= surface_.curvature[t] * element.area / 3.0;
      }
    });
    matrix_.add(t, block);
  });
  matrix_.fix(surface_.on_border);
  if (!matrix_.factor()) return std::numeric_limits<double>::infinity();
  solve(u_);
  double integral = 0.0;
  for (const int t : whole_) integral += surface_.area[t] * meanSquare(valuesAt(u_, triangles, t));
  elements.eachCell(crossed_, [&](int t, const Cell& cell, const std::vector<Vec2>& places) {
    Elements::each(cell, places, [&](const Element& element) {
      integral += element.area * meanSquare(valuesAt(u_, triangles, t, element));
    });
  });
  length_ = 0.5 * sides;
  return scale_ * integral + 2.0 * weights_.length * length_ / surface_.side;
}

void CutEnergy::solve(std::vector<double>& x) const {
  for (size_t v = 0; v < x.size(); ++v)
    if (surface_.on_border[v]) x[v] = 0.0;
  matrix_.solve(x);
}

void CutEnergy::solveAdjoint() {
  std::fill(p_.begin(), p_.end(), 0.0);
  const Triangles& triangles = surface_.mesh.triangles;
  for (const int t : whole_) {
    const Vec3 u = valuesAt(u_, triangles, t);
    for (int k = 0; k < 3; ++k) p_[triangles(t, k)] -= scale_ * surface_.area[t] / 6.0 * (u.sum() + u[k]);
  }
  Elements elements(surface_, levels_);
  elements.eachCell(crossed_, [&](int t, const Cell& cell, const std::vector<Vec2>& places) {
    Elements::each(cell, places, [&](const Element& element) {
      const Vec3 u = valuesAt(u_, triangles, t, element);
      for (int k = 0; k < 3; ++k)
        if (element.corners[k] >= 0)
          p_[triangles(t, element.corners[k])] -= scale_ * element.area / 6.0 * (u.sum() + u[k]);
    });
  });
  solve(p_);
}

std::vector<double> CutEnergy::derivative() {
  solveAdjoint();
  std::vector<double> derivative(levels_.phi.size(), 0.0);
  std::vector<Vec2> forces;
  Elements elements(surface_, levels_);
  const Triangles& triangles = surface_.mesh.triangles;
  elements.eachCell(crossed_, [&](int t, const Cell& cell, const std::vector<Vec2>& places) {
    const size_t n = places.size();
    forces.assign(n, Vec2::Zero());
    bool is_crossed = false;
    for (size_t i = 0; i < n; ++i) {
      if (cell.points[i].side < 3) continue;
      const Vec2 pull = weights_.length / surface_.side * (places[(i + 1) % n] - places[i]).stableNormalized();
      forces[i] -= pull;
      forces[(i + 1) % n] += pull;
      is_crossed = true;
    }
    if (!is_crossed) return;
    Elements::each(cell, places, [&](const Element& element) {
      const Vec3 u = valuesAt(u_, triangles, t, element), p = valuesAt(p_, triangles, t, element);
      const Vec2 grad_u = element.gradients.transpose() * u, grad_p = element.gradients.transpose() * p;
      const double density = scale_ * meanSquare(u) + grad_p.dot(grad_u) + surface_.curvature[t] * p.sum() / 3.0;
      for (int k = 0; k < 3; ++k) {
        const Vec2 psi = element.gradients.row(k);
        forces[element.points[k]] +=
            element.area * (density * psi - grad_p.dot(psi) * grad_u - grad_u.dot(psi) * grad_p);
      }
    });
    const std::array<int, 3> corners = {triangles(t, 0), triangles(t, 1), triangles(t, 2)};
    for (size_t i = 0; i < n; ++i) {
      if (cornerAt(cell.points[i]) >= 0) continue;
      const Vec3 by_corner(0.0, forces[i].dot(surface_.corner(t, 1)), forces[i].dot(surface_.corner(t, 2)));
      addByLevels(levels_, corners, cell.label, cell.points[i], by_corner, derivative);
    }
  });
  return derivative;
}

}  // namespace ease
