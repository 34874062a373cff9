#include "apps/pinned_vertices.h"

#include <fmt/format.h>

#include <set>

#include "apps/words.h"
#include "garment/named_loop.h"
#include "solver/base/error.h"

namespace ease {

namespace {

/// Finds a loop by the name that its tool gave it or, for a garment not made by tools, by a name for its place.
std::vector<int> loopNamed(const std::string& name, const SceneInput& input, const Topology& topology) {
  if (!input.authored) return findLoop(topology, input.garment.positions, name);
  std::vector<std::string> names;
  for (const NamedLoop& loop : input.authored->garment.loops) {
    if (loop.name == name) return loop.vertices;
    names.push_back(loop.name);
  }
  throw InputError(fmt::format("loop = '{}': expected {}", name, listWords(names)));
}

std::vector<int> verticesIn(const Brush& ball, const Positions& positions) {
  std::vector<int> vertices;
  for (int v = 0; v < positions.rows(); ++v)
    if (distanceTo(ball, positions.row(v)) <= ball.radius) vertices.push_back(v);
  if (vertices.empty())
    throw InputError(fmt::format("at = [{:g}, {:g}, {:g}], radius = {:g}: no vertex of the garment lies in this ball",
                                 ball.at.x(), ball.at.y(), ball.at.z(), ball.radius));
  return vertices;
}

}  // namespace

std::vector<std::vector<int>> pinnedVertices(const Scene& scene, const SceneInput& input, const Topology& topology) {
  const TriangleMesh& garment = input.garment;
  std::vector<std::vector<int>> pins;
  std::set<int> pinned;
  for (const PinScene& pin : scene.garment.pins) {
    const std::string where = fmt::format("{}: [[garment.pin]] number {}", scene.file.string(), pins.size() + 1);
    try {
      if (const auto* loop = std::get_if<std::string>(&pin.what)) {
        pins.push_back(loopNamed(*loop, input, topology));
      } else if (const auto* ball = std::get_if<Brush>(&pin.what)) {
        pins.push_back(verticesIn(*ball, garment.positions));
      } else {
        pins.push_back(std::get<std::vector<int>>(pin.what));
      }
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", where, error.what()));
    }
    for (const int v : pins.back()) {
      if (v >= garment.positions.rows())
        throw InputError(fmt::format("{}: vertex {}: expected 0 to {}, the vertices of the garment", where, v,
                                     garment.positions.rows() - 1));
      if (!pinned.insert(v).second) throw InputError(fmt::format("{}: vertex {} is pinned twice", where, v));
    }
  }
  return pins;
}

}  // namespace ease
