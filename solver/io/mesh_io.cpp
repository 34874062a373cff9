#include "solver/io/mesh_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "solver/io/mesh_readers.h"
#include "solver/io/text_encoding.h"
#include "solver/mesh/mesh_checks.h"
#include "solver/mesh/weld.h"

namespace ease {
namespace {

namespace fs = std::filesystem;

std::string readBytes(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) throw InputError(fmt::format("{}: no such file", file.string()));
  if (!fs::is_regular_file(file, ignored)) throw InputError(fmt::format("{}: not a regular file", file.string()));
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) throw InputError(fmt::format("{}: cannot be opened for reading", file.string()));
  std::string bytes(static_cast<std::size_t>(stream.tellg()), '\0');
  stream.seekg(0);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    throw InputError(fmt::format("{}: cannot be read to its end", file.string()));
  }
  if (bytes.empty()) throw InputError(fmt::format("{}: the file is empty", file.string()));
  return bytes;
}

std::string lowerCaseExtension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

RawMesh readRaw(const fs::path& file) {
  const std::string name = file.string();
  const std::string extension = lowerCaseExtension(file);
  if (!isMeshFile(file)) {
    throw InputError(fmt::format("{}: a mesh's name ends in .ply, .obj, .stl, .off or .vtp", name));
  }
  const std::string bytes = asUtf8(readBytes(file));
  if (extension == ".ply") return readPly(bytes, name);
  if (extension == ".obj") return readObj(bytes, name);
  if (extension == ".stl") return readStl(bytes, name);
  if (extension == ".off") return readOff(bytes, name);
  return readVtp(bytes, name);
}

Polygons checkedPolygons(const RawMesh& raw, const std::string& name) {
  if (raw.ends.empty()) throw InputError(fmt::format("{}: holds no triangles", name));
  const std::size_t most = std::numeric_limits<int>::max();
  if (raw.points.size() > most || raw.corners.size() > most) {
    throw InputError(fmt::format("{}: holds more vertices or corners of faces than {}", name, most));
  }
  Polygons polygons;
  polygons.points.resize(static_cast<int>(raw.points.size()), 3);
  for (int i = 0; i < polygons.points.rows(); ++i)
    for (int k = 0; k < 3; ++k) polygons.points(i, k) = raw.points[i][k] + 0.0;  // turns -0 into 0
  polygons.ends.assign(raw.ends.begin(), raw.ends.end());
  polygons.corners.resize(raw.corners.size());
  for (std::size_t c = 0; c < raw.corners.size(); ++c) {
    const long long vertex = raw.corners[c];
    if (vertex < 0 || vertex >= polygons.points.rows()) {
      const auto face = std::upper_bound(raw.ends.begin(), raw.ends.end(), c) - raw.ends.begin();
      throw InputError(fmt::format("{}: face {} has vertex {}, but there are {} (counted from 0)", name, face, vertex,
                                   polygons.points.rows()));
    }
    polygons.corners[c] = static_cast<int>(vertex);
  }
  checkCoordinates(polygons.points, name);
  return polygons;
}

}  // namespace

Polygons readPolygons(const fs::path& file) {
  return checkedPolygons(readRaw(file), file.string());
}

bool isMeshFile(const fs::path& file) {
  const std::string extension = lowerCaseExtension(file);
  return extension == ".ply" || extension == ".obj" || extension == ".stl" || extension == ".off" ||
         extension == ".vtp";
}

bool sharesNoVertices(const fs::path& file) {
  return lowerCaseExtension(file) == ".stl";
}

TriangleMesh readMesh(const fs::path& file) {
  Polygons polygons = readPolygons(file);
  const Triangles triangles = trianglesOf(polygons, cutPolygons(polygons, file.string()));
  if (!sharesNoVertices(file)) return {std::move(polygons.points), triangles};
  const Weld weld = findWeld(triangles, {&polygons.points, 1}, true);
  return {welded(polygons.points, weld), welded(triangles, weld)};
}

void writeObj(const fs::path& file, const TriangleMesh& mesh) {
  fmt::memory_buffer text;
  for (int i = 0; i < mesh.positions.rows(); ++i) {
    const auto p = mesh.positions.row(i);
    fmt::format_to(std::back_inserter(text), "v {:.17g} {:.17g} {:.17g}\n", p.x(), p.y(), p.z());
  }
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const auto v = mesh.triangles.row(t);
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", v[0] + 1, v[1] + 1, v[2] + 1);
  }
  writeWholeFile(file, {text.data(), text.size()});
}

}  // namespace ease
