#include "solver/step/incremental_potential.h"

#include <cmath>
#include <numeric>

#include "solver/linear/parallel.h"

namespace ease {

namespace {

constexpr int kGrain = 512;
constexpr int kContactBlock = 1024;  // samples
constexpr double kRoundOff = 1e-12;  // of the potential and the motion

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
      inertial_(cloth.vertexCount(), 3),
      bending_(cloth.vertexCount(), cloth.hinges()),
      triangle_corners_(cloth.vertexCount(), flat(cloth.triangles())),
      edge_ends_(cloth.vertexCount(), edgeEnds(cloth.topology().edges)),
      hinge_corners_(cloth.vertexCount(), hingeCorners(cloth.hinges())),
      lanes_((cloth.triangleCount() + kLanes - 1) / kLanes),
      corner_force_(3 * kLanes * lanes_.size()),
      contact_force_(cloth.vertexCount() + cloth.topology().edges.size() + cloth.triangleCount(), Vec3::Zero()),
      contact_hessian_(contact_force_.size()),
      pressed_(contact_force_.size()),
      frame_hessian_(cloth.triangleCount()),
      hinge_hessian_(cloth.hinges().size()),
      hinge_force_(cloth.hinges().size()) {}

void IncrementalPotential::begin(const State& start, const StepOptions& options) {
  options_ = options;
  setContacts({});
  start_ = start.positions;
  inertial_ = start.positions + options.h * start.velocities;
  inertial_.rowwise() += options.h * options.h * options.gravity.transpose();

  const Material& material = cloth_.material();
  if (rest_revision_ != cloth_.restRevision()) {
    rest_revision_ = cloth_.restRevision();
    bending_.set(cloth_.hinges(), material.bending);
  }
  bending_round_off_ = bending_.roundOff(start_);
  damping_stretch_ = material.damping_stretch / options.h;
  damping_shear_ = material.damping_shear / options.h;
  if (damping_stretch_ > 0.0 || damping_shear_ > 0.0) {
    start_conditions_.resize(cloth_.triangleCount());
    parallelFor(cloth_.triangleCount(), kGrain, [&](int t) {
      const Mat32 F = cloth_.deformation(start.positions, t);
      start_conditions_[t] = {F.col(0).norm(), F.col(1).norm(), shearCondition(F)};
    });
  }
  layOutTriangles();
  if (material.damping_bending > 0.0) {
    start_bending_.resize(cloth_.hinges().size());
    parallelFor(static_cast<int>(start_bending_.size()), kGrain,
                [&](int e) { start_bending_[e] = hingeVector(cloth_.hinges()[e], start.positions).norm(); });
  }
}

void IncrementalPotential::layOutTriangles() {
  const int m = cloth_.triangleCount();
  parallelFor(static_cast<int>(lanes_.size()), kGrain / kLanes, [&](int block) {
    TriangleLanes& lanes = lanes_[block];
    for (int l = 0; l < kLanes; ++l) {
      const int t = std::min(block * kLanes + l, m - 1);
      const TriangleSprings s = springs(t);
      for (int a = 0; a < 3; ++a) lanes.corners[a][l] = cloth_.triangles()(t, a);
      for (int k = 0; k < 4; ++k) lanes.inverse[k][l] = cloth_.restInverse()[t](k / 2, k % 2);
      lanes.area[l] = block * kLanes + l < m ? cloth_.restAreas()[t] : 0.0;
      lanes.warp[l] = s.warp.c;
      lanes.weft[l] = s.weft.c;
      lanes.shear[l] = s.shear.c;
    }
  });
}

void IncrementalPotential::setContacts(const Contacts& contacts) {
  const int count = static_cast<int>(contacts.planes.size());
  touches_ = count > 0;
  const int blocks = static_cast<int>((contact_force_.size() + kContactBlock - 1) / kContactBlock);
  contacts_.resize(blocks + 1);
  const auto add = [&](std::vector<ContactLanes>& block, int& lane, int sample, const ContactPlane& plane) {
    if (lane == kLanes) {
      block.emplace_back();
      lane = 0;
    }
    block.back().set(lane++, cloth_, sample, plane);
  };
  parallelFor(blocks, 1, [&](int b) {
    std::vector<ContactLanes>& block = contacts_[b];
    for (const ContactLanes& lanes : block)
      for (int s : lanes.sample)
        if (s >= 0) contact_force_[s].setZero();
    block.clear();
    int lane = kLanes;
    for (int s = b * kContactBlock; s < std::min(count, (b + 1) * kContactBlock); ++s)
      if (!contacts.planes[s].normal.isZero(0.0)) add(block, lane, s, contacts.planes[s]);
  });
  contacts_.back().clear();
  int lane = kLanes;
  for (const auto& [sample, plane] : contacts.seconds) add(contacts_.back(), lane, sample, plane);
}

IncrementalPotential::TriangleSprings IncrementalPotential::springs(int t) const {
  const Material& material = cloth_.material();
  TriangleSprings s{{0.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}};
  if (woven()) s = {{material.stretch_warp, 1.0}, {material.stretch_weft, 1.0}, {material.shear, 0.0}};
  if (start_conditions_.empty()) return s;
  const Eigen::Vector3d& start = start_conditions_[t];
  s.warp = damped(s.warp, damping_stretch_, start[0]);
  s.weft = damped(s.weft, damping_stretch_, start[1]);
  s.shear = damped(s.shear, damping_shear_, start[2]);
  return s;
}

HingeDamper IncrementalPotential::hingeDamper(int e) const {
  return {cloth_.material().damping_bending / options_.h * cloth_.hinges()[e].inverse_area, start_bending_[e]};
}

Vec3 IncrementalPotential::gatherContact(int vertex) const {
  const int n = cloth_.vertexCount(), e = static_cast<int>(cloth_.topology().edges.size());
  Vec3 edges = Vec3::Zero(), triangles = Vec3::Zero();
  for (int k : edge_ends_.of(vertex)) edges += contact_force_[n + k / 2];
  for (int k : triangle_corners_.of(vertex)) triangles += contact_force_[n + e + k / 3];
  return contact_force_[vertex] + edges / 2.0 + triangles / 3.0;
}

double IncrementalPotential::membraneForces(const Positions& x) {
  const Material& material = cloth_.material();
  const TriangleSprings stiffness = springs(0);  // the same for all but where they are at rest
  const bool springy = stiffness.warp.k > 0.0 || stiffness.weft.k > 0.0 || stiffness.shear.k > 0.0;
  const bool bw98 = material.shear_form == ShearForm::bw98;
  partial_.resize(lanes_.size());
  parallelFor(static_cast<int>(lanes_.size()), kGrain / kLanes, [&](int block) {
    const TriangleLanes& lanes = lanes_[block];
    Column<Lanes> corner[3];
    for (int a = 0; a < 3; ++a) gather(x, lanes.corners[a], corner[a]);
    const Column<Lanes> e1{corner[1].x - corner[0].x, corner[1].y - corner[0].y, corner[1].z - corner[0].z};
    const Column<Lanes> e2{corner[2].x - corner[0].x, corner[2].y - corner[0].y, corner[2].z - corner[0].z};
    const Lanes* D = lanes.inverse;
    const auto column = [&](int k) {
      return Column<Lanes>{e1.x * D[k] + e2.x * D[2 + k], e1.y * D[k] + e2.y * D[2 + k], e1.z * D[k] + e2.z * D[2 + k]};
    };
    const Deformation<Lanes> F{column(0), column(1)};
    const Column<Lanes> none{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
    Deformation<Lanes> stress{none, none};
    Lanes psi = Lanes::Zero();
    if (springy) {
      psi += addStretch(F.u, stiffness.warp.k, lanes.warp, stress.u);
      psi += addStretch(F.v, stiffness.weft.k, lanes.weft, stress.v);
      psi += bw98 ? addBw98Shear(F, stiffness.shear.k, lanes.shear, stress)
                  : addOrthogonalShear(F, stiffness.shear.k, lanes.shear, stress);
    }
    if (!woven()) psi += addIsotropic(F, material.mu, material.lambda, stress);
    partial_[block] = (psi * lanes.area).sum();

    // dE/dx of corners 1 and 2: a (stress) D^-T; of corner 0 what keeps the balance.
    const auto force = [&](int k) {
      const Lanes u = lanes.area * D[2 * k], v = lanes.area * D[2 * k + 1];
      return Column<Lanes>{stress.u.x * u + stress.v.x * v, stress.u.y * u + stress.v.y * v,
                           stress.u.z * u + stress.v.z * v};
    };
    const Column<Lanes> f1 = force(0), f2 = force(1);
    Vec3* out = corner_force_.data() + static_cast<size_t>(3 * kLanes) * block;
    for (int l = 0; l < kLanes; ++l) {
      out[3 * l + 1] = Vec3(f1.x[l], f1.y[l], f1.z[l]);
      out[3 * l + 2] = Vec3(f2.x[l], f2.y[l], f2.z[l]);
      out[3 * l] = -out[3 * l + 1] - out[3 * l + 2];
    }
  });
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

double IncrementalPotential::hingeDampingForces(const Positions& x) {
  if (start_bending_.empty()) return 0.0;
  partial_.resize(hinge_force_.size());
  parallelFor(static_cast<int>(hinge_force_.size()), kGrain, [&](int e) {
    const Vec3 b = hingeVector(cloth_.hinges()[e], x);
    hinge_force_[e] = hingeDampingGradient(b, hingeDamper(e));
    partial_[e] = hingeDamping(b, hingeDamper(e));
  });
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

double IncrementalPotential::contactForces(const Positions& x) {
  if (!touches_) return 0.0;
  partial_.assign(contacts_.size(), 0.0);
  const int blocks = static_cast<int>(contacts_.size()) - 1;
  const auto addBlock = [&](int b) {
    for (const ContactLanes& lanes : contacts_[b]) {
      const Lanes depth = lanes.depth(x);
      partial_[b] += (lanes.area * contactEnergy(depth, options_.contact_stiffness, lanes.give)).sum();
      const Lanes force = -lanes.area * ease::contactPressure(depth, options_.contact_stiffness, lanes.give);
      const Lanes f[3] = {force * lanes.normal[0], force * lanes.normal[1], force * lanes.normal[2]};
      for (int l = 0; l < kLanes; ++l)
        if (const int s = lanes.sample[l]; s >= 0) {
          const Vec3 one(f[0][l], f[1][l], f[2][l]);
          contact_force_[s] = b < blocks ? one : Vec3(contact_force_[s] + one);
        }
    }
  };
  parallelFor(blocks, 1, addBlock);
  addBlock(blocks);
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

double IncrementalPotential::gradient(const Positions& x, Positions& gradient) {
  const double energy = membraneForces(x) + hingeDampingForces(x) + contactForces(x);
  const double inverse_h2 = 1.0 / (options_.h * options_.h);
  const bool damps_bending = !start_bending_.empty();
  partial_.resize(cloth_.vertexCount());
  parallelFor(cloth_.vertexCount(), kGrain, [&](int i) {
    const Vec3 ahead = x.row(i) - inertial_.row(i);
    const double mass = inverse_h2 * cloth_.masses()[i];
    Vec3 sum = mass * ahead;
    partial_[i] = 0.5 * mass * ahead.squaredNorm();
    if (!bending_.empty()) partial_[i] += bending_.addRow(i, x, sum);
    for (int k : triangle_corners_.of(i)) sum += corner_force_[k];
    if (damps_bending)
      for (int k : hinge_corners_.of(i)) sum += cloth_.hinges()[k / 4].stencil[k % 4] * hinge_force_[k / 4];
    if (touches_) sum += gatherContact(i);
    gradient.row(i) = sum;
  });
  return std::accumulate(partial_.begin(), partial_.end(), energy);
}

template <class Displacement>
double IncrementalPotential::kineticOf(const Displacement& displacement) const {
  return parallelSum(cloth_.vertexCount(), [&](int i) { return cloth_.masses()[i] * displacement(i).squaredNorm(); }) /
         (options_.h * options_.h);
}

double IncrementalPotential::kinetic(const Positions& d) const {
  return kineticOf([&](int i) -> Vec3 { return d.row(i); });
}

double IncrementalPotential::motion(const Positions& x) const {
  return kineticOf([&](int i) -> Vec3 { return x.row(i) - start_.row(i); });
}

double IncrementalPotential::correction(const Positions& x) const {
  const Vec3 fall = options_.h * options_.h * options_.gravity;  // inertial_ has fallen already
  return kineticOf([&](int i) -> Vec3 { return (x.row(i) - inertial_.row(i)).transpose() + fall; });
}

double IncrementalPotential::roundOff(const Positions& x, double energy) const {
  return kRoundOff * (std::abs(energy) + motion(x)) + bending_round_off_;
}

double IncrementalPotential::totalMass() const {
  return std::accumulate(cloth_.masses().begin(), cloth_.masses().end(), 0.0);
}

Eigen::Vector2d IncrementalPotential::projectiveWeights() const {
  const TriangleSprings s = springs(0);
  const Material& material = cloth_.material();
  const double isotropic = woven() ? 0.0 : 2.0 * material.mu + material.lambda;
  return Eigen::Vector2d(s.warp.k, s.weft.k).array() + 2.0 * s.shear.k + isotropic;
}

void IncrementalPotential::contactDiagonal(const Positions& x, bool bound, std::vector<double>& diagonal) {
  diagonal.assign(cloth_.vertexCount(), 0.0);
  forPressed(x, bound, [&](const ContactLanes& touching, int lane, double stiffness) {
    for (int a = 0; a < 3; ++a) diagonal[touching.corners[a][lane]] += touching.weights[a][lane] * stiffness;
  });
}

void IncrementalPotential::contactPressure(const Positions& x, std::vector<double>& pressure) {
  pressure.assign(cloth_.vertexCount(), 0.0);
  if (!touches_) return;
  contactForces(x);
  parallelFor(cloth_.vertexCount(), kGrain, [&](int i) {
    double area = 0.0;
    for (int k : triangle_corners_.of(i)) area += triangleArea(x, cloth_.triangles(), k / 3) / 3.0;
    pressure[i] = area > 0.0 ? gatherContact(i).norm() / area : 0.0;
  });
}

}  // namespace ease
