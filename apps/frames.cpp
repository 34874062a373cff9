#include "apps/frames.h"

#include "apps/output_arrays.h"

namespace ease {

Frame garmentFrame(const Cloth& cloth, const State& state, const GarmentFields& fields) {
  const RunSource source{cloth, fields.first_areas, &state, &fields};
  Frame frame{state.positions, {}, {}};
  for (const OutputArray<RunSource>& array : runArrays()) addArray(array, source, frame);
  return frame;
}

Frame restFrame(const Cloth& cloth, const std::vector<double>& first_areas) {
  const RunSource source{cloth, first_areas};
  Frame frame{cloth.restPositions(), {}, {}};
  for (const OutputArray<RunSource>& array : runArrays())
    if (array.in_rest_shape) addArray(array, source, frame);
  return frame;
}

Frame restored(const Frame& frame, const Numbering& numbering) {
  Frame original = frame;
  original.positions = restored(frame.positions, numbering.vertices);
  for (NamedArray& array : original.vertex_arrays)
    array.values = restored(array.values, numbering.vertices, array.components);
  for (NamedArray& array : original.triangle_arrays)
    array.values = restored(array.values, numbering.triangles, array.components);
  return original;
}

}  // namespace ease
