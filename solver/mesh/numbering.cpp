#include "solver/mesh/numbering.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace ease {

namespace {

constexpr int kBits = 20;  // per coordinate

/// Morton key of a point in the box: the bits of its coordinates x, y and z in turn.
std::uint64_t placeOnCurve(const Eigen::AlignedBox3d& box, const Vec3& x) {
  const double cells = static_cast<double>(1 << kBits) / std::max(1e-300, box.sizes().maxCoeff());
  std::uint64_t place = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<std::uint64_t>((x[axis] - box.min()[axis]) * cells);
    for (int bit = 0; bit <= kBits; ++bit) place |= (cell >> bit & 1) << (3 * bit + axis);
  }
  return place;
}

/// Sorts the indices 0, 1, ... by key; equal keys by index.
template <class Key>
std::vector<int> sorted(const std::vector<Key>& keys) {
  std::vector<int> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) { return keys[i]; });
  return order;
}

}  // namespace

std::vector<int> newNumbers(const std::vector<int>& order) {
  std::vector<int> numbers(order.empty() ? 0 : *std::ranges::max_element(order) + 1, -1);
  for (size_t k = 0; k < order.size(); ++k) numbers[order[k]] = static_cast<int>(k);
  return numbers;
}

Numbering spatialNumbering(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& x : mesh.positions.rowwise()) box.extend(x.transpose());
  std::vector<std::uint64_t> places;
  for (const auto& x : mesh.positions.rowwise()) places.push_back(placeOnCurve(box, x));
  Numbering numbering;
  numbering.vertices = sorted(places);
  const std::vector<int> number = newNumbers(numbering.vertices);
  std::vector<int> first;
  for (const auto& t : mesh.triangles.rowwise()) first.push_back(std::min({number[t[0]], number[t[1]], number[t[2]]}));
  numbering.triangles = sorted(first);
  return numbering;
}

Numbering partNumbering(const Triangles& triangles, std::vector<int> kept) {
  Numbering part{{}, std::move(kept)};
  std::vector<char> is_numbered(triangles.size() > 0 ? triangles.maxCoeff() + 1 : 0, 0);
  for (const int t : part.triangles)
    for (const int v : triangles.row(t)) {
      if (is_numbered[v]) continue;
      is_numbered[v] = 1;
      part.vertices.push_back(v);
    }
  return part;
}

TriangleMesh renumbered(const TriangleMesh& mesh, const Numbering& numbering) {
  return {renumbered(mesh.positions, numbering.vertices), renumbered(mesh.triangles, numbering)};
}

Triangles renumbered(const Triangles& triangles, const Numbering& numbering) {
  const std::vector<int> number = newNumbers(numbering.vertices);
  Triangles ordered(static_cast<int>(numbering.triangles.size()), 3);
  for (int k = 0; k < ordered.rows(); ++k)
    for (int a = 0; a < 3; ++a) ordered(k, a) = number[triangles(numbering.triangles[k], a)];
  return ordered;
}

Positions renumbered(const Positions& positions, const std::vector<int>& order) {
  Positions ordered(static_cast<int>(order.size()), 3);
  for (int k = 0; k < ordered.rows(); ++k) ordered.row(k) = positions.row(order[k]);
  return ordered;
}

Positions restored(const Positions& positions, const std::vector<int>& order) {
  Positions original(positions.rows(), 3);
  for (int k = 0; k < positions.rows(); ++k) original.row(order[k]) = positions.row(k);
  return original;
}

}  // namespace ease
