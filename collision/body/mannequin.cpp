#include "collision/body/mannequin.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

#include "collision/body/fading_turn.h"
#include "collision/body/iso_surface.h"
#include "collision/body/mannequin_shape.h"
#include "solver/base/error.h"
#include "solver/base/parallel.h"

namespace ease {
namespace {

constexpr double kVoxel = 0.0135;  // m
constexpr double kDegree = std::numbers::pi / 180.0;

/// Turns of the left arm's joints, axis times angle, degrees; the right arm's are their mirror images.  About z the arm
/// rises, about -y it comes forward.
struct ArmPose {
  std::string name;
  Vec3 clavicle, shoulder, elbow;
};

/// Collar bone and shoulder blade contribute about a third of a raised arm's angle, as in people.
const std::vector<ArmPose> kPoses = {
    {"t", {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
    {"a", {0, 0, -6}, {0, -6, -40}, {0, -12, 0}},
    {"up", {0, 0, 22}, {0, -4, 46}, {0, -8, 0}},
    {"front", {0, -26, 0}, {0, -60, -2}, {0, -3, 0}},
};

/// Turns of the joints from the trunk outwards; each joint is at its place in the T-pose.
std::vector<FadingTurn> armTurns(const ArmPose& pose, const BodySize& size) {
  using namespace mannequin_joints;
  const Vec3 outwards = Vec3::UnitX();
  return {
      {size.warped(kClavicle), outwards, kDegree * pose.clavicle, 20 * kDegree, 76 * kDegree, 56 * kDegree, 0.10, 0.40},
      {size.warped(kShoulder), outwards, kDegree * pose.shoulder, 16 * kDegree, 136 * kDegree, 76 * kDegree, 0.05,
       0.21},
      {size.warped(kElbow), outwards, kDegree * pose.elbow, 20 * kDegree, 140 * kDegree, 45 * kDegree, 0.06, 0.30},
  };
}

/// Moves a point of the left half of the T-pose by the turns, from the trunk outwards.
Vec3 posed(const std::vector<FadingTurn>& turns, const Vec3& x) {
  Vec3 y = x;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  for (const FadingTurn& turn : turns) {
    const FadingTurn moved = movedTurn(motion, turn);
    y = turned(moved, y);
    motion = wholeTurn(moved) * motion;
  }
  return y;
}

/// The T-pose, made once.
const TriangleMesh& restMannequin() {
  static const TriangleMesh mesh =
      isoSurface(mannequinDistance, Vec3(-0.95, -0.08, -0.25), Vec3(0.95, 1.78, 0.25), kVoxel);
  return mesh;
}

}  // namespace

const std::vector<std::string>& mannequinPoses() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const ArmPose& pose : kPoses) result.push_back(pose.name);
    return result;
  }();
  return names;
}

TriangleMesh mannequin(const std::string& pose, const BodyMeasures& measures) {
  const auto found = std::find_if(kPoses.begin(), kPoses.end(), [&](const ArmPose& p) { return p.name == pose; });
  if (found == kPoses.end())
    throw InputError(fmt::format("the mannequin has no pose \"{}\"; its poses are \"{}\"", pose,
                                 fmt::join(mannequinPoses(), "\", \"")));
  TriangleMesh mesh = restMannequin();
  const BodySize size(measures);
  const std::vector<FadingTurn> turns = armTurns(*found, size);
  parallelFor(static_cast<int>(mesh.positions.rows()), 256, [&](int v) {
    const Vec3 x = size.warped(mesh.positions.row(v));
    const Vec3 side(x.x() < 0.0 ? -1.0 : 1.0, 1.0, 1.0);
    mesh.positions.row(v) = size.height() * posed(turns, x.cwiseProduct(side)).cwiseProduct(side);
  });
  return mesh;
}

}  // namespace ease
