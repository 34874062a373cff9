// Helpers of the mesh file tests: a square that every format can hold, a folder for files, the message of a refused
// file.
#pragma once

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "solver/base/error.h"
#include "solver/io/mesh_io.h"
#include "tests/io/raw_numbers.h"

namespace ease {

/// A folder of its own for one test case, removed with it.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("ease_mesh_" + std::to_string(getpid()))) {
    std::filesystem::create_directory(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// Message of the InputError with which the file is refused: one line that begins with its name.
inline std::string messageOf(const std::filesystem::path& file) {
  try {
    readMesh(file);
  } catch (const InputError& error) {
    const std::string message = error.what();
    CHECK(message.starts_with(file.string() + ": "));
    CHECK(message.find('\n') == std::string::npos);
    return message;
  }
  return "no error";
}

/// A square, one of its corners lifted, in two triangles.
inline const Triangles kTwoTriangles = (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished();
inline const Positions kSquare = (Positions(4, 3) << 0, 0, 0, 1, 0, 0, 1, 1, 0.25, 0, 1, 0).finished();

inline void checkIsSquare(const TriangleMesh& mesh) {
  CHECK(mesh.positions == kSquare);
  CHECK(mesh.triangles == kTwoTriangles);
}

/// 5000 bytes, the same every time.
inline std::string noise() {
  std::string bytes;
  unsigned state = 1;
  for (int i = 0; i < 5000; ++i) bytes += static_cast<char>((state = 1664525U * state + 1013904223U) >> 24);
  return bytes;
}

}  // namespace ease
