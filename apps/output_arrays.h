// The arrays of every written mesh, as tables: a row says what an array is called and means, and computes its values.
//
// From these tables come the arrays of the written files; a test compares the README's lists with them.  A new array
// is a row here, a line of the README and a line in that test's own list.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/frames.h"
#include "apps/scene.h"
#include "garment/pieces.h"

namespace ease {

enum class Element { vertex, triangle };

/// One array that is computed from a `Source`.
template <class Source>
struct OutputArray {
  std::string name;                                          // ends in its unit where it has one
  std::string unit;                                          // empty: a pure number
  Element element;                                           // what each value belongs to
  int components;                                            // values per element
  std::string text;                                          // one line, for people
  std::function<std::vector<float>(const Source&)> compute;  // empty: this file has no such array
  bool in_rest_shape = false;                                // files of the rest shape have it, too
};

/// What the arrays of a run are computed from.  For the rest shape, `state` and `fields` are null.
struct RunSource {
  const Cloth& cloth;
  const std::vector<double>& first_areas;  // areas of the first rest shape's triangles, m^2
  const State* state = nullptr;
  const GarmentFields* fields = nullptr;
};

/// Arrays of the garment over time and of the rest shape (`ease run`).
const std::vector<OutputArray<RunSource>>& runArrays();

/// Arrays of a garment that the scene's tools made (`ease garment`).
const std::vector<OutputArray<SceneInput>>& madeGarmentArrays();

/// Arrays of a garment or rest shape that is cut along its seams.
const std::vector<OutputArray<Pieces>>& pieceArrays();

/// Computes an array and adds it to the frame, unless it has no values.
template <class Source>
void addArray(const OutputArray<Source>& array, const Source& source, Frame& frame) {
  NamedArray computed{array.name, array.components, array.compute(source)};
  if (computed.values.empty()) return;
  auto& arrays = array.element == Element::vertex ? frame.vertex_arrays : frame.triangle_arrays;
  arrays.push_back(std::move(computed));
}

}  // namespace ease
