#include "solver/mesh/mesh_checks.h"

#include <algorithm>
#include <vector>

#include "solver/base/error.h"
#include "solver/base/joined.h"

namespace ease {
namespace {

constexpr double kMinRelativeArea = 1e-12;  // smallest area of a triangle over the squared diagonal of the mesh

/// Squared diagonal of the box around all vertices, m^2.
double squaredDiagonal(const Positions& positions) {
  if (positions.rows() == 0) return 0.0;
  return (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).squaredNorm();
}

std::vector<char> verticesUsed(const TriangleMesh& mesh) {
  std::vector<char> used(mesh.positions.rows(), 0);
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k) used[mesh.triangles(t, k)] = 1;
  }
  return used;
}

std::string describe(const Triangles& triangles, int t) {
  return joined("(", triangles(t, 0), ", ", triangles(t, 1), ", ", triangles(t, 2), ")");
}

/// Whether triangle t has the same vertices in the same rotational order in both meshes.
bool isSameTriangle(const Triangles& a, const Triangles& b, int t) {
  for (int shift = 0; shift < 3; ++shift) {
    bool same = true;
    for (int k = 0; k < 3; ++k) same = same && a(t, k) == b(t, (k + shift) % 3);
    if (same) return true;
  }
  return false;
}

/// For each vertex of `first` its counterpart in `other`, -1 without one; and the first triangle at which a vertex of
/// either would need two counterparts, -1 if none does.
struct Correspondence {
  std::vector<int> other_of_first;
  int failing_triangle = -1;
};

Correspondence correspondByOrder(const TriangleMesh& first, const TriangleMesh& other) {
  Correspondence result{std::vector<int>(first.positions.rows(), -1)};
  std::vector<int> first_of_other(other.positions.rows(), -1);
  for (int t = 0; t < first.triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int i = first.triangles(t, k), j = other.triangles(t, k);
      if (result.other_of_first[i] < 0) result.other_of_first[i] = j;
      if (first_of_other[j] < 0) first_of_other[j] = i;
      if (result.other_of_first[i] != j || first_of_other[j] != i) {
        result.failing_triangle = t;
        return result;
      }
    }
  }
  return result;
}

bool correspondsOneToOne(const TriangleMesh& first, const TriangleMesh& other) {
  if (first.triangles.rows() != other.triangles.rows()) return false;
  const Correspondence match = correspondByOrder(first, other);
  return match.failing_triangle < 0 && std::ranges::none_of(match.other_of_first, [](int j) { return j < 0; });
}

constexpr const char* kSameMesh = "; every pose must be the same mesh, moved: fit one template to all scans";

void checkSameNumber(const char* what, Eigen::Index first, const std::string& first_name, Eigen::Index other,
                     const std::string& other_name, const char* advice) {
  if (first == other) return;
  throw InputError(joined(other_name, ": has ", other, " ", what, ", but ", first_name, " has ", first, advice));
}

}  // namespace

void checkCoordinates(const Positions& positions, const std::string& name) {
  for (int i = 0; i < positions.rows(); ++i) {
    if ((positions.row(i).array().abs() <= kMaxCoordinate).all()) continue;  // false for NaN
    throw InputError(joined(name, ": vertex ", i, " is (", positions(i, 0), ", ", positions(i, 1), ", ",
                            positions(i, 2), "); expected finite coordinates of at most ", kMaxCoordinate));
  }
}

void checkGeometry(const TriangleMesh& mesh, const std::string& name) {
  checkCoordinates(mesh.positions, name);
  const double least_area = kMinRelativeArea * squaredDiagonal(mesh.positions);
  std::string first;
  int count = 0;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const auto v = mesh.triangles.row(t);
    const bool repeats = v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
    // Not "area < least": where all vertices coincide both sides are zero.
    const double area = repeats ? 0.0 : triangleArea(mesh.positions, mesh.triangles, t);
    if (area > least_area || count++ > 0) continue;
    first = repeats ? joined("triangle ", t, " has a vertex twice: ", describe(mesh.triangles, t))
                    : joined("triangle ", t, " of vertices ", describe(mesh.triangles, t), " is degenerate: area ",
                             area, " m^2, expected above ", least_area);
  }
  if (count == 0) return;
  throw InputError(joined(name, ": ", first, count > 1 ? joined(" (", count, " such triangles)") : std::string(),
                          ": dissolve degenerate faces, or merge vertices by distance"));
}

void checkVerticesUsed(const TriangleMesh& mesh, const std::string& name) {
  const std::vector<char> used = verticesUsed(mesh);
  const auto unused = std::ranges::find(used, 0);
  if (unused != used.end()) {
    throw InputError(joined(name, ": vertex ", unused - used.begin(), " belongs to no triangle"));
  }
}

void checkSameTriangles(const TriangleMesh& first, const std::string& first_name, const TriangleMesh& other,
                        const std::string& other_name) {
  const char* advice = correspondsOneToOne(first, other)
                           ? "; the triangles correspond one to one in their order: set match = \"triangles\""
                           : kSameMesh;
  checkSameNumber("vertices", first.positions.rows(), first_name, other.positions.rows(), other_name, advice);
  checkSameNumber("triangles", first.triangles.rows(), first_name, other.triangles.rows(), other_name, advice);
  for (int t = 0; t < first.triangles.rows(); ++t) {
    if (isSameTriangle(first.triangles, other.triangles, t)) continue;
    throw InputError(joined(other_name, ": triangle ", t, " has vertices ", describe(other.triangles, t), ", but in ",
                            first_name, " it has ", describe(first.triangles, t), advice));
  }
}

TriangleMesh matchByTriangles(const TriangleMesh& first, const std::string& first_name, const TriangleMesh& other,
                              const std::string& other_name) {
  checkSameNumber("triangles", first.triangles.rows(), first_name, other.triangles.rows(), other_name, kSameMesh);
  const Correspondence match = correspondByOrder(first, other);
  if (match.failing_triangle >= 0) {
    const int t = match.failing_triangle;
    throw InputError(joined(other_name, ": does not match ", first_name, " by the order of the triangles: triangle ", t,
                            " has vertices ", describe(other.triangles, t), ", but in ", first_name, " it has ",
                            describe(first.triangles, t), ", so that one vertex would need two numbers", kSameMesh));
  }
  TriangleMesh renumbered{Positions(first.positions.rows(), 3), first.triangles};
  for (int i = 0; i < first.positions.rows(); ++i) {
    const int j = match.other_of_first[i];
    if (j < 0) {
      throw InputError(joined(first_name, ": vertex ", i, " belongs to no triangle, so that ", other_name,
                              " cannot be matched to it by its triangles"));
    }
    renumbered.positions.row(i) = other.positions.row(j);
  }
  return renumbered;
}

}  // namespace ease
