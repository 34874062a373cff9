#include "apps/frames.h"

namespace ease {

namespace {

NamedArray scalars(const std::string& name, const std::vector<double>& values) {
  return {name, 1, std::vector<float>(values.begin(), values.end())};
}

template <class Value>
NamedArray perTriangle(const std::string& name, int count, const Value& value) {
  NamedArray array{name, 1, std::vector<float>(count)};
  for (int t = 0; t < count; ++t) array.values[t] = static_cast<float>(value(t));
  return array;
}

NamedArray restAreaRatio(const Cloth& cloth, const std::vector<double>& first_areas) {
  return perTriangle("rest_area_ratio", cloth.triangleCount(),
                     [&](int t) { return cloth.restAreas()[t] / first_areas[t]; });
}

}  // namespace

Frame garmentFrame(const Cloth& cloth, const State& state, const GarmentFields& fields) {
  const int m = cloth.triangleCount();
  const std::vector<Stretch>& s = fields.stretch;
  Frame frame;
  frame.positions = state.positions;
  frame.triangle_arrays = {perTriangle("sigma_1", m, [&](int t) { return s[t].sigma_1; }),
                           perTriangle("sigma_2", m, [&](int t) { return s[t].sigma_2; }),
                           perTriangle("stretch_warp", m, [&](int t) { return s[t].warp; }),
                           perTriangle("stretch_weft", m, [&](int t) { return s[t].weft; }),
                           restAreaRatio(cloth, fields.first_areas)};
  const double* velocity = state.velocities.data();
  NamedArray pinned{"pinned", 1, std::vector<float>(cloth.vertexCount(), 0.0f)};
  for (int v : fields.pinned) pinned.values[v] = 1.0f;
  frame.vertex_arrays = {{"velocity_m_s", 3, std::vector<float>(velocity, velocity + state.velocities.size())}, pinned};
  if (!fields.gap.empty()) {
    frame.vertex_arrays.push_back(scalars("gap_m", fields.gap));
    frame.vertex_arrays.push_back(scalars("contact_pressure_Pa", fields.pressure));
  }
  return frame;
}

Frame restFrame(const Cloth& cloth, const std::vector<double>& first_areas) {
  return {cloth.restPositions(), {}, {restAreaRatio(cloth, first_areas)}};
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
