// The parts of a garment as the scene's text names them, and the edits that add, rename and remove them.
#pragma once

#include <string>
#include <vector>

#include "apps/scene.h"
#include "apps/studio/scene_text.h"

namespace ease {

enum class PartKind { boundary, region, extension, paint, comfort, pin, seam };

/// One part: the k-th table of its kind.
struct Part {
  PartKind kind;
  int number = 0;     // k
  std::string label;  // for people, e.g. "neck", "hem + 0.3 m"
  bool operator==(const Part& other) const { return kind == other.kind && number == other.number; }
};

/// "garment.boundary", ...
const char* pathOf(PartKind kind);
/// "Boundaries", ...
const char* pluralOf(PartKind kind);

/// All parts of a scene, kind after kind in the order of PartKind.
std::vector<Part> partsOf(const Scene& scene);

/// A part that names this one and cannot be without it, for people: "extension 'waist + 0.40 m'"; empty: there is none.
std::string userOf(const Scene& scene, const Part& part);

/// The boundary whose points are the mirror images of those of the k-th one, x and -x; -1: there is none.
int mirrorImageOf(const Scene& scene, int boundary);

/// A name that no boundary (or seam) of the scene has: "loop 1", "loop 2", ... ("seam 1", ...).
std::string freeName(const Scene& scene, PartKind kind);

// Each function returns the text with one part more, or one changed.
std::string withBoundary(const std::string& text, const std::string& name, const std::vector<Vec3>& points);
std::string withBoundaryPoints(const std::string& text, int number, const std::vector<Vec3>& points);
std::string withRegion(const std::string& text, const Vec3& seed);
/// An extension of the loop by `length` (m), scaled; replaces the k-th one if `number` is not negative.
std::string withExtension(const std::string& text, int number, const std::string& loop, double length, double scale);
std::string withPaint(const std::string& text, const std::vector<Vec3>& stroke, double radius, double scale);
std::string withComfort(const std::string& text, const std::vector<Vec3>& stroke, double radius, double offset);
std::string withPinnedLoop(const std::string& text, const std::string& loop);
std::string withPinnedBall(const std::string& text, const Vec3& at, double radius);
/// A seam between two loops, or, with empty names, a closed one.
std::string withSeam(const std::string& text, const std::string& name, const std::string& from, const std::string& to,
                     const std::vector<Vec3>& points);
std::string without(const std::string& text, const Part& part);

/// Renames a boundary wherever it is named, or a seam.
std::string renamed(const std::string& text, const Scene& scene, const Part& part, const std::string& name);

/// The part of a scene's text that decides the mesh of its garment: [body], [garment] without paint and pins, and the
/// comfort offset.  Two scenes with equal keys make the same mesh.
std::string meshKey(const std::string& text);

}  // namespace ease
