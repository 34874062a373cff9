#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <cstdint>
#include <cstring>
#include <numeric>

#include "solver/base/error.h"
#include "solver/io/mesh_readers.h"

namespace ease {
namespace {

// A binary file has a header of 80 bytes, the number of triangles (4 bytes), and for each triangle its normal and three
// corners (12 floats) and two more bytes.
constexpr std::size_t kHeaderBytes = 84, kTriangleBytes = 50, kNormalBytes = 12;

std::size_t promisedTriangles(std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= kHeaderBytes) std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

bool hasBinarySize(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes && bytes.size() == kHeaderBytes + kTriangleBytes * promisedTriangles(bytes);
}

std::vector<std::array<double, 3>> readBinaryCorners(std::string_view bytes) {
  std::vector<std::array<double, 3>> corners;
  corners.reserve(3 * promisedTriangles(bytes));
  for (std::size_t at = kHeaderBytes; at < bytes.size(); at += kTriangleBytes) {
    std::array<float, 9> values{};
    std::memcpy(values.data(), bytes.data() + at + kNormalBytes, sizeof values);
    for (int k = 0; k < 3; ++k) corners.push_back({values[3 * k], values[3 * k + 1], values[3 * k + 2]});
  }
  return corners;
}

std::vector<std::array<double, 3>> readTextCorners(std::string_view text, const std::string& name) {
  std::vector<std::array<double, 3>> corners;
  bool complete = false;
  while (true) {
    const std::string_view word = takeWord(text);
    if (word.empty()) break;
    if (word == "solid") {
      takeLine(text);  // a name, which may hold any word
      complete = false;
    } else if (word == "endsolid") {
      takeLine(text);
      complete = true;
    } else if (word == "vertex") {
      std::array<double, 3>& point = corners.emplace_back();
      for (double& coordinate : point) {
        const std::string_view found = takeWord(text);
        const std::optional<double> value = parseNumber<double>(found);
        if (!value) {
          throw InputError(fmt::format("{}: triangle {}: expected a coordinate, found \"{}\"", name,
                                       (corners.size() - 1) / 3, found));
        }
        coordinate = *value;
      }
    } else if (word == "endfacet" && corners.size() % 3 != 0) {
      throw InputError(fmt::format("{}: triangle {} does not have three vertices", name, corners.size() / 3));
    }
  }
  if (!complete || corners.size() % 3 != 0) {
    throw InputError(fmt::format("{}: ends within triangle {}, without \"endsolid\"", name, corners.size() / 3));
  }
  return corners;
}

/// Merges corners with exactly equal coordinates into one vertex, numbered in order of first appearance.
RawMesh mergeCorners(const std::vector<std::array<double, 3>>& corners) {
  std::vector<int> sorted(corners.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  // Corners with equal coordinates are sorted by corner number, so that each run of equal corners begins with its first
  // appearance. NaN must not break the sort. Its place does not matter, because readMesh refuses it later.
  const auto comesBefore = [&](int i, int j) {
    for (int k = 0; k < 3; ++k) {
      if (corners[i][k] != corners[j][k]) return std::is_lt(std::strong_order(corners[i][k], corners[j][k]));
    }
    return i < j;
  };
  std::sort(sorted.begin(), sorted.end(), comesBefore);

  std::vector<int> first_equal(corners.size());
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    const bool repeats = s > 0 && corners[sorted[s]] == corners[sorted[s - 1]];
    first_equal[sorted[s]] = repeats ? first_equal[sorted[s - 1]] : sorted[s];
  }
  RawMesh mesh;
  std::vector<long long> vertex(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (first_equal[i] == static_cast<int>(i)) {
      vertex[i] = static_cast<long long>(mesh.points.size());
      mesh.points.push_back(corners[i]);
    } else {
      vertex[i] = vertex[first_equal[i]];
    }
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    mesh.triangles.push_back({vertex[i], vertex[i + 1], vertex[i + 2]});
  }
  return mesh;
}

}  // namespace

RawMesh readStl(std::string_view bytes, const std::string& name) {
  if (hasBinarySize(bytes)) return mergeCorners(readBinaryCorners(bytes));
  if (bytes.starts_with("solid")) return mergeCorners(readTextCorners(bytes, name));
  throw InputError(fmt::format("{}: not an STL file, or cut short: it has {} bytes, and {} triangles need {}", name,
                               bytes.size(), promisedTriangles(bytes),
                               kHeaderBytes + kTriangleBytes * promisedTriangles(bytes)));
}

}  // namespace ease
