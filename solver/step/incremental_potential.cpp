#include "solver/step/incremental_potential.h"

#include "solver/linear/parallel.h"

namespace ease {

namespace {

constexpr int kGrain = 512;

std::span<const int> flat(const Triangles& triangles) {
  return {triangles.data(), static_cast<size_t>(triangles.size())};
}

std::vector<int> edgeEnds(const std::vector<Edge>& edges) {
  std::vector<int> ends;
  for (const Edge& edge : edges) ends.insert(ends.end(), edge.vertex.begin(), edge.vertex.end());
  return ends;
}

std::vector<int> hingeCorners(const std::vector<Hinge>& hinges) {
  std::vector<int> corners;
  for (const Hinge& hinge : hinges) corners.insert(corners.end(), hinge.vertices.begin(), hinge.vertices.end());
  return corners;
}

}  // namespace

IncrementalPotential::IncrementalPotential(const Cloth& cloth)
    : cloth_(cloth),
      triangle_corners_(cloth.vertexCount(), flat(cloth.triangles())),
      edge_ends_(cloth.vertexCount(), edgeEnds(cloth.topology().edges)),
      hinge_corners_(cloth.vertexCount(), hingeCorners(cloth.hinges())),
      stress_(cloth.triangleCount()),
      contact_force_(cloth.vertexCount() + cloth.topology().edges.size() + cloth.triangleCount()),
      contact_stiffness_(contact_force_.size()),
      frame_hessian_(cloth.triangleCount()),
      hinge_hessian_(cloth.hinges().size()),
      hinge_force_(cloth.hinges().size()) {}

void IncrementalPotential::begin(const State& start, const StepOptions& options) {
  options_ = options;
  contacts_ = {};
  inertial_ = start.positions + options.h * start.velocities;
  inertial_.rowwise() += options.h * options.h * options.gravity.transpose();

  const Material& material = cloth_.material();
  if (material.damping_stretch > 0.0 || material.damping_shear > 0.0) {
    start_conditions_.resize(cloth_.triangleCount());
    parallelFor(cloth_.triangleCount(), kGrain, [&](int t) {
      const Mat32 F = cloth_.deformation(start.positions, t);
      start_conditions_[t] = {F.col(0).norm(), F.col(1).norm(), shearCondition(F)};
    });
  }
  if (material.damping_bending > 0.0) {
    start_bending_.resize(cloth_.hinges().size());
    parallelFor(static_cast<int>(start_bending_.size()), kGrain,
                [&](int e) { start_bending_[e] = hingeVector(cloth_.hinges()[e], start.positions).norm(); });
  }
}

IncrementalPotential::TriangleSprings IncrementalPotential::springs(int t) const {
  const Material& material = cloth_.material();
  TriangleSprings s{{material.stretch_warp, 1.0}, {material.stretch_weft, 1.0}, {material.shear, 0.0}};
  if (start_conditions_.empty()) return s;
  const Eigen::Vector3d& start = start_conditions_[t];
  s.warp = damped(s.warp, material.damping_stretch / options_.h, start[0]);
  s.weft = damped(s.weft, material.damping_stretch / options_.h, start[1]);
  s.shear = damped(s.shear, material.damping_shear / options_.h, start[2]);
  return s;
}

HingeSpring IncrementalPotential::hingeSpring(int e) const {
  const Material& material = cloth_.material();
  const double inverse_area = cloth_.hinges()[e].inverse_area;
  return {material.bending * inverse_area, material.damping_bending / options_.h * inverse_area,
          start_bending_.empty() ? 0.0 : start_bending_[e]};
}

double IncrementalPotential::contactArea(int sample) const {
  // Vertices, edges and triangles share the cloth's area evenly.
  const int n = cloth_.vertexCount(), e = static_cast<int>(cloth_.topology().edges.size());
  if (sample < n) return cloth_.vertexAreas()[sample] / 3.0;
  if (sample >= n + e) return cloth_.restAreas()[sample - n - e] / 3.0;
  double area = 0.0;
  for (int t : cloth_.topology().edges[sample - n].triangle)
    if (t >= 0) area += cloth_.restAreas()[t] / 9.0;
  return area;
}

Vec3 IncrementalPotential::contactPoint(const Positions& x, int sample) const {
  const int n = cloth_.vertexCount(), e = static_cast<int>(cloth_.topology().edges.size());
  if (sample < n) return x.row(sample);
  if (sample < n + e) {
    const auto [i, j] = cloth_.topology().edges[sample - n].vertex;
    return 0.5 * (x.row(i) + x.row(j));
  }
  const auto corners = cloth_.triangles().row(sample - n - e);
  return (x.row(corners[0]) + x.row(corners[1]) + x.row(corners[2])) / 3.0;
}

double IncrementalPotential::value(const Positions& x) const {
  const double inertia = parallelSum(
      cloth_.vertexCount(), [&](int i) { return cloth_.masses()[i] * (x.row(i) - inertial_.row(i)).squaredNorm(); });
  const double membrane = parallelSum(cloth_.triangleCount(), [&](int t) {
    const Mat32 F = cloth_.deformation(x, t);
    const TriangleSprings s = springs(t);
    return cloth_.restAreas()[t] *
           (stretchEnergy(F.col(0), s.warp) + stretchEnergy(F.col(1), s.weft) + shearEnergy(F, s.shear));
  });
  const double bending = parallelSum(static_cast<int>(cloth_.hinges().size()), [&](int e) {
    return bendingEnergy(hingeVector(cloth_.hinges()[e], x), hingeSpring(e));
  });
  const double contact = parallelSum(static_cast<int>(contacts_.size()), [&](int s) {
    if (contacts_[s].normal.isZero(0.0)) return 0.0;
    const double depth = contacts_[s].depth(contactPoint(x, s));
    return contactArea(s) * contactEnergy(depth, contactSpring(s));
  });
  return 0.5 / (options_.h * options_.h) * inertia + membrane + bending + contact;
}

void IncrementalPotential::contactForces(const Positions& x) {
  parallelFor(static_cast<int>(contacts_.size()), 4 * kGrain, [&](int s) {
    contact_force_[s].setZero();
    if (contacts_[s].normal.isZero(0.0)) return;
    const double depth = contacts_[s].depth(contactPoint(x, s));
    if (depth != 0.0)
      contact_force_[s] = -contactArea(s) * ease::contactPressure(depth, contactSpring(s)) * contacts_[s].normal;
  });
}

Vec3 IncrementalPotential::gatherContact(int vertex) const {
  const int n = cloth_.vertexCount(), e = static_cast<int>(cloth_.topology().edges.size());
  Vec3 edges = Vec3::Zero(), triangles = Vec3::Zero();
  for (int k : edge_ends_.of(vertex)) edges += contact_force_[n + k / 2];
  for (int k : triangle_corners_.of(vertex)) triangles += contact_force_[n + e + k / 3];
  return contact_force_[vertex] + edges / 2.0 + triangles / 3.0;
}

void IncrementalPotential::gradient(const Positions& x, Positions& gradient) {
  parallelFor(cloth_.triangleCount(), kGrain, [&](int t) {
    const Mat32 F = cloth_.deformation(x, t);
    const TriangleSprings s = springs(t);
    Mat32 stress = shearGradient(F, s.shear);
    stress.col(0) += stretchGradient(F.col(0), s.warp);
    stress.col(1) += stretchGradient(F.col(1), s.weft);
    stress_[t] = cloth_.restAreas()[t] * stress;
  });
  parallelFor(static_cast<int>(hinge_force_.size()), kGrain,
              [&](int e) { hinge_force_[e] = bendingGradient(hingeVector(cloth_.hinges()[e], x), hingeSpring(e)); });
  contactForces(x);

  const double inverse_h2 = 1.0 / (options_.h * options_.h);
  parallelFor(cloth_.vertexCount(), kGrain, [&](int i) {
    Vec3 sum = inverse_h2 * cloth_.masses()[i] * (x.row(i) - inertial_.row(i));
    for (int k : triangle_corners_.of(i))
      sum += stress_[k / 3] * shapeGradients(cloth_.restInverse()[k / 3]).row(k % 3).transpose();
    for (int k : hinge_corners_.of(i)) sum += cloth_.hinges()[k / 4].stencil[k % 4] * hinge_force_[k / 4];
    if (!contacts_.empty()) sum += gatherContact(i);
    gradient.row(i) = sum;
  });
}

void IncrementalPotential::hessian(const Positions& x, BlockMatrix& hessian) {
  const int n = cloth_.vertexCount(), e = static_cast<int>(cloth_.topology().edges.size());
  parallelFor(cloth_.triangleCount(), kGrain, [&](int t) {
    const Mat32 F = cloth_.deformation(x, t);
    const TriangleSprings s = springs(t);
    FrameHessian& h = frame_hessian_[t];
    h = shearHessian(F, s.shear);
    h.uu += stretchHessian(F.col(0), s.warp);
    h.vv += stretchHessian(F.col(1), s.weft);
    const double a = cloth_.restAreas()[t];
    h.uu *= a, h.uv *= a, h.vv *= a;
  });
  parallelFor(static_cast<int>(contacts_.size()), 4 * kGrain, [&](int s) {
    contact_stiffness_[s] = 0.0;
    if (contacts_[s].normal.isZero(0.0)) return;
    const double depth = contacts_[s].depth(contactPoint(x, s));
    if (depth != 0.0) contact_stiffness_[s] = contactArea(s) * contactStiffness(depth, contactSpring(s));
  });
  const auto addContact = [&](int s, double weight, Mat3& block) {
    if (contacts_.empty() || contact_stiffness_[s] == 0.0) return;
    const Vec3& normal = contacts_[s].normal;
    block += weight * contact_stiffness_[s] * normal * normal.transpose();
  };
  // Second derivative of triangle t's energy by its corners p, q.
  const auto triangleBlock = [&](int t, int p, int q) -> Mat3 {
    const Mat32 b = shapeGradients(cloth_.restInverse()[t]);
    const FrameHessian& h = frame_hessian_[t];
    return b(p, 0) * b(q, 0) * h.uu + b(p, 0) * b(q, 1) * h.uv + b(p, 1) * b(q, 0) * h.uv.transpose() +
           b(p, 1) * b(q, 1) * h.vv;
  };
  const auto cornerOf = [&](int t, int vertex) {
    const auto corners = cloth_.triangles().row(t);
    return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
  };

  const double inverse_h2 = 1.0 / (options_.h * options_.h);
  parallelFor(n, kGrain, [&](int i) {
    for (int k = hessian.rowBegin(i); k < hessian.rowEnd(i); ++k) {
      Mat3 block = Mat3::Zero();
      if (const int edge = hessian.edge(k); edge >= 0) {
        for (int t : cloth_.topology().edges[edge].triangle)
          if (t >= 0) {
            block += triangleBlock(t, cornerOf(t, i), cornerOf(t, hessian.column(k)));
            addContact(n + e + t, 1.0 / 9.0, block);
          }
        addContact(n + edge, 1.0 / 4.0, block);
      } else {
        block = inverse_h2 * cloth_.masses()[i] * Mat3::Identity();
        addContact(i, 1.0, block);
        for (int c : triangle_corners_.of(i)) {
          block += triangleBlock(c / 3, c % 3, c % 3);
          addContact(n + e + c / 3, 1.0 / 9.0, block);
        }
        for (int c : edge_ends_.of(i)) addContact(n + c / 2, 1.0 / 4.0, block);
      }
      hessian.block(k) = block;
    }
  });
}

void IncrementalPotential::prepareBending(const Positions& x) {
  parallelFor(static_cast<int>(hinge_hessian_.size()), kGrain,
              [&](int e) { hinge_hessian_[e] = bendingHessian(hingeVector(cloth_.hinges()[e], x), hingeSpring(e)); });
}

void IncrementalPotential::addBending(const Positions& d, Positions& product) {
  if (!bends()) return;
  parallelFor(static_cast<int>(hinge_force_.size()), kGrain,
              [&](int e) { hinge_force_[e] = hinge_hessian_[e] * hingeVector(cloth_.hinges()[e], d); });
  parallelFor(cloth_.vertexCount(), kGrain, [&](int i) {
    Vec3 sum = product.row(i);
    for (int k : hinge_corners_.of(i)) sum += cloth_.hinges()[k / 4].stencil[k % 4] * hinge_force_[k / 4];
    product.row(i) = sum;
  });
}

void IncrementalPotential::contactPressure(const Positions& x, std::vector<double>& pressure) {
  pressure.assign(cloth_.vertexCount(), 0.0);
  if (contacts_.empty()) return;
  contactForces(x);
  parallelFor(cloth_.vertexCount(), kGrain,
              [&](int i) { pressure[i] = gatherContact(i).norm() / cloth_.vertexAreas()[i]; });
}

}  // namespace ease
