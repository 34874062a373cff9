#include "apps/pinned_vertices.h"

#include <fmt/format.h>

#include <map>

#include "garment/named_loop.h"
#include "solver/base/error.h"

namespace ease {

namespace {

/// Finds a loop by the name that its tool gave it or, for a garment not made by tools, by a name for its place.
std::vector<int> loopOfGarment(const std::string& name, const SceneInput& input, const Topology& topology) {
  if (!input.authored) return findLoop(topology, input.garment.positions, name);
  const std::vector<NamedLoop>& loops = input.authored->garment.loops;
  return loops[loopNamed(loops, name, fmt::format("loop = '{}'", name))].vertices;
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

/// Turns numbers of vertices in the garment's file into the garment's own.
std::vector<int> fromFile(std::vector<int> vertices, const SceneInput& input) {
  const long count = input.as_read ? input.as_read->mesh.positions.rows() : input.garment.positions.rows();
  for (int& v : vertices) {
    if (v >= count)
      throw InputError(fmt::format("vertex {}: expected 0 to {}, the vertices of the garment", v, count - 1));
    if (!input.as_read) continue;
    if (input.as_read->vertex[v] < 0) throw InputError(fmt::format("vertex {} belongs to no triangle", v));
    v = input.as_read->vertex[v];
  }
  return vertices;
}

}  // namespace

std::vector<std::vector<int>> pinnedVertices(const Scene& scene, const SceneInput& input, const Topology& topology) {
  const TriangleMesh& garment = input.garment;
  std::vector<std::vector<int>> pins;
  std::map<int, bool> pinned;  // whether to the body
  for (const PinScene& pin : scene.garment.pins) {
    const std::string where = fmt::format("{}: [[garment.pin]] number {}", scene.file.string(), pins.size() + 1);
    try {
      if (const auto* loop = std::get_if<std::string>(&pin.what)) {
        pins.push_back(loopOfGarment(*loop, input, topology));
      } else if (const auto* ball = std::get_if<Brush>(&pin.what)) {
        pins.push_back(verticesIn(*ball, garment.positions));
      } else {
        pins.push_back(fromFile(std::get<std::vector<int>>(pin.what), input));
      }
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", where, error.what()));
    }
    std::erase_if(pins.back(), [&, to_body = pin.to_body](int v) {
      const auto [entry, is_new] = pinned.emplace(v, to_body);
      if (!is_new && entry->second != to_body)
        throw InputError(fmt::format("{}: vertex {} is pinned to the body and in space: expected one of them", where,
                                     fileVertex(input, v)));
      return !is_new;  // pinned alike before
    });
  }
  return pins;
}

}  // namespace ease
