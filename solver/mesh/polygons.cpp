#include "solver/mesh/polygons.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "solver/base/error.h"
#include "solver/base/joined.h"

namespace ease {

namespace {

using Point = Eigen::Vector2d;

constexpr int kMaxCorners = 5000;
constexpr double kMinQuality = 1e-9;  // of an ear: smaller ones have their corners in a line
constexpr double kFairQuality = 0.1;  // a quadrilateral is cut from its first corner unless that makes worse triangles

double cross(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a, v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

/// Twice the area over the square of the longest side: 0.87 for equal sides, 0 in a line, negative where turned over.
double quality(const Point& a, const Point& b, const Point& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return longest > 0.0 ? cross(a, b, c) / longest : 0.0;
}

/// Corners projected onto the plane that fits the polygon best (normal after Newell), relative to the first corner.
std::vector<Point> flattened(const std::vector<Vec3>& corners) {
  Vec3 normal = Vec3::Zero();
  for (size_t i = 0; i < corners.size(); ++i)
    normal += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  const Vec3 n = normal.normalized();
  const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
  std::vector<Point> points;
  for (const Vec3& corner : corners) points.emplace_back((corner - corners[0]).dot(u), (corner - corners[0]).dot(v));
  return points;
}

class EarClipping {
 public:
  explicit EarClipping(const std::vector<Vec3>& corners) : points_(flattened(corners)), left_(corners.size()) {
    std::iota(left_.begin(), left_.end(), 0);
  }

  /// Returns the triangles, or fewer than n - 2 where the polygon crosses itself or has no area.
  std::vector<std::array<int, 3>> operator()() {
    std::vector<std::array<int, 3>> triangles;
    std::vector<double> ears;
    for (size_t i = 0; i < left_.size(); ++i) ears.push_back(ear(i));
    while (left_.size() > 2) {
      auto best = std::max_element(ears.begin(), ears.end());
      if (*best < kMinQuality) {  // corners that lay within an ear may be gone
        for (size_t i = 0; i < left_.size(); ++i) ears[i] = ear(i);
        best = std::max_element(ears.begin(), ears.end());
        if (*best < kMinQuality) return triangles;
      }
      const size_t i = best - ears.begin();
      triangles.push_back({before(i), left_[i], after(i)});
      left_.erase(left_.begin() + static_cast<long>(i));
      ears.erase(ears.begin() + static_cast<long>(i));
      if (left_.size() < 3) break;
      const size_t next = i % left_.size(), previous = (i + left_.size() - 1) % left_.size();
      ears[next] = ear(next);
      ears[previous] = ear(previous);
    }
    return triangles;
  }

 private:
  int before(size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
  int after(size_t i) const { return left_[(i + 1) % left_.size()]; }

  /// Quality of the ear at the i-th corner that is left; 0 if it is none.
  double ear(size_t i) const {
    const Point &a = points_[before(i)], &b = points_[left_[i]], &c = points_[after(i)];
    const double q = quality(a, b, c);
    if (q < kMinQuality) return 0.0;
    if (left_.size() == 3) return q;
    for (const int k : left_) {
      const Point& p = points_[k];
      if (p == a || p == b || p == c) continue;
      if (cross(a, b, p) > 0.0 && cross(b, c, p) > 0.0 && quality(c, a, p) > -kMinQuality) return 0.0;
    }
    return q;
  }

  const std::vector<Point> points_;
  std::vector<int> left_;  // corners not clipped yet
};

std::vector<std::array<int, 3>> cutQuadrilateral(const std::vector<Vec3>& corners) {
  const std::vector<Point> p = flattened(corners);
  const double first = std::min(quality(p[0], p[1], p[2]), quality(p[0], p[2], p[3]));
  const double second = std::min(quality(p[0], p[1], p[3]), quality(p[1], p[2], p[3]));
  if (std::max(first, second) < kMinQuality) return {};
  if (first >= kFairQuality || first >= second) return {{0, 1, 2}, {0, 2, 3}};
  return {{0, 1, 3}, {1, 2, 3}};
}

/// Drops corners that repeat the one before them. Returns the places that are left.
std::vector<int> distinctCorners(const Polygons& polygons, int begin, int end) {
  std::vector<int> places;
  for (int k = begin; k < end; ++k)
    if (places.empty() || polygons.corners[k] != polygons.corners[places.back()]) places.push_back(k);
  while (places.size() > 1 && polygons.corners[places.front()] == polygons.corners[places.back()]) places.pop_back();
  return places;
}

std::vector<std::array<int, 3>> cutPolygon(const Polygons& polygons, const std::vector<int>& places) {
  std::vector<Vec3> corners;
  for (const int place : places) corners.push_back(polygons.points.row(polygons.corners[place]));
  return corners.size() == 4 ? cutQuadrilateral(corners) : EarClipping(corners)();
}

}  // namespace

Triangles cutPolygons(const Polygons& polygons, const std::string& name) {
  std::vector<std::array<int, 3>> rows;
  rows.reserve(polygons.corners.size());
  for (size_t p = 0; p < polygons.ends.size(); ++p) {
    const int begin = p == 0 ? 0 : polygons.ends[p - 1], end = polygons.ends[p];
    if (end - begin == 3) {
      rows.push_back({begin, begin + 1, begin + 2});
      continue;
    }
    const std::vector<int> places = distinctCorners(polygons, begin, end);
    if (places.size() < 3)
      throw InputError(joined(name, ": polygon ", p, " of ", end - begin,
                              " corners has fewer than three different ones; "
                              "delete it (\"merge by distance\", \"delete loose\")"));
    if (places.size() == 3) {
      rows.push_back({places[0], places[1], places[2]});
      continue;
    }
    if (places.size() > kMaxCorners)
      throw InputError(joined(name, ": polygon ", p, " has ", places.size(), " corners; expected at most ", kMaxCorners,
                              ": triangulate it in the program that it comes from"));
    const std::vector<std::array<int, 3>> cut = cutPolygon(polygons, places);
    if (cut.size() + 2 != places.size())
      throw InputError(joined(name, ": polygon ", p, " of ", places.size(), " corners (vertex ",
                              polygons.corners[begin],
                              " first) crosses itself or has no area: triangulate it in the "
                              "program that it comes from"));
    for (const auto& [a, b, c] : cut) rows.push_back({places[a], places[b], places[c]});
  }
  Triangles cut(static_cast<int>(rows.size()), 3);
  for (size_t t = 0; t < rows.size(); ++t) cut.row(static_cast<long>(t)) << rows[t][0], rows[t][1], rows[t][2];
  return cut;
}

Triangles trianglesOf(const Polygons& polygons, const Triangles& cut) {
  Triangles triangles(cut.rows(), 3);
  for (long k = 0; k < cut.size(); ++k) triangles.data()[k] = polygons.corners[cut.data()[k]];
  return triangles;
}

}  // namespace ease
