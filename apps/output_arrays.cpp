#include "apps/output_arrays.h"

#include <algorithm>
#include <cmath>

namespace ease {

namespace {

using Floats = std::vector<float>;

template <class Value>
Floats toFloats(const std::vector<Value>& values) {
  return Floats(values.begin(), values.end());
}

/// Evaluates `value` at every triangle of the garment.
template <class Value>
Floats perTriangle(const RunSource& run, const Value& value) {
  Floats values(run.cloth.triangleCount());
  for (size_t t = 0; t < values.size(); ++t) values[t] = static_cast<float>(value(t));
  return values;
}

/// Returns one member of the stretch, such as `sigma_1`, of every triangle.
Floats stretches(const RunSource& run, double Stretch::*member) {
  return perTriangle(run, [&](size_t t) { return run.fields->stretch[t].*member; });
}

/// Angle between warp and weft less a right one, from |warp| |weft| sin(angle) = sigma_1 sigma_2.
Floats shears(const RunSource& run) {
  return perTriangle(run, [&](size_t t) {
    const Stretch& s = run.fields->stretch[t];
    const double threads = s.warp * s.weft, area = s.sigma_1 * s.sigma_2;
    return threads > 0.0 ? 180.0 / M_PI * std::acos(std::clamp(area / threads, 0.0, 1.0)) : 0.0;
  });
}

Floats restAreaRatios(const RunSource& run) {
  return perTriangle(run, [&](size_t t) { return run.cloth.restAreas()[t] / run.first_areas[t]; });
}

Floats restEdges(const RunSource& run) {
  Floats values;
  for (const Mat2& edges : run.cloth.restEdges())
    for (const double value : {edges(0, 0), edges(1, 0), edges(0, 1), edges(1, 1)})
      values.push_back(static_cast<float>(value));
  return values;
}

Floats overLimit(const RunSource& run) {
  if (!run.fields->limit) return {};
  const double limit = *run.fields->limit;
  return perTriangle(run, [&](size_t t) {
    const Stretch& s = run.fields->stretch[t];
    return s.sigma_1 <= 1.0 + limit ? 0 : isCrumpled(s, limit) ? 1 : 2;
  });
}

Floats velocities(const RunSource& run) {
  const auto& v = run.state->velocities;
  return Floats(v.data(), v.data() + v.size());
}

/// Returns 1 at each vertex in one of the `lists` and 0 at the others.
Floats marks(size_t count, const std::vector<std::vector<int>>& lists) {
  Floats values(count, 0.0F);
  for (const std::vector<int>& vertices : lists)
    for (const int v : vertices) values[v] = 1.0F;
  return values;
}

/// Returns for each vertex the number of the last loop or seam that it lies on, or -1 if there is none.
template <class Line>
Floats lineNumbers(size_t count, const std::vector<Line>& lines) {
  Floats values(count, -1.0F);
  for (size_t l = 0; l < lines.size(); ++l)
    for (const int v : lines[l].vertices) values[v] = static_cast<float>(l);
  return values;
}

size_t vertexCount(const SceneInput& input) {
  return static_cast<size_t>(input.garment.positions.rows());
}

Floats paintScales(const SceneInput& input) {
  return input.paint.empty() ? Floats(input.garment.triangles.rows(), 1.0F) : toFloats(input.paint);
}

}  // namespace

const std::vector<OutputArray<RunSource>>& runArrays() {
  using enum Element;
  using FromRun = const RunSource&;
  static const std::vector<OutputArray<RunSource>> arrays = {
      {"sigma_1", "", triangle, 1, "larger principal stretch; 1 is unstretched",
       [](FromRun r) { return stretches(r, &Stretch::sigma_1); }},
      {"sigma_2", "", triangle, 1, "smaller principal stretch",
       [](FromRun r) { return stretches(r, &Stretch::sigma_2); }},
      {"stretch_warp", "", triangle, 1, "stretch along the warp",
       [](FromRun r) { return stretches(r, &Stretch::warp); }},
      {"stretch_weft", "", triangle, 1, "stretch along the weft",
       [](FromRun r) { return stretches(r, &Stretch::weft); }},
      {"shear_deg", "deg", triangle, 1, "by how much the angle between warp and weft differs from a right one", shears},
      {"over_limit", "", triangle, 1,
       "0: within the limit, 1: over it but crumpled, 2: over it and taut; only with a limit", overLimit},
      {"rest_area_ratio", "", triangle, 1,
       "rest area over that of the first rest shape; also in files of the rest shape", restAreaRatios, true},
      {"rest_edges_m", "m", triangle, 4,
       "flat rest triangle: warp and weft of the edge from its first corner to its second, then to its third; also in "
       "files of the rest shape",
       restEdges, true},
      {"velocity_m_s", "m/s", vertex, 3, "velocity, three components", velocities},
      {"pinned", "", vertex, 1, "1 where a pin holds the vertex, else 0",
       [](FromRun r) { return marks(static_cast<size_t>(r.cloth.vertexCount()), {r.fields->pinned}); }},
      {"gap_m", "m", vertex, 1, "distance to the body less the comfort offset; only with a body",
       [](FromRun r) { return toFloats(r.fields->gap); }},
      {"contact_pressure_Pa", "Pa", vertex, 1, "pressure of the body on the cloth; only with a body",
       [](FromRun r) { return toFloats(r.fields->gap.empty() ? std::vector<double>{} : r.fields->pressure); }}};
  return arrays;
}

const std::vector<OutputArray<SceneInput>>& madeGarmentArrays() {
  using enum Element;
  using Input = const SceneInput&;
  static const std::vector<OutputArray<SceneInput>> arrays = {
      {"loop", "", vertex, 1, "number of the loop through the vertex, from 0; -1 if none",
       [](Input i) { return lineNumbers(vertexCount(i), i.authored->garment.loops); }},
      {"seam", "", vertex, 1, "number of the seam through the vertex, from 0; -1 if none",
       [](Input i) { return lineNumbers(vertexCount(i), i.authored->seams); }},
      {"offset_m", "m", vertex, 1, "comfort offset: least distance asked for from the body",
       [](Input i) { return toFloats(i.offsets); }},
      {"body_triangle", "", vertex, 1, "triangle of the body that the vertex came from; -1 on an extension",
       [](Input i) { return toFloats(i.authored->body_triangle); }},
      {"pinned", "", vertex, 1, "1 where a pin holds the vertex, else 0",
       [](Input i) { return marks(vertexCount(i), i.pins); }},
      {"paint_scale", "", triangle, 1, "scale of the triangle's rest shape; 1 where nothing is painted", paintScales}};
  return arrays;
}

const std::vector<OutputArray<Pieces>>& pieceArrays() {
  static const std::vector<OutputArray<Pieces>> arrays = {
      {"garment_vertex", "", Element::vertex, 1,
       "vertex of the whole garment that this one was cut from; only in pieces",
       [](const Pieces& pieces) { return toFloats(pieces.glue); }},
      {"piece", "", Element::triangle, 1, "number of the triangle's piece, from 0; only in pieces",
       [](const Pieces& pieces) { return toFloats(pieces.piece); }}};
  return arrays;
}

}  // namespace ease
