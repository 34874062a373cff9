#include "solver/step/incremental_potential.h"

#include <numeric>

#include "solver/linear/parallel.h"

namespace ease {

namespace {

constexpr int kGrain = 512;
constexpr int kContactBlock = 1024;  // samples

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

// Positions of eight vertices, side by side.
void gather(const Positions& x, const int (&vertices)[kLanes], Column<Lanes>& out) {
  for (int l = 0; l < kLanes; ++l) {
    const double* position = x.data() + 3 * vertices[l];
    out.x[l] = position[0];
    out.y[l] = position[1];
    out.z[l] = position[2];
  }
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
      contact_normal_(contact_force_.size()),
      contact_stiffness_(contact_force_.size()),
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

void IncrementalPotential::setContacts(std::span<const ContactPlane> planes) {
  const int count = static_cast<int>(planes.size());
  touches_ = count > 0;
  contacts_.resize((contact_force_.size() + kContactBlock - 1) / kContactBlock);
  parallelFor(static_cast<int>(contacts_.size()), 1, [&](int b) {
    std::vector<ContactLanes>& block = contacts_[b];
    for (const ContactLanes& lanes : block)
      for (int s : lanes.sample)
        if (s >= 0) contact_force_[s].setZero();
    block.clear();
    int lane = kLanes;
    for (int s = b * kContactBlock; s < std::min(count, (b + 1) * kContactBlock); ++s) {
      if (planes[s].normal.isZero(0.0)) continue;
      if (lane == kLanes) {
        block.emplace_back();
        lane = 0;
      }
      setLane(block.back(), lane++, s, planes[s]);
    }
  });
}

IncrementalPotential::ContactLanes::ContactLanes() {
  for (int l = 0; l < kLanes; ++l) {
    sample[l] = -1;
    for (int a = 0; a < 3; ++a) corners[a][l] = 0;
  }
  for (int a = 0; a < 3; ++a) weights[a] = normal[a] = Lanes::Zero();
  offset = least = area = Lanes::Zero();
  give = Lanes::Ones();
}

void IncrementalPotential::setLane(ContactLanes& lanes, int lane, int s, const ContactPlane& plane) {
  const int n = cloth_.vertexCount(), e = static_cast<int>(cloth_.topology().edges.size());
  int corner[3] = {s, s, s}, count = 1;
  if (s >= n + e) {
    count = 3;
    for (int a = 0; a < 3; ++a) corner[a] = cloth_.triangles()(s - n - e, a);
  } else if (s >= n) {
    count = 2;
    corner[0] = corner[2] = cloth_.topology().edges[s - n].vertex[0];
    corner[1] = cloth_.topology().edges[s - n].vertex[1];
  }
  lanes.sample[lane] = s;
  for (int a = 0; a < 3; ++a) {
    lanes.corners[a][lane] = corner[a];
    lanes.weights[a][lane] = a < count ? 1.0 / count : 0.0;
    lanes.normal[a][lane] = plane.normal[a];
  }
  lanes.offset[lane] = plane.offset;
  lanes.give[lane] = plane.give;
  lanes.least[lane] = plane.held ? -1e3 : 0.0;
  lanes.area[lane] = contactArea(s);
  contact_normal_[s] = plane.normal;
}

Lanes IncrementalPotential::ContactLanes::depth(const Positions& x) const {
  Lanes height = Lanes::Zero();  // along the normal
  for (int a = 0; a < 3; ++a) {
    Column<Lanes> corner;
    gather(x, corners[a], corner);
    height += weights[a] * (corner.x * normal[0] + corner.y * normal[1] + corner.z * normal[2]);
  }
  return (offset - height).max(least);
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
  parallelFor(static_cast<int>(contacts_.size()), 1, [&](int b) {
    for (const ContactLanes& lanes : contacts_[b]) {
      const Lanes depth = lanes.depth(x);
      partial_[b] += (lanes.area * contactEnergy(depth, options_.contact_stiffness, lanes.give)).sum();
      const Lanes force = -lanes.area * ease::contactPressure(depth, options_.contact_stiffness, lanes.give);
      const Lanes f[3] = {force * lanes.normal[0], force * lanes.normal[1], force * lanes.normal[2]};
      for (int l = 0; l < kLanes; ++l)
        if (const int s = lanes.sample[l]; s >= 0) contact_force_[s] = Vec3(f[0][l], f[1][l], f[2][l]);
    }
  });
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

// Calls add(lanes, lane, stiffness) for each sample that is pressed at x, or (bound) could be, one after the other;
// N/m.
template <class Add>
void IncrementalPotential::forPressed(const Positions& x, bool bound, const Add& add) const {
  for (const std::vector<ContactLanes>& block : contacts_)
    for (const ContactLanes& lanes : block) {
      Lanes depth = lanes.depth(x);
      if (bound) depth = depth.max(lanes.give);
      for (int l = 0; l < kLanes; ++l)
        if (lanes.sample[l] >= 0 && depth[l] != 0.0)
          add(lanes, l, lanes.area[l] * contactStiffness(depth[l], options_.contact_stiffness, lanes.give[l]));
    }
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
    if (!bending_.empty()) {
      const Vec3 bending = bending_.row(i, x);
      sum += bending;
      partial_[i] += 0.5 * x.row(i).dot(bending);
    }
    for (int k : triangle_corners_.of(i)) sum += corner_force_[k];
    if (damps_bending)
      for (int k : hinge_corners_.of(i)) sum += cloth_.hinges()[k / 4].stencil[k % 4] * hinge_force_[k / 4];
    if (touches_) sum += gatherContact(i);
    gradient.row(i) = sum;
  });
  return std::accumulate(partial_.begin(), partial_.end(), energy);
}

double IncrementalPotential::motion(const Positions& x) const {
  const double sum = parallelSum(cloth_.vertexCount(),
                                 [&](int i) { return cloth_.masses()[i] * (x.row(i) - start_.row(i)).squaredNorm(); });
  return sum / (options_.h * options_.h);
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

void IncrementalPotential::hessian(const Positions& x, Curvature kind, BlockMatrix& hessian) {
  const int n = cloth_.vertexCount(), edge_count = static_cast<int>(cloth_.topology().edges.size());
  parallelFor(cloth_.triangleCount(), kGrain, [&](int t) {
    const Mat32 F = cloth_.deformation(x, t);
    const TriangleSprings s = springs(t);
    FrameHessian& h = frame_hessian_[t];
    h = woven() ? FrameHessian() : isotropicHessian(F, cloth_.material().mu, cloth_.material().lambda, kind);
    if (s.shear.k > 0.0) {
      const bool bw98 = cloth_.material().shear_form == ShearForm::bw98;
      const FrameHessian shear = bw98 ? bw98ShearHessian(F, s.shear, kind) : orthogonalShearHessian(F, s.shear, kind);
      h.uu += shear.uu, h.uv += shear.uv, h.vv += shear.vv;
    }
    h.uu += stretchHessian(F.col(0), s.warp, kind);
    h.vv += stretchHessian(F.col(1), s.weft, kind);
    const double a = cloth_.restAreas()[t];
    h.uu *= a, h.uv *= a, h.vv *= a;
  });
  if (!start_bending_.empty())
    parallelFor(static_cast<int>(hinge_hessian_.size()), kGrain, [&](int e) {
      hinge_hessian_[e] = hingeDampingHessian(hingeVector(cloth_.hinges()[e], x), hingeDamper(e), kind);
    });
  std::fill(contact_stiffness_.begin(), contact_stiffness_.end(), 0.0);
  forPressed(x, false, [&](const ContactLanes& touching, int lane, double stiffness) {
    contact_stiffness_[touching.sample[lane]] = stiffness;
  });
  const auto addContact = [&](int s, double weight, Mat3& block) {
    if (!touches_ || contact_stiffness_[s] == 0.0) return;
    const Vec3& normal = contact_normal_[s];
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
            addContact(n + edge_count + t, 1.0 / 9.0, block);
          }
        addContact(n + edge, 1.0 / 4.0, block);
      } else {
        block = inverse_h2 * cloth_.masses()[i] * Mat3::Identity();
        addContact(i, 1.0, block);
        for (int c : triangle_corners_.of(i)) {
          block += triangleBlock(c / 3, c % 3, c % 3);
          addContact(n + edge_count + c / 3, 1.0 / 9.0, block);
        }
        for (int c : edge_ends_.of(i)) addContact(n + c / 2, 1.0 / 4.0, block);
      }
      hessian.block(k) = block;
    }
  });
}

void IncrementalPotential::addBending(const Positions& d, Positions& product) {
  if (bending_.empty()) return;
  const bool damps = !start_bending_.empty();
  if (damps)
    parallelFor(static_cast<int>(hinge_force_.size()), kGrain,
                [&](int e) { hinge_force_[e] = hinge_hessian_[e] * hingeVector(cloth_.hinges()[e], d); });
  parallelFor(cloth_.vertexCount(), kGrain, [&](int i) {
    Vec3 sum = product.row(i).transpose() + bending_.row(i, d);
    if (damps)
      for (int k : hinge_corners_.of(i)) sum += cloth_.hinges()[k / 4].stencil[k % 4] * hinge_force_[k / 4];
    product.row(i) = sum;
  });
}

void IncrementalPotential::contactPressure(const Positions& x, std::vector<double>& pressure) {
  pressure.assign(cloth_.vertexCount(), 0.0);
  if (!touches_) return;
  contactForces(x);
  parallelFor(cloth_.vertexCount(), kGrain,
              [&](int i) { pressure[i] = gatherContact(i).norm() / cloth_.vertexAreas()[i]; });
}

}  // namespace ease
