// What the tests of this folder share: a temporary directory, what was printed meanwhile, small meshes, arrays without
// pattern, VTK's reader.
#pragma once

#include <fcntl.h>
#include <unistd.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include "solver/mesh/triangle_mesh.h"
#include "viz/vtp.h"

namespace test {

class Directory {
 public:
  Directory() {
    std::string name = (std::filesystem::temp_directory_path() / "ease_viz_XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Directory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Bytes that `call` prints on the terminal, by whatever way: both output streams lead to a file meanwhile.
template <class Call>
std::uintmax_t printedBytes(const Call& call) {
  const Directory directory;
  const std::filesystem::path file = directory.path() / "printed";
  std::fflush(nullptr);
  const int to_file = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  const int before[] = {::dup(STDOUT_FILENO), ::dup(STDERR_FILENO)};
  for (int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(to_file, stream);
  call();
  std::fflush(nullptr);
  for (int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(before[stream - STDOUT_FILENO], stream);
  for (int descriptor : {to_file, before[0], before[1]}) ::close(descriptor);
  return std::filesystem::file_size(file);
}

/// A wavy sheet of n x n vertices, 1 m wide.
inline ease::TriangleMesh gridMesh(int n) {
  ease::TriangleMesh mesh;
  mesh.positions.resize(n * n, 3);
  mesh.triangles.resize(2 * (n - 1) * (n - 1), 3);
  for (int i = 0; i < n * n; ++i) {
    const double x = static_cast<double>(i % n) / (n - 1), y = static_cast<double>(i / n) / (n - 1);
    mesh.positions.row(i) << x, y, 0.1 * std::sin(7 * x + 3 * y);
  }
  int t = 0;
  for (int row = 0; row + 1 < n; ++row) {
    for (int column = 0; column + 1 < n; ++column) {
      const int corner = row * n + column;
      mesh.triangles.row(t++) << corner, corner + 1, corner + n + 1;
      mesh.triangles.row(t++) << corner, corner + n + 1, corner + n;
    }
  }
  return mesh;
}

/// Values in [0, 1) that no compression shortens.
inline ease::NamedArray noise(const std::string& name, int components, Eigen::Index tuples) {
  ease::NamedArray array{name, components, {}};
  std::uint32_t state = 12345;
  for (Eigen::Index i = 0; i < components * tuples; ++i) {
    state = 1664525u * state + 1013904223u;
    array.values.push_back(static_cast<float>(state >> 8) / 16777216.0f);
  }
  return array;
}

inline vtkSmartPointer<vtkPolyData> readVtp(const std::filesystem::path& file) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

}  // namespace test
