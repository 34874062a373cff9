// Tables of the arrays in the written meshes: a row has the name and meaning of an array, and computes its values.
//
// All arrays of the written files come from these tables, and a test compares them with the lists in docs/results.md.
// To add an array, add a row to the table, a line to that document and a line to the list in that test.
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
  std::string name;                                          // ends in the unit, if it has one
  std::string unit;                                          // empty: a pure number
  Element element;                                           // what each value belongs to
  int components;                                            // values per element
  std::string text;                                          // description of one line
  std::function<std::vector<float>(const Source&)> compute;  // empty: this file has no such array
  bool in_rest_shape = false;                                // whether files of the rest shape have it, too
};

/// Data from which the arrays of a run are computed.  For the rest shape, `state` and `fields` are null.
struct RunSource {
  const Cloth& cloth;
  const std::vector<double>& first_areas;  // areas of the first rest shape's triangles, m^2
  const State* state = nullptr;
  const GarmentFields* fields = nullptr;
};

/// Table of the arrays of the garment over time and of its rest shape (`ease run`).
const std::vector<OutputArray<RunSource>>& runArrays();

/// Table of the arrays of a garment that the scene's tools made (`ease garment`).
const std::vector<OutputArray<SceneInput>>& madeGarmentArrays();

/// Table of the arrays of a garment or rest shape that is cut along its seams.
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
