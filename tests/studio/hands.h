// Hands for the editor without a window: points are given in metres and projected with the camera.
#pragma once

#include <filesystem>

#include "apps/studio/tool.h"
#include "tests/apps/temporary_directory.h"

namespace ease {

/// A scene of few vertices on the built-in body, that begins without a garment.
inline const char* const kSmallDraft = R"([body]
builtin = "mannequin"
poses = ["t", "a"]
seconds_per_pose = 0.2

[garment]
resolution = 600

[material]
density = 0.15

[solver]
time_step = 0.0125
steps_per_pose = 1

[adaption]
limit = 0.08
)";

/// A scene like that with a top that ends at neck, arms and waist.
inline std::string smallTop() {
  return std::string(kSmallDraft) + R"(
[[garment.boundary]]
name = "neck"
plane = { point = [0, 1.475, 0], normal = [0, 0.9, 0.44] }

[[garment.boundary]]
name = "left sleeve"
plane = { point = [0.33, 1.39, 0], normal = [1, 0, 0] }

[[garment.boundary]]
name = "right sleeve"
plane = { point = [-0.33, 1.39, 0], normal = [1, 0, 0] }

[[garment.boundary]]
name = "hem"
plane = { point = [0, 1.0, 0], normal = [0, 1, 0] }

[garment.region]
seed = [0, 1.2, 0.12]
)";
}

/// That scene, its top with seams at sides and shoulders, which leave a front and a back.
inline std::string sewnTop() {
  const auto seam = [](const char* name, const char* from, const char* to, const char* point) {
    return std::string("\n[[garment.seam]]\nname = \"") + name + "\"\nfrom = \"" + from + "\"\nto = \"" + to +
           "\"\npoints = [" + point + "]\n";
  };
  return smallTop() + seam("left side", "hem", "left sleeve", "[0.13, 1.15, 0]") +
         seam("right side", "hem", "right sleeve", "[-0.13, 1.15, 0]") +
         seam("left shoulder", "neck", "left sleeve", "[0.17, 1.46, 0]") +
         seam("right shoulder", "neck", "right sleeve", "[-0.17, 1.46, 0]") + "\n[pattern]\ncheck = false\n";
}

class Hands {
 public:
  explicit Hands(const std::string& text) : studio(Document(text, directory.path / "scene.toml")) {
    studio.stage.size = {900, 700};
    const Positions& body = studio.stage.body();
    studio.stage.camera.frame(body.colwise().minCoeff(), body.colwise().maxCoeff(), studio.stage.size);
    studio.finishWork();
  }

  void take(PartKind kind) { tool = makeTool(kind, studio); }

  /// The pixel at which the surface of the body near `point` appears, as shown.
  Pointer at(const Vec3& point) const {
    const Stage& stage = studio.stage;
    const Vec3 on =
        placeOn(nearestPlace(point, stage.body(), stage.bodyTriangles()), stage.body(), stage.bodyTriangles());
    return pixel(on);
  }
  Pointer pixel(const Vec3& point) const {
    const Projected seen = studio.stage.project(point);
    return {seen.x, seen.y};
  }
  Pointer onCloth(const Vec3& point) const {
    const Stage& stage = studio.stage;
    const Triangles& triangles = stage.clothAsMade().triangles;
    return pixel(placeOn(nearestPlace(point, stage.cloth(), triangles), stage.cloth(), triangles));
  }

  void click(const Pointer& pointer) {
    tool->hover(pointer);
    tool->press(pointer);
    tool->release(pointer);
  }
  void drag(Pointer from, const Pointer& to, int steps = 8) {
    tool->press(from);
    for (int k = 1; k <= steps; ++k) {
      Pointer between = from;
      between.x += (to.x - from.x) * k / steps;
      between.y += (to.y - from.y) * k / steps;
      tool->drag(between);
    }
    Pointer end = to;
    end.shift = from.shift;
    tool->release(end);
  }
  void look(double yaw_deg) { studio.stage.camera.yaw_deg = yaw_deg; }
  /// A vertex of the loop with this name that is seen best from here.
  Pointer onLoop(const std::string& name) const {
    const Stage& stage = studio.stage;
    for (const NamedLoop& loop : stage.made().edges)
      if (loop.name == name) {
        int nearest = loop.vertices.front();
        for (const int v : loop.vertices)
          if (Vec3(stage.cloth().row(v)).dot(stage.camera.towardsEye()) >
              Vec3(stage.cloth().row(nearest)).dot(stage.camera.towardsEye()))
            nearest = v;
        return pixel(stage.cloth().row(nearest));
      }
    return {-1.0, -1.0};
  }

  /// A vertex in the middle of a seam.
  Pointer onSeam(size_t number) const {
    const std::vector<int>& line = studio.stage.made().input.authored->seams[number].vertices;
    return pixel(studio.stage.cloth().row(line[line.size() / 2]));
  }

  TemporaryDirectory directory;
  Studio studio;
  std::unique_ptr<Tool> tool;
};

}  // namespace ease
