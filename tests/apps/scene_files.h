// A scene of two poses of a box and a tube around it, whose files tests change.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <sstream>

#include "apps/scene.h"
#include "solver/base/error.h"
#include "tests/apps/temporary_directory.h"

namespace ease {

inline std::string objText(const TriangleMesh& mesh) {
  std::ostringstream out;
  for (const auto& x : mesh.positions.rowwise()) out << "v " << x << '\n';
  for (const auto& t : mesh.triangles.rowwise()) out << "f " << (t.array() + 1).matrix() << '\n';
  return out.str();
}

/// Makes four walls around the y axis from `low` to `high` and, if `closed`, a floor and a lid:
///
///      6----7
///     /|   /|
///    4----5 |
///    | 2--|-3
///    0----1
inline TriangleMesh box(double half_width, double low, double high, bool closed) {
  TriangleMesh mesh;
  mesh.positions.resize(8, 3);
  for (int v = 0; v < 8; ++v) {
    const double x = v & 1 ? half_width : -half_width, z = v & 2 ? -half_width : half_width;
    mesh.positions.row(v) << x, (v & 4 ? high : low), z;
  }
  mesh.triangles.resize(closed ? 12 : 8, 3);
  mesh.triangles.topRows(8) << 0, 1, 5, 0, 5, 4, 1, 3, 7, 1, 7, 5, 3, 2, 6, 3, 6, 7, 2, 0, 4, 2, 4, 6;
  if (closed) mesh.triangles.bottomRows(4) << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6;
  return mesh;
}

inline const TriangleMesh kBox = box(0.2, 0.0, 1.7, true);
inline const TriangleMesh kTube = box(0.23, 0.8, 1.4, false);

/// The files of a scene with two poses and a tube around them.  Tests change them.
struct Files {
  Files() {
    write("first.obj", kBox);
    write("second.obj", kBox);
    write("tube.obj", kTube);
  }
  void write(const std::string& name, const TriangleMesh& mesh) const { directory.write(name, objText(mesh)); }

  SceneInput read(const std::string& more = "", const std::string& body = "") const {
    const std::string toml = "[body]\nposes = ['first.obj', 'second.obj']\n" + body + "[garment]\nmesh = 'tube.obj'\n";
    return readSceneInput(readScene(directory.write("scene.toml", toml + more)));
  }
  SceneInput readWithoutBody(const std::string& more) const {
    const std::string toml = "solver = {steps = 1}\n[garment]\nmesh = 'tube.obj'\n";
    return readSceneInput(readScene(directory.write("scene.toml", toml + more)));
  }
  std::string errorOf(const std::string& more = "", const std::string& body = "") const {
    return messageOf<InputError>([&] { read(more, body); });
  }

  TemporaryDirectory directory;
};

}  // namespace ease
