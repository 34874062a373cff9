#include "solver/step/incremental_potential.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/base/parallel.h"
#include "solver/energy/friction.h"

namespace ease {

namespace {

constexpr int kGrain = 512;
constexpr int kGroup = 512;          // triangles or vertices that one thread computes in order; a multiple of kLanes
constexpr double kRoundOff = 1e-12;  // round-off relative to the potential and the motion

std::span<const int> flat(const Triangles& triangles) {
  return {triangles.data(), static_cast<size_t>(triangles.size())};
}

std::vector<int> edgeEnds(const std::vector<Edge>& edges) {
  std::vector<int> ends;
  for (const Edge& edge : edges) ends.insert(ends.end(), edge.vertex.begin(), edge.vertex.end());
  return ends;
}

}  // namespace

IncrementalPotential::IncrementalPotential(const Cloth& cloth)
    : cloth_(cloth),
      membrane_(cloth),
      inertial_(cloth.vertexCount(), 3),
      contacts_(cloth, kGroup),
      hinges_(cloth),
      bending_(cloth.vertexCount(), cloth.hinges()),
      triangle_corners_(cloth.vertexCount(), flat(cloth.triangles())),
      edge_ends_(cloth.vertexCount(), edgeEnds(cloth.topology().edges)),
      lanes_((cloth.triangleCount() + kLanes - 1) / kLanes),
      corner_force_(3 * kLanes * lanes_.size()),
      contact_hessian_(contacts_.sampleCount()),
      pressed_(contacts_.sampleCount()),
      frame_hessian_(cloth.triangleCount()),
      hinge_hessian_(cloth.hinges().size()),
      vertex_sums_((cloth.vertexCount() + kGroup - 1) / kGroup) {}

void IncrementalPotential::begin(const State& start, const StepOptions& options) {
  options_ = options;
  setContacts({});
  start_ = start.positions;
  inertial_ = start.positions + options.h * start.velocities;
  inertial_.rowwise() += options.h * options.h * options.gravity.transpose();

  bool is_new = false;  // the rest shape
  if (rest_revision_ != cloth_.restRevision()) {
    rest_revision_ = cloth_.restRevision();
    bending_.set(cloth_.hinges(), cloth_.material().bending);
    total_mass_ = std::accumulate(cloth_.masses().begin(), cloth_.masses().end(), 0.0);
    is_new = true;
  }
  bending_round_off_ = bending_.roundOff(start_);
  membrane_.begin(start.positions, options.h);
  if (is_new || membrane_.damps()) layOutTriangles();
  hinges_.begin(start.positions, options.h);
}

void IncrementalPotential::layOutTriangles() {
  const int m = cloth_.triangleCount();
  parallelFor(static_cast<int>(lanes_.size()), kGrain / kLanes, [&](int block) {
    TriangleLanes& lanes = lanes_[block];
    for (int l = 0; l < kLanes; ++l) {
      const int t = std::min(block * kLanes + l, m - 1);
      for (int a = 0; a < 3; ++a) lanes.corners[a][l] = cloth_.triangles()(t, a);
      for (int k = 0; k < 4; ++k) lanes.inverse[k][l] = cloth_.restInverse()[t](k / 2, k % 2);
      lanes.weight[l] = block * kLanes + l < m ? cloth_.membraneWeights()[t] : 0.0;
      membrane_.setRestConditions(t, l, lanes.rest);
    }
  });
}

void IncrementalPotential::setContacts(const Contacts& contacts, std::span<const double> normal_forces) {
  const FrictionStart friction{options_.friction, start_, normal_forces};
  contacts_.set(contacts, options_.friction > 0.0 ? &friction : nullptr);
}

TriangleEdges IncrementalPotential::TriangleLanes::edgesAt(const Positions& x) const {
  Column<Lanes> at[3];
  for (int a = 0; a < 3; ++a)
    for (int l = 0; l < kLanes; ++l) {
      const double* position = x.data() + 3 * corners[a][l];
      at[a].x[l] = position[0];
      at[a].y[l] = position[1];
      at[a].z[l] = position[2];
    }
  const auto from = [&](const Column<Lanes>& end) {
    return Column<Lanes>{end.x - at[0].x, end.y - at[0].y, end.z - at[0].z};
  };
  return {at[0], from(at[1]), from(at[2])};
}

/// Computes membrane and contact forces at triangle corners; returns the energy, J.
double IncrementalPotential::triangleForces(const Positions& x) {
  const int per_group = kGroup / kLanes;
  partial_.resize(contacts_.groupCount());
  parallelFor(contacts_.groupCount(), 1, [&](int g) {
    const std::span<const ContactLanes> contacts = contacts_.group(g);
    const std::span<const FrictionLanes> frictions = contacts_.friction(g);
    const int end = std::min((g + 1) * per_group, static_cast<int>(lanes_.size()));
    size_t first = 0, last = 0;  // range of the current block's contacts
    double energy = 0.0;
    for (int block = g * per_group; block < end; ++block, first = last) {
      while (last < contacts.size() && contacts[last].block == block) ++last;
      energy += blockForces(block, contacts.subspan(first, last - first),
                            frictions.empty() ? frictions : frictions.subspan(first, last - first), x);
    }
    partial_[g] = energy;
  });
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

/// Computes the forces of eight triangles side by side; returns their energy, J.
double IncrementalPotential::blockForces(int block, std::span<const ContactLanes> contacts,
                                         std::span<const FrictionLanes> frictions, const Positions& x) {
  const TriangleLanes& lanes = lanes_[block];
  const TriangleEdges host = lanes.edgesAt(x);
  const Column<Lanes>&e1 = host.edge_1, &e2 = host.edge_2;
  const Lanes* D = lanes.inverse;
  const auto column = [&](int k) {
    return Column<Lanes>{e1.x * D[k] + e2.x * D[2 + k], e1.y * D[k] + e2.y * D[2 + k], e1.z * D[k] + e2.z * D[2 + k]};
  };
  const Deformation<Lanes> F{column(0), column(1)};
  const Column<Lanes> none{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
  Deformation<Lanes> stress{none, none};
  const Lanes psi = membrane_.add(F, lanes.rest, stress);
  Lanes energy = psi * lanes.weight;

  // dE/dx at corners 1 and 2 is weight * stress * D^-T, where D^-1 is `inverse`. The membrane's forces sum to zero,
  // which gives corner 0.
  const auto force = [&](int k) {
    const Lanes u = lanes.weight * D[2 * k], v = lanes.weight * D[2 * k + 1];
    return Column<Lanes>{stress.u.x * u + stress.v.x * v, stress.u.y * u + stress.v.y * v,
                         stress.u.z * u + stress.v.z * v};
  };
  Column<Lanes> f1 = force(0), f2 = force(1), contact_force = none;
  for (const ContactLanes& contact : contacts) {
    const Lanes depth = contact.depth(host);
    if (depth.maxCoeff() == 0.0) continue;
    energy += contact.area * contactEnergy(depth, options_.contact_stiffness, contact.give);
    const Lanes push = -contact.area * ease::contactPressure(depth, options_.contact_stiffness, contact.give);
    addScaled(contact_force, push, contact.normal);
    addScaled(f1, Lanes(push * contact.weight[0]), contact.normal);
    addScaled(f2, Lanes(push * contact.weight[1]), contact.normal);
  }
  for (size_t k = 0; k < frictions.size(); ++k) {
    const FrictionLanes& friction = frictions[k];
    if (!friction.any) continue;
    const Column<Lanes> u = friction.slip(contacts[k], host);
    const Lanes y = length(u);
    energy += friction.limit * frictionPotential(y, slipLength());
    const Lanes drag = friction.limit * frictionWeight(y, slipLength());
    addScaled(contact_force, drag, u);
    addScaled(f1, Lanes(drag * contacts[k].weight[0]), u);
    addScaled(f2, Lanes(drag * contacts[k].weight[1]), u);
  }
  Vec3* out = corner_force_.data() + static_cast<size_t>(3 * kLanes) * block;
  const Column<Lanes> f0{contact_force.x - f1.x - f2.x, contact_force.y - f1.y - f2.y, contact_force.z - f1.z - f2.z};
  for (int l = 0; l < kLanes; ++l) {
    out[3 * l] = Vec3(f0.x[l], f0.y[l], f0.z[l]);
    out[3 * l + 1] = Vec3(f1.x[l], f1.y[l], f1.z[l]);
    out[3 * l + 2] = Vec3(f2.x[l], f2.y[l], f2.z[l]);
  }
  return energy.sum();
}

double IncrementalPotential::gradient(const Positions& x, Positions& gradient, StepMotion* motion) {
  const double energy = triangleForces(x) + (hinges_.empty() ? 0.0 : hinges_.evaluate(x));
  const double inverse_h2 = 1.0 / (options_.h * options_.h);
  const Vec3 fall = options_.h * options_.h * options_.gravity;  // inertial_ contains this fall
  parallelFor(static_cast<int>(vertex_sums_.size()), 1, [&](int g) {
    VertexSums sums{};
    for (int i = g * kGroup; i < std::min((g + 1) * kGroup, cloth_.vertexCount()); ++i) {
      const Vec3 x_i = x.row(i), beyond_inertial = x_i - inertial_.row(i).transpose();
      const double mass = inverse_h2 * cloth_.masses()[i];
      sums.energy += 0.5 * mass * beyond_inertial.squaredNorm();
      sums.motion.whole += mass * (x_i - start_.row(i).transpose()).squaredNorm();
      sums.motion.forced += mass * (beyond_inertial + fall).squaredNorm();
      Vec3 sum = mass * beyond_inertial;
      for (int k : triangle_corners_.of(i)) sum += corner_force_[k];
      if (!hinges_.empty()) sum += hinges_.sumAt(i);
      gradient.row(i) = sum;
    }
    vertex_sums_[g] = sums;
  });
  VertexSums total{energy, {}};
  for (const VertexSums& sums : vertex_sums_) {
    total.energy += sums.energy;
    total.motion.whole += sums.motion.whole;
    total.motion.forced += sums.motion.forced;
  }
  if (motion) *motion = total.motion;
  return total.energy;
}

double IncrementalPotential::kinetic(const Positions& d) const {
  return parallelSum(cloth_.vertexCount(), [&](int i) { return cloth_.masses()[i] * d.row(i).squaredNorm(); }) /
         (options_.h * options_.h);
}

double IncrementalPotential::roundOff(double energy, const StepMotion& motion) const {
  return kRoundOff * (std::abs(energy) + motion.whole) + bending_round_off_;
}

void IncrementalPotential::contactDiagonal(const Positions& x, bool bound, std::vector<double>& diagonal) {
  diagonal.assign(cloth_.vertexCount(), 0.0);
  if (contacts_.empty()) return;
  corner_stiffness_.resize(corner_force_.size());
  parallelFor(contacts_.groupCount(), 1, [&](int g) {
    const size_t begin = 3 * static_cast<size_t>(kGroup) * g, end = std::min(begin + 3 * kGroup, corner_force_.size());
    std::fill(corner_stiffness_.begin() + begin, corner_stiffness_.begin() + end, 0.0);
    const auto add = [&](const ContactLanes& contact, int lane, double k) {
      double* corner = corner_stiffness_.data() + 3 * (static_cast<size_t>(kLanes) * contact.block + lane);
      for (const double weight : weightsOf(contact, lane)) *corner++ += weight * k;
    };
    forPressed(g, x, bound, [&](const ContactLanes& contact, int lane, double depth) {
      add(contact, lane, stiffness(contact, lane, depth));
    });
    forFriction(g, x, [&](const ContactLanes& contact, int lane, double limit, const Vec3&) {
      add(contact, lane, limit * frictionWeight(0.0, slipLength()));
    });
  });
  parallelFor(cloth_.vertexCount(), kGrain, [&](int i) {
    for (int k : triangle_corners_.of(i)) diagonal[i] += corner_stiffness_[k];
  });
}

void IncrementalPotential::normalForces(const Positions& x, std::vector<double>& forces) const {
  const size_t count = cloth_.samples().count();
  forces.assign(2 * count, 0.0);
  parallelFor(contacts_.groupCount(), 1, [&](int g) {
    for (size_t k = 0; k < contacts_.friction(g).size(); ++k) {
      const ContactLanes& contact = contacts_.group(g)[k];
      const Lanes depth = contact.depth(lanes_[contact.block].edgesAt(x));
      const Lanes push = contact.area * ease::contactPressure(depth, options_.contact_stiffness, contact.give);
      for (int l = 0; l < kLanes; ++l)
        if (const int force = contacts_.friction(g)[k].force[l]; force >= 0) forces[force] = push[l];
    }
  });
}

void IncrementalPotential::contactPressure(const Positions& x, std::vector<double>& pressure) {
  pressure.assign(cloth_.vertexCount(), 0.0);
  if (contacts_.empty()) return;
  std::vector<Vec3> force(cloth_.vertexCount(), Vec3::Zero());
  for (int g = 0; g < contacts_.groupCount(); ++g)
    forPressed(g, x, false, [&](const ContactLanes& contact, int l, double depth) {
      const double push = contact.area[l] * ease::contactPressure(depth, options_.contact_stiffness, contact.give[l]);
      const std::array<double, 3> weights = weightsOf(contact, l);
      for (int a = 0; a < 3; ++a) force[lanes_[contact.block].corners[a][l]] += weights[a] * push * contact.normalOf(l);
    });
  parallelFor(cloth_.vertexCount(), kGrain, [&](int i) {
    double area = 0.0;
    for (int k : triangle_corners_.of(i)) area += triangleArea(x, cloth_.triangles(), k / 3) / 3.0;
    pressure[i] = area > 0.0 ? force[i].norm() / area : 0.0;
  });
}

}  // namespace ease
