// Second derivative of the incremental potential (incremental_potential.h).
#include "solver/base/parallel.h"
#include "solver/energy/friction.h"
#include "solver/step/incremental_potential.h"

namespace ease {

namespace {

constexpr int kGrain = 512;

}  // namespace

void IncrementalPotential::contactHessians(const Positions& x, HessianKind kind) {
  std::fill(pressed_.begin(), pressed_.end(), 0);
  parallelFor(contacts_.groupCount(), 1, [&](int g) {
    const auto add = [&](int s, const Mat3& hessian) {
      if (!pressed_[s]) contact_hessian_[s].setZero();
      contact_hessian_[s] += hessian;
      pressed_[s] = 1;
    };
    forPressed(g, x, false, [&](const ContactLanes& contact, int lane, double depth) {
      const Vec3 normal = contact.normalOf(lane);
      add(contact.sample[lane], stiffness(contact, lane, depth) * normal * normal.transpose());
    });
    forFriction(g, x, [&](const ContactLanes& contact, int lane, double limit, const Vec3& slip) {
      add(contact.sample[lane], limit * frictionHessian(slip, contact.normalOf(lane), slipLength(), kind));
    });
  });
}

void IncrementalPotential::hessian(const Positions& x, HessianKind kind, BlockMatrix& hessian) {
  const int n = cloth_.vertexCount();
  const ContactSamples samples = cloth_.samples();
  parallelFor(cloth_.triangleCount(), kGrain, [&](int t) {
    const Mat32 F = cloth_.deformation(x, t);
    frame_hessian_[t] = membrane_.hessian(F, t, kind);
    frame_hessian_[t] *= cloth_.membraneWeights()[t];
  });
  if (hinges_.damps())
    parallelFor(static_cast<int>(hinge_hessian_.size()), kGrain, [&](int e) {
      hinge_hessian_[e] = hingeDampingHessian(hingeVector(cloth_.hinges()[e], x), hinges_.damper(e), kind);
    });
  contactHessians(x, kind);
  const auto addContact = [&](int s, double weight, Mat3& block) {
    if (pressed_[s]) block += weight * contact_hessian_[s];
  };
  // Second derivative of triangle t's energy with respect to its corners p and q.
  const auto triangleBlock = [&](int t, int p, int q) -> Mat3 {
    const Mat32 b = shapeGradients(cloth_.restInverse()[t]);
    const FrameHessian& h = frame_hessian_[t];
    return b(p, 0) * b(q, 0) * h.uu + b(p, 0) * b(q, 1) * h.uv + b(p, 1) * b(q, 0) * h.uv.transpose() +
           b(p, 1) * b(q, 1) * h.vv;
  };

  const double inverse_h2 = 1.0 / (options_.h * options_.h);
  parallelFor(n, kGrain, [&](int i) {
    for (int k = hessian.rowBegin(i); k < hessian.rowEnd(i); ++k) {
      Mat3 block = Mat3::Zero();
      if (const int edge = hessian.edge(k); edge >= 0) {
        for (int t : cloth_.topology().edges[edge].triangle)
          if (t >= 0) {
            block += triangleBlock(t, cornerOf(cloth_.triangles(), t, i),
                                   cornerOf(cloth_.triangles(), t, hessian.column(k)));
            addContact(samples.centroid(t), 1.0 / 9.0, block);
          }
        addContact(samples.midpoint(edge), 1.0 / 4.0, block);
      } else {
        block = inverse_h2 * cloth_.masses()[i] * Mat3::Identity();
        addContact(i, 1.0, block);
        for (int c : triangle_corners_.of(i)) {
          block += triangleBlock(c / 3, c % 3, c % 3);
          addContact(samples.centroid(c / 3), 1.0 / 9.0, block);
        }
        for (int c : edge_ends_.of(i)) addContact(samples.midpoint(c / 2), 1.0 / 4.0, block);
      }
      hessian.block(k) = block;
    }
  });
}

void IncrementalPotential::addBendingProduct(const Positions& d, Positions& product) {
  if (bending_.empty()) return;
  std::vector<Vec3>& damping = hinges_.vectors();
  if (hinges_.damps())
    parallelFor(hinges_.count(), kGrain,
                [&](int e) { damping[e] = hinge_hessian_[e] * hingeVector(cloth_.hinges()[e], d); });
  parallelFor(cloth_.vertexCount(), kGrain, [&](int i) {
    Vec3 sum = product.row(i);
    bending_.addRow(i, d, sum);
    if (hinges_.damps()) sum += hinges_.sumAt(i);
    product.row(i) = sum;
  });
}

}  // namespace ease
