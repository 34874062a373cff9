#include "apps/studio/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "solver/base/error.h"

namespace ease {

namespace {

std::string placeText(const Brush& brush) {
  return fmt::format("at {:.2f}, {:.2f}, {:.2f}", brush.at.x(), brush.at.y(), brush.at.z());
}

std::string labelOf(const PinScene& pin) {
  if (const auto* loop = std::get_if<std::string>(&pin.what)) return *loop;
  if (const auto* ball = std::get_if<Brush>(&pin.what)) return placeText(*ball);
  return fmt::format("{} vertices", std::get<std::vector<int>>(pin.what).size());
}

std::string labelOf(const Extension& extension) {
  if (extension.to) return extension.loop + " to a point";
  return fmt::format("{} + {:.2f} m, {:.2f} wide", extension.loop, extension.length, extension.scale);
}

std::vector<KeyValue> brushValues(const std::vector<Vec3>& stroke, double radius) {
  if (stroke.size() == 1) return {{"at", tomlPoint(stroke.front())}, {"radius", tomlNumber(radius)}};
  return {{"points", tomlPoints(stroke)}, {"radius", tomlNumber(radius)}};
}

std::string withEntry(const std::string& text, PartKind kind, const std::vector<KeyValue>& values) {
  SceneText edited(text);
  edited.addEntry(pathOf(kind), values);
  return edited.text();
}

std::string withStroke(const std::string& text, PartKind kind, const std::vector<Vec3>& stroke, double radius,
                       const KeyValue& value) {
  std::vector<KeyValue> values = brushValues(stroke, radius);
  values.push_back(value);
  return withEntry(text, kind, values);
}

}  // namespace

const char* pathOf(PartKind kind) {
  constexpr const char* kPaths[] = {"garment.boundary",       "garment.region", "garment.extension", "garment.paint",
                                    "garment.comfort.region", "garment.pin",    "garment.seam"};
  return kPaths[static_cast<int>(kind)];
}

const char* pluralOf(PartKind kind) {
  constexpr const char* kPlurals[] = {"Boundaries", "Region", "Extensions", "Paint", "Comfort", "Pins", "Seams"};
  return kPlurals[static_cast<int>(kind)];
}

std::vector<Part> partsOf(const Scene& scene) {
  const GarmentScene& garment = scene.garment;
  std::vector<Part> parts;
  const auto add = [&](PartKind kind, const auto& entries, const auto& label) {
    for (size_t k = 0; k < entries.size(); ++k) parts.push_back({kind, static_cast<int>(k), label(entries[k])});
  };
  const GarmentTools tools = garment.tools.value_or(GarmentTools());
  add(PartKind::boundary, tools.boundaries, [](const LoopRequest& loop) { return loop.name; });
  if (!garment.is_draft && garment.tools) parts.push_back({PartKind::region, 0, "cloth"});
  add(PartKind::extension, tools.extensions, [](const Extension& extension) { return labelOf(extension); });
  add(PartKind::paint, garment.paint,
      [](const Brush& brush) { return fmt::format("{:.2f} times, {}", brush.value, placeText(brush)); });
  add(PartKind::comfort, garment.comfort_regions,
      [](const Brush& brush) { return fmt::format("{:.0f} mm, {}", 1000 * brush.value, placeText(brush)); });
  add(PartKind::pin, garment.pins, [](const PinScene& pin) { return labelOf(pin); });
  add(PartKind::seam, tools.seams, [](const SeamRequest& seam) { return seam.name; });
  return parts;
}

std::string userOf(const Scene& scene, const Part& part) {
  if (!scene.garment.tools || (part.kind != PartKind::boundary && part.kind != PartKind::seam)) return "";
  const GarmentTools& tools = *scene.garment.tools;
  const bool is_loop = part.kind == PartKind::boundary;
  for (const Extension& extension : tools.extensions)
    if (is_loop && extension.loop == part.label) return "extension '" + labelOf(extension) + "'";
  for (const SeamRequest& seam : tools.seams)
    if (seam.name != part.label && (seam.from == part.label || seam.to == part.label))
      return "seam '" + seam.name + "'";
  for (const PinScene& pin : scene.garment.pins)
    if (const auto* loop = std::get_if<std::string>(&pin.what); is_loop && loop && *loop == part.label)
      return "pin '" + labelOf(pin) + "'";
  return "";
}

int mirrorImageOf(const Scene& scene, int boundary) {
  constexpr double kSamePoint = 1e-3;  // m
  if (!scene.garment.tools) return -1;
  const std::vector<LoopRequest>& loops = scene.garment.tools->boundaries;
  const auto isImage = [](const Vec3& a, const Vec3& b) {
    return (Vec3(-a.x(), a.y(), a.z()) - b).norm() < kSamePoint;
  };
  for (size_t other = 0; other < loops.size(); ++other) {
    const std::vector<Vec3>&points = loops[boundary].points, &images = loops[other].points;
    if (static_cast<int>(other) != boundary && !points.empty() && points.size() == images.size() &&
        std::equal(points.begin(), points.end(), images.begin(), isImage))
      return static_cast<int>(other);
  }
  return -1;
}

std::string freeName(const Scene& scene, PartKind kind) {
  std::set<std::string> taken;
  for (const Part& part : partsOf(scene))
    if (part.kind == kind) taken.insert(part.label);
  for (int k = 1;; ++k) {
    const std::string name = fmt::format("{} {}", kind == PartKind::seam ? "seam" : "loop", k);
    if (!taken.count(name)) return name;
  }
}

std::string withBoundary(const std::string& text, const std::string& name, const std::vector<Vec3>& points) {
  return withEntry(text, PartKind::boundary, {{"name", tomlText(name)}, {"points", tomlPoints(points)}});
}

std::string withBoundaryPoints(const std::string& text, int number, const std::vector<Vec3>& points) {
  SceneText edited(text);
  edited.setValue(pathOf(PartKind::boundary), number, "points", tomlPoints(points));
  return edited.text();
}

std::string withRegion(const std::string& text, const Vec3& seed) {
  SceneText edited(text);
  edited.setValue(pathOf(PartKind::region), 0, "seed", tomlPoint(seed));
  return edited.text();
}

std::string withExtension(const std::string& text, int number, const std::string& loop, double length, double scale) {
  const std::string path = pathOf(PartKind::extension);
  if (number < 0)
    return withEntry(text, PartKind::extension,
                     {{"loop", tomlText(loop)}, {"length", tomlNumber(length)}, {"scale", tomlNumber(scale)}});
  SceneText edited(text);
  edited.removeValue(path, number, "to");
  edited.setValue(path, number, "length", tomlNumber(length));
  edited.setValue(path, number, "scale", tomlNumber(scale));
  return edited.text();
}

std::string withPaint(const std::string& text, const std::vector<Vec3>& stroke, double radius, double scale) {
  return withStroke(text, PartKind::paint, stroke, radius, {"scale", tomlNumber(scale)});
}

std::string withComfort(const std::string& text, const std::vector<Vec3>& stroke, double radius, double offset) {
  return withStroke(text, PartKind::comfort, stroke, radius, {"offset", tomlNumber(offset)});
}

std::string withPinnedLoop(const std::string& text, const std::string& loop) {
  return withEntry(text, PartKind::pin, {{"loop", tomlText(loop)}});
}

std::string withPinnedBall(const std::string& text, const Vec3& at, double radius) {
  return withEntry(text, PartKind::pin, brushValues({at}, radius));
}

std::string withSeam(const std::string& text, const std::string& name, const std::string& from, const std::string& to,
                     const std::vector<Vec3>& points) {
  std::vector<KeyValue> values = {{"name", tomlText(name)}};
  if (!from.empty()) values.insert(values.end(), {{"from", tomlText(from)}, {"to", tomlText(to)}});
  if (!points.empty()) values.emplace_back("points", tomlPoints(points));
  return withEntry(text, PartKind::seam, values);
}

std::string without(const std::string& text, const Part& part) {
  SceneText edited(text);
  edited.removeEntry(pathOf(part.kind), part.number);
  return edited.text();
}

std::string renamed(const std::string& text, const Scene& scene, const Part& part, const std::string& name) {
  if (part.kind != PartKind::boundary && part.kind != PartKind::seam)
    throw InputError("only boundaries and seams have names");
  SceneText edited(text);
  edited.setValue(pathOf(part.kind), part.number, "name", tomlText(name));
  if (part.kind == PartKind::seam) return edited.text();
  const GarmentTools& tools = *scene.garment.tools;
  const auto rename = [&](PartKind kind, size_t k, const char* key, const std::string& loop) {
    if (loop == part.label) edited.setValue(pathOf(kind), static_cast<int>(k), key, tomlText(name));
  };
  for (size_t k = 0; k < tools.extensions.size(); ++k) rename(PartKind::extension, k, "loop", tools.extensions[k].loop);
  for (size_t k = 0; k < scene.garment.pins.size(); ++k)
    if (const auto* loop = std::get_if<std::string>(&scene.garment.pins[k].what))
      rename(PartKind::pin, k, "loop", *loop);
  for (size_t k = 0; k < tools.seams.size(); ++k) {
    rename(PartKind::seam, k, "from", tools.seams[k].from);
    rename(PartKind::seam, k, "to", tools.seams[k].to);
  }
  return edited.text();
}

std::string meshKey(const std::string& text) {
  SceneText kept(text);
  for (const PartKind kind : {PartKind::paint, PartKind::pin}) kept.removeSections(pathOf(kind));
  const std::string comfort = kept.sectionsBelow("garment.comfort") + kept.value("collision", 0, "offset");
  return kept.sectionsBelow("body") + kept.sectionsBelow("garment") + comfort;
}

}  // namespace ease
