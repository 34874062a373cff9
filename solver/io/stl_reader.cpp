#include <fmt/format.h>

#include <algorithm>
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

std::vector<std::array<double, 3>> readBinaryCorners(std::string_view bytes, std::size_t triangles) {
  std::vector<std::array<double, 3>> corners;
  corners.reserve(3 * triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    std::array<float, 9> values{};
    std::memcpy(values.data(), bytes.data() + kHeaderBytes + t * kTriangleBytes + kNormalBytes, sizeof values);
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
    if (isWord(word, "solid")) {
      takeLine(text);  // a name, which may hold any word
      complete = false;
    } else if (isWord(word, "endsolid")) {
      takeLine(text);
      complete = corners.size() % 3 == 0;
    } else if (isWord(word, "vertex")) {
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
    } else if (isWord(word, "endfacet") && corners.size() % 3 != 0) {
      throw InputError(fmt::format("{}: triangle {} does not have three vertices", name, corners.size() / 3));
    }
  }
  if (!complete || corners.size() % 3 != 0) {
    throw InputError(fmt::format("{}: ends within triangle {}, without \"endsolid\"", name, corners.size() / 3));
  }
  return corners;
}

/// Three vertices a triangle, none of them shared.
RawMesh asTriangles(std::vector<std::array<double, 3>> corners) {
  RawMesh mesh;
  mesh.corners.resize(corners.size());
  std::iota(mesh.corners.begin(), mesh.corners.end(), 0);
  for (std::size_t end = 3; end <= corners.size(); end += 3) mesh.ends.push_back(end);
  mesh.points = std::move(corners);
  return mesh;
}

/// Text begins with the word "solid" and soon has a "facet", in capitals or not; a binary header may begin so, too.
bool isText(std::string_view bytes) {
  std::string_view head = bytes.substr(0, 2000);
  if (!isWord(takeWord(head), "solid") || head.find('\0') != head.npos) return false;
  for (std::string_view word = takeWord(head); !word.empty(); word = takeWord(head))
    if (isWord(word, "facet") || isWord(word, "endsolid")) return true;
  return false;
}

/// Number of triangles in a binary file: what its header promises if the bytes suffice, or, where the header says 0, as
/// many as there are bytes for. Spare bytes at the end are no triangles, unless they make up whole ones.
std::size_t binaryTriangles(std::string_view bytes, const std::string& name) {
  const std::size_t promised = promisedTriangles(bytes);
  const std::size_t body = bytes.size() < kHeaderBytes ? 0 : bytes.size() - kHeaderBytes, held = body / kTriangleBytes;
  if (promised == 0 && held > 0 && body % kTriangleBytes == 0) return held;
  if (promised == 0 || promised > held)
    throw InputError(fmt::format("{}: not an STL file, or cut short: it has {} bytes, and {} triangles need {}", name,
                                 bytes.size(), promised, kHeaderBytes + kTriangleBytes * promised));
  if (promised < held && body % kTriangleBytes == 0)
    throw InputError(
        fmt::format("{}: its header promises {} triangles, but {} follow: expected the same number; "
                    "export it again",
                    name, promised, held));
  return promised;
}

}  // namespace

RawMesh readStl(std::string_view bytes, const std::string& name) {
  if (!hasBinarySize(bytes) && isText(bytes)) return asTriangles(readTextCorners(bytes, name));
  return asTriangles(readBinaryCorners(bytes, binaryTriangles(bytes, name)));
}

}  // namespace ease
