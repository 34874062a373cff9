#include "garment/pattern/mirror_pieces.h"

#include <algorithm>
#include <cmath>

namespace ease {
namespace {

constexpr double kAlike = 2.0;       // mm: how far mirror images may differ
constexpr double kAlikeArea = 0.02;  // share by which their areas may
constexpr double kSameWidth = 0.01;  // mm, of an allowance
constexpr int kSamples = 200;        // points along an outline that are compared

/// The mirror image of a line, counter-clockwise again.
SewLine mirrored(const SewLine& line) {
  SewLine image = line;
  for (SewnEdge& edge : image.edges) {
    for (PaperPoint& p : edge.points) p.x() = -p.x();
    std::reverse(edge.points.begin(), edge.points.end());
  }
  std::reverse(image.edges.begin(), image.edges.end());
  std::reverse(image.numbers.begin(), image.numbers.end());
  return image;
}

/// The points of a line without repetition, beginning with an edge.
std::vector<PaperPoint> pointsFrom(const SewLine& line, size_t first) {
  std::vector<PaperPoint> points;
  for (size_t i = 0; i < line.edges.size(); ++i) {
    const std::vector<PaperPoint>& edge = line.edges[(first + i) % line.edges.size()].points;
    points.insert(points.end(), edge.begin(), edge.end() - 1);
  }
  return points;
}

/// Points at equal distances along a closed line.
std::vector<PaperPoint> resampled(const std::vector<PaperPoint>& line) {
  const size_t n = line.size();
  double length = 0.0;
  for (size_t i = 0; i < n; ++i) length += (line[(i + 1) % n] - line[i]).norm();
  std::vector<PaperPoint> samples;
  double reached = 0.0;  // where segment i begins
  size_t i = 0;
  for (int k = 0; k < kSamples; ++k) {
    const double at = length * k / kSamples;
    while (i + 1 < n && reached + (line[i + 1] - line[i]).norm() < at) {
      reached += (line[i + 1] - line[i]).norm();
      ++i;
    }
    const PaperPoint step = line[(i + 1) % n] - line[i];
    samples.push_back(line[i] + (at - reached) / std::max(step.norm(), 1e-12) * step);
  }
  return samples;
}

/// Largest distance of corresponding points after the best shift, mm.
double shiftedDistance(const std::vector<PaperPoint>& a, const std::vector<PaperPoint>& b) {
  PaperPoint shift = PaperPoint::Zero();
  for (size_t i = 0; i < a.size(); ++i) shift += (b[i] - a[i]) / static_cast<double>(a.size());
  double largest = 0.0;
  for (size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] + shift - b[i]).norm());
  return largest;
}

bool isSewnAlike(const SewnEdge& a, const SewnEdge& b) {
  return std::abs(a.width - b.width) < kSameWidth && a.is_folded == b.is_folded && a.is_dart == b.is_dart;
}

/// The edge of `image` that lies on the first edge of `line`, or -1.
int firstEdgeOn(const SewLine& line, const SewLine& image) {
  const size_t n = line.edges.size();
  if (image.edges.size() != n) return -1;
  const std::vector<PaperPoint> points = pointsFrom(line, 0);
  if (std::abs(areaWithin(pointsFrom(image, 0)) / areaWithin(points) - 1.0) > kAlikeArea) return -1;
  const std::vector<PaperPoint> samples = resampled(points);
  for (size_t first = 0; first < n; ++first) {
    bool is_alike = true;
    for (size_t i = 0; i < n; ++i) is_alike &= isSewnAlike(line.edges[i], image.edges[(first + i) % n]);
    if (is_alike && shiftedDistance(samples, resampled(pointsFrom(image, first))) <= kAlike)
      return static_cast<int>(first);
  }
  return -1;
}

}  // namespace

MirrorPieces mirrorPieces(const std::vector<SewLine>& lines) {
  size_t edges = 0;
  for (const SewLine& line : lines) edges += line.edges.size();
  MirrorPieces mirror{std::vector<int>(lines.size(), -1), std::vector<int>(edges, -1)};
  std::vector<char> taken(lines.size(), 0);
  for (size_t p = 0; p < lines.size(); ++p)
    for (size_t q = p + 1; q < lines.size() && !taken[p]; ++q) {
      if (taken[q]) continue;
      const SewLine image = mirrored(lines[q]);
      const int first = firstEdgeOn(lines[p], image);
      if (first < 0) continue;
      mirror.image_of[q] = static_cast<int>(p);
      taken[p] = taken[q] = 1;
      for (size_t i = 0; i < image.numbers.size(); ++i) {
        const int other = image.numbers[(first + i) % image.numbers.size()];
        mirror.twin[lines[p].numbers[i]] = other;
        mirror.twin[other] = lines[p].numbers[i];
      }
    }
  return mirror;
}

}  // namespace ease
