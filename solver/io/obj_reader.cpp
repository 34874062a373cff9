#include <fmt/format.h>

#include "solver/base/error.h"
#include "solver/io/mesh_readers.h"

namespace ease {
namespace {

std::array<double, 3> readVertex(std::string_view line, const std::string& name, int line_number) {
  std::array<double, 3> point{};
  for (double& coordinate : point) {
    const std::string_view word = takeWord(line);
    const std::optional<double> value = parseNumber<double>(word);
    if (!value) {
      throw InputError(fmt::format("{}: line {}: expected three coordinates, found \"{}\"{}", name, line_number, word,
                                   word.find(',') == word.npos ? "" : "; write decimal points, not commas"));
    }
    coordinate = *value;
  }
  return point;
}

/// Reads the corners of a face, written "v", "v/vt", "v//vn" or "v/vt/vn"; only v is used. Positive indices count from
/// 1; negative indices count back from the last vertex read so far, which is -1.
void readFace(std::string_view line, const std::string& name, int line_number, long long vertices_so_far,
              std::vector<long long>& corners) {
  corners.clear();
  for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
    const std::optional<long long> index = parseNumber<long long>(word.substr(0, word.find('/')));
    if (!index || *index == 0) {
      throw InputError(fmt::format("{}: line {}: expected a vertex index, found \"{}\"", name, line_number, word));
    }
    corners.push_back(*index > 0 ? *index - 1 : vertices_so_far + *index);
  }
  if (corners.size() < 3) {
    throw InputError(fmt::format("{}: line {}: a face with {} vertices", name, line_number, corners.size()));
  }
}

}  // namespace

RawMesh readObj(std::string_view bytes, const std::string& name) {
  RawMesh mesh;
  std::vector<long long> corners;
  std::string joined;
  for (int line_number = 1; !bytes.empty(); ++line_number) {
    std::string_view line = takeLine(bytes);
    const int first_line = line_number;
    if (line.ends_with('\\')) {  // goes on in the next line
      joined = line;
      while (joined.ends_with('\\') && !bytes.empty()) {
        joined.back() = ' ';
        joined += takeLine(bytes);
        ++line_number;
      }
      line = joined;
    }
    line = line.substr(0, line.find('#'));
    const std::string_view keyword = takeWord(line);
    if (isWord(keyword, "v")) mesh.points.push_back(readVertex(line, name, first_line));
    if (isWord(keyword, "f") || isWord(keyword, "fo")) {
      readFace(line, name, first_line, static_cast<long long>(mesh.points.size()), corners);
      mesh.addPolygon(corners);
    }
  }
  return mesh;
}

}  // namespace ease
