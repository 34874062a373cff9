#include "apps/scene_tools.h"

#include <fmt/format.h>

#include <set>

namespace ease {

namespace {

constexpr double kFarthest = 100.0;  // m: largest coordinate of a point

void require(const TomlTable& table, const char* key, const char* expected) {
  if (!table.has(key)) table.refuse(key, expected);
}

Vec3 readPoint(const TomlTable& table, const char* key, const char* expected) {
  require(table, key, expected);
  return readVec3(table, key, Vec3::Zero(), kFarthest, "m");
}

std::vector<Vec3> readPoints(const TomlTable& table, const char* key) {
  std::vector<Vec3> points;
  for (const std::vector<double>& row : table.rows(key, {-kFarthest, kFarthest, false, "m"}, 3))
    points.emplace_back(row[0], row[1], row[2]);
  return points;
}

PlaneNear readPlane(const TomlTable& table) {
  table.allow({"point", "normal", "near"});
  PlaneNear plane;
  plane.point = readPoint(table, "point", "a point of the plane, [x, y, z], m");
  plane.normal = readPoint(table, "normal", "the plane's normal, [x, y, z]");
  if (plane.normal.norm() < 1e-6) table.refuse("normal", "a direction, not zero");
  plane.near = readVec3(table, "near", plane.point, kFarthest, "m");
  return plane;
}

LoopRequest readBoundary(const TomlTable& table, std::set<std::string>& names) {
  table.allow({"name", "points", "vertices", "plane"});
  LoopRequest loop;
  require(table, "name", "a name for this boundary, e.g. 'neck'");
  loop.name = table.text("name", "");
  if (!names.insert(loop.name).second) table.refuse("name", "a name that no other boundary has");
  const int ways = table.has("points") + table.has("vertices") + table.has("plane");
  if (ways != 1) table.refuse(table.has("plane") ? "plane" : "points", "one of points, vertices and plane");
  loop.points = readPoints(table, "points");
  loop.vertices = table.integers("vertices", 0, 1000000000);
  if (const auto plane = table.table("plane")) loop.plane = readPlane(*plane);
  return loop;
}

Extension readExtension(const TomlTable& table) {
  table.allow({"loop", "to", "length", "scale"});
  Extension extension;
  require(table, "loop", "the boundary that moves, e.g. 'hem'");
  extension.loop = table.text("loop", "");
  if (table.has("to") == table.has("length")) table.refuse("length", "either to, a point, or length, m");
  if (table.has("to")) extension.to = readPoint(table, "to", "");
  extension.length = table.number("length", 0.0, {0.0, 5.0, true, "m"});
  extension.scale = table.number("scale", 1.0, {0.1, 20.0, false, ""});
  return extension;
}

SeamRequest readSeam(const TomlTable& table, std::set<std::string>& names) {
  table.allow({"name", "from", "to", "points", "plane"});
  SeamRequest seam;
  require(table, "name", "a name for this seam, e.g. 'left side'");
  seam.name = table.text("name", "");
  if (!names.insert(seam.name).second) table.refuse("name", "a name that no other seam has");
  seam.from = table.text("from", "");
  seam.to = table.text("to", "");
  seam.points = readPoints(table, "points");
  if (const auto plane = table.table("plane")) seam.plane = readPlane(*plane);
  for (const char* key : {"from", "to", "points"})
    if (seam.plane && table.has(key)) table.refuse(key, "either this or plane, not both");
  if (table.has("to") && !table.has("from")) table.refuse("to", "from as well, where the seam begins");
  if (table.has("from") && !table.has("to") && seam.points.empty())
    table.refuse("from", "to as well, where the seam ends, or points, at the last of which a dart ends");
  if (!seam.plane && seam.from.empty() && seam.points.empty())
    table.refuse("from", "loops, from and to, or points of a closed seam, or a plane");
  return seam;
}

std::vector<SeamRequest> readSeams(const TomlTable& table) {
  std::set<std::string> names;
  std::vector<SeamRequest> seams;
  for (const TomlTable& seam : table.tables("seam")) seams.push_back(readSeam(seam, names));
  return seams;
}

/// Reads what makes the garment; returns false for a draft's boundaries without a region.
bool readMaking(const TomlTable& table, bool may_be_draft, GarmentTools& tools) {
  std::set<std::string> names;
  for (const TomlTable& boundary : table.tables("boundary")) tools.boundaries.push_back(readBoundary(boundary, names));
  const auto region = table.table("region");
  if (!region && !may_be_draft)
    table.refuse("region", "a table [garment.region] with a seed, since there are boundaries");
  if (region) {
    region->allow({"seed"});
    tools.seed = readPoint(*region, "seed", "a point of the body that the boundaries enclose, [x, y, z], m");
  }
  if (table.has("resolution") && table.has("edge_length"))
    table.refuse("edge_length", "either resolution or edge_length, not both");
  tools.resolution = table.integer("resolution", tools.resolution, 100, 200000);
  tools.edge_length = table.number("edge_length", tools.edge_length, {0.001, 0.2, false, "m"});
  for (const TomlTable& extension : table.tables("extension")) tools.extensions.push_back(readExtension(extension));
  tools.seams = readSeams(table);
  tools.smoothing = table.number("smoothing", tools.smoothing, {0.001, 0.1, false, "m"});
  return region.has_value();
}

void readComfort(const TomlTable& table, GarmentScene& garment) {
  constexpr Range offsets{0.0, 0.1, false, "m"};
  table.allow({"offset", "region"});
  if (table.has("offset")) garment.comfort_offset = table.number("offset", 0.0, offsets);
  for (const TomlTable& region : table.tables("region")) {
    region.allow({"at", "points", "radius", "offset"});
    Brush brush = readBall(region);
    require(region, "offset", "the least distance from the body there, m");
    brush.value = region.number("offset", 0.0, offsets);
    garment.comfort_regions.push_back(brush);
  }
}

Brush readPaint(const TomlTable& table) {
  table.allow({"at", "points", "radius", "scale"});
  Brush brush = readBall(table);
  require(table, "scale", "how many times as long the cloth is to be there: above 1 more cloth, below 1 less");
  brush.value = table.number("scale", 1.0, {0.2, 5.0, false, ""});
  return brush;
}

}  // namespace

Vec3 readVec3(const TomlTable& table, std::string_view key, const Vec3& fallback, double most, const char* unit) {
  const Range range{-most, most, false, unit};
  const std::vector<double> values = table.numbers(key, range);
  if (values.empty()) return fallback;
  if (values.size() != 3) table.refuse(key, fmt::format("3 numbers, x, y and z, found {}", values.size()));
  return {values[0], values[1], values[2]};
}

Brush readBall(const TomlTable& table) {
  Brush brush;
  if (table.has("points")) {
    if (table.has("at")) table.refuse("points", "either at, a ball, or points, a stroke, not both");
    brush.stroke = readPoints(table, "points");
    brush.at = brush.stroke.front();
  } else {
    brush.at = readPoint(table, "at", "the middle of a ball, [x, y, z], m");
  }
  require(table, "radius", "the radius of a ball, m");
  brush.radius = table.number("radius", 0.0, {0.0, kFarthest, true, "m"});
  brush.value = 0.0;
  return brush;
}

void readGarmentTools(const TomlTable& table, bool has_body, bool may_be_draft, GarmentScene& garment) {
  const bool has_loops = !table.tables("boundary").empty();
  for (const char* key : {"region", "resolution", "edge_length", "smoothing", "extension"})
    if (!has_loops && !may_be_draft && table.has(key))
      table.refuse(key, fmt::format("[[garment.boundary]] loops for '{}'", key));
  for (const char* key : {"boundary", "comfort"})
    if (!has_body && table.has(key)) table.refuse(key, "a [body] in this scene, which it needs");
  for (const char* key : {"mesh", "builtin"})
    if (has_loops && table.has(key)) table.refuse(key, "either this or [[garment.boundary]] loops, not both");
  if (has_loops)
    garment.is_draft = !readMaking(table, may_be_draft, garment.tools.emplace());
  else
    garment.seams = readSeams(table);
  if (const auto comfort = table.table("comfort")) readComfort(*comfort, garment);
  for (const TomlTable& paint : table.tables("paint")) garment.paint.push_back(readPaint(paint));
}

}  // namespace ease
