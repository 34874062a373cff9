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

Frame asRead(const Frame& frame, const std::optional<GarmentAsRead>& file) {
  if (!file) return frame;
  Frame spread{file->mesh.positions, frame.vertex_arrays, frame.triangle_arrays};
  for (size_t v = 0; v < file->vertex.size(); ++v)
    if (file->vertex[v] >= 0) spread.positions.row(static_cast<long>(v)) = frame.positions.row(file->vertex[v]);
  for (size_t a = 0; a < frame.vertex_arrays.size(); ++a) {
    const NamedArray& array = frame.vertex_arrays[a];
    std::vector<float>& values = spread.vertex_arrays[a].values;
    values.assign(file->vertex.size() * array.components, 0.0F);
    for (size_t v = 0; v < file->vertex.size(); ++v)
      for (int k = 0; k < array.components && file->vertex[v] >= 0; ++k)
        values[v * array.components + k] = array.values[static_cast<size_t>(file->vertex[v]) * array.components + k];
  }
  return spread;
}

const Triangles& trianglesAsRead(const SceneInput& input) {
  return input.as_read ? input.as_read->mesh.triangles : input.garment.triangles;
}

std::vector<int> verticesAsRead(const SceneInput& input, std::vector<int> vertices) {
  if (!input.as_read) return vertices;
  std::vector<int> first(input.garment.positions.rows(), -1);
  const std::vector<int>& of_file = input.as_read->vertex;
  for (size_t v = of_file.size(); v-- > 0;)
    if (of_file[v] >= 0) first[of_file[v]] = static_cast<int>(v);
  for (int& v : vertices) v = first[v];
  return vertices;
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
