#include "garment/named_loop.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.h"

namespace ease {

namespace {

/// A loop named by its side must lie further out than all other loops by at least this share of the mesh's diagonal.
constexpr double kMinLead = 0.01;

Vec3 meanOf(const Positions& positions, const std::vector<int>& loop) {
  Vec3 sum = Vec3::Zero();
  for (int vertex : loop) sum += positions.row(vertex).transpose();
  return sum / static_cast<double>(loop.size());
}

std::string describeLoops(const Topology& topology, const Positions& positions) {
  if (topology.boundary_loops.empty()) return "the mesh has no boundary loop";
  std::string text = "the boundary loops are";
  for (std::size_t l = 0; l < topology.boundary_loops.size(); ++l) {
    const Vec3 mean = meanOf(positions, topology.boundary_loops[l]);
    text += fmt::format("{} {} ({} vertices about ({:.3f}, {:.3f}, {:.3f}))", l == 0 ? "" : ",", l,
                        topology.boundary_loops[l].size(), mean.x(), mean.y(), mean.z());
  }
  return text;
}

/// The loop on the middle of the garment, among those in its upper (`sign` 1) or lower half (-1): sleeves and legs lie
/// to the sides, wherever they point. It spans the middle, and no other is half as near to it.
const std::vector<int>& loopOnMiddle(const Topology& topology, const Positions& positions, const std::string& where,
                                     double sign) {
  const Vec3 middle = positions.colwise().mean().transpose();
  const double half = 0.5 * (positions.col(1).maxCoeff() + positions.col(1).minCoeff());
  std::vector<std::pair<double, const std::vector<int>*>> found;  // (distance from the middle plane, m; loop)
  for (const std::vector<int>& loop : topology.boundary_loops) {
    const Vec3 mean = meanOf(positions, loop);
    if (sign * (mean.y() - half) > 0.0) found.emplace_back(std::abs(mean.x() - middle.x()), &loop);
  }
  std::ranges::sort(found);
  if (!found.empty()) {
    const auto x = [&](int vertex) { return positions(vertex, 0); };
    const auto [low, high] = std::ranges::minmax(*found[0].second, {}, x);
    const bool spans = found.size() == 1 || (x(low) < middle.x() && x(high) > middle.x());
    if (spans && (found.size() == 1 || found[0].first < 0.5 * found[1].first)) return *found[0].second;
  }
  throw InputError(
      fmt::format("boundary loop \"{}\" is ambiguous: expected one loop on the middle of the garment's {} "
                  "half; name it by its number; {}",
                  where, sign > 0.0 ? "upper" : "lower", describeLoops(topology, positions)));
}

}  // namespace

const std::vector<int>& findLoop(const Topology& topology, const Positions& positions, const std::string& where) {
  const std::vector<std::vector<int>>& loops = topology.boundary_loops;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (where == fmt::format("{}", l)) return loops[l];
  }
  Vec3 direction = Vec3::Zero();
  if (!loops.empty() && (where == "neck" || where == "hem"))
    return loopOnMiddle(topology, positions, where, where == "neck" ? 1.0 : -1.0);
  if (where == "top") direction = Vec3::UnitY();
  if (where == "bottom") direction = -Vec3::UnitY();
  if (where == "left") direction = Vec3::UnitX();
  if (where == "right") direction = -Vec3::UnitX();
  if (direction.isZero() || loops.empty()) {
    throw InputError(fmt::format(
        "no boundary loop \"{}\": expected \"top\" or \"neck\", \"bottom\" or \"hem\", \"left\", \"right\", or an "
        "index; {}",
        where, describeLoops(topology, positions)));
  }
  std::vector<std::pair<double, std::size_t>>
      reach;  // (negative position along the direction, m; loop): the furthest is first
  for (std::size_t l = 0; l < loops.size(); ++l) reach.emplace_back(-meanOf(positions, loops[l]).dot(direction), l);
  std::ranges::sort(reach);
  const double size = (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).norm();
  if (loops.size() > 1 && reach[1].first - reach[0].first < kMinLead * size) {
    throw InputError(fmt::format("boundary loop \"{}\" is ambiguous: loops {} and {} lie equally far; {}", where,
                                 reach[0].second, reach[1].second, describeLoops(topology, positions)));
  }
  return loops[reach[0].second];
}

std::vector<NamedLoop> nameLoops(const Topology& topology, const Positions& positions) {
  std::vector<NamedLoop> loops;
  for (std::size_t l = 0; l < topology.boundary_loops.size(); ++l)
    loops.push_back({fmt::format("{}", l), topology.boundary_loops[l]});
  for (const char* name : {"right", "left", "hem", "neck"}) {  // the last name of a loop counts
    try {
      const std::vector<int>& named = findLoop(topology, positions, name);
      for (NamedLoop& loop : loops)
        if (loop.vertices == named) loop.name = name;
    } catch (const InputError&) {  // two loops lie equally far: neither has this name
    }
  }
  return loops;
}

}  // namespace ease
