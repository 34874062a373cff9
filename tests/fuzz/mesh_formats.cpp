#include "tests/fuzz/mesh_formats.h"

#include <cstdint>
#include <sstream>
#include <stdexcept>

#include "solver/io/mesh_io.h"
#include "tests/apps/temporary_directory.h"
#include "tests/io/raw_numbers.h"
#include "viz/vtp.h"

namespace ease {

namespace {

std::string plyHeader(const TriangleMesh& mesh, const char* encoding) {
  std::ostringstream out;
  out << "ply\nformat " << encoding << " 1.0\nelement vertex " << mesh.positions.rows()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.triangles.rows()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  return out.str();
}

std::string asciiPly(const TriangleMesh& mesh) {
  std::ostringstream out;
  out << plyHeader(mesh, "ascii");
  for (const auto& x : mesh.positions.rowwise()) out << x << '\n';
  for (const auto& t : mesh.triangles.rowwise()) out << "3 " << t << '\n';
  return out.str();
}

std::string binaryPly(const TriangleMesh& mesh, bool big_endian) {
  std::string bytes = plyHeader(mesh, big_endian ? "binary_big_endian" : "binary_little_endian");
  for (const auto& x : mesh.positions.rowwise())
    for (const double value : x) append(bytes, value, big_endian);
  for (const auto& t : mesh.triangles.rowwise()) {
    append(bytes, static_cast<std::uint8_t>(3));
    for (const int v : t) append(bytes, static_cast<std::int32_t>(v), big_endian);
  }
  return bytes;
}

std::string asciiStl(const TriangleMesh& mesh) {
  std::ostringstream out;
  out << "solid mesh\n";
  for (const auto& t : mesh.triangles.rowwise()) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const int v : t) out << "vertex " << mesh.positions.row(v) << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid mesh\n";
  return out.str();
}

std::string off(const TriangleMesh& mesh) {
  std::ostringstream out;
  out << "OFF\n" << mesh.positions.rows() << ' ' << mesh.triangles.rows() << " 0\n" << mesh.positions << '\n';
  for (const auto& t : mesh.triangles.rowwise()) out << "3 " << t << '\n';
  return out.str();
}

std::string binaryStl(const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.rows()));
  for (const auto& t : mesh.triangles.rowwise()) {
    for (int k = 0; k < 3; ++k) append(bytes, 0.0F);  // normal
    for (const int v : t)
      for (int k = 0; k < 3; ++k) append(bytes, static_cast<float>(mesh.positions(v, k)));
    append(bytes, static_cast<std::uint16_t>(0));
  }
  return bytes;
}

std::string asciiVtp(const TriangleMesh& mesh) {
  std::ostringstream out;
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      << "<PolyData>\n<Piece NumberOfPoints=\"" << mesh.positions.rows() << "\" NumberOfPolys=\""
      << mesh.triangles.rows() << "\">\n"
      << "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n"
      << mesh.positions << "\n</DataArray></Points>\n"
      << "<Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n"
      << mesh.triangles << "\n</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (long t = 1; t <= mesh.triangles.rows(); ++t) out << 3 * t << ' ';
  out << "\n</DataArray></Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return out.str();
}

template <class Write>
std::string writtenBy(const Write& write, const char* name) {
  const TemporaryDirectory directory;
  write(directory.path / name);
  std::ostringstream content;
  content << std::ifstream(directory.path / name, std::ios::binary).rdbuf();
  return content.str();
}

}  // namespace

std::string bytesOf(const TriangleMesh& mesh, const std::string& file) {
  if (file == "mesh.obj") return writtenBy([&](const auto& path) { writeObj(path, mesh); }, "mesh.obj");
  if (file == "mesh.off") return off(mesh);
  if (file == "ascii.ply") return asciiPly(mesh);
  if (file == "little_endian.ply") return binaryPly(mesh, false);
  if (file == "big_endian.ply") return binaryPly(mesh, true);
  if (file == "ascii.stl") return asciiStl(mesh);
  if (file == "binary.stl") return binaryStl(mesh);
  if (file == "ascii.vtp") return asciiVtp(mesh);
  if (file != "written.vtp") throw std::invalid_argument("no such format: " + file);
  const NamedArray array{"gap_m", 1, std::vector<float>(mesh.positions.rows(), 0.5F)};
  return writtenBy(
      [&](const auto& path) {
        writeVtp(path, mesh.triangles, {mesh.positions, {array}, {}});
      },
      "mesh.vtp");
}

}  // namespace ease
