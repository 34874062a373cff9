#include "apps/pattern_json.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "solver/base/whole_file.h"

namespace ease {

namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(LineKind kind) {
  return kind == LineKind::seam ? "seam" : kind == LineKind::opened ? "opening" : "dart";
}

/// What a seam is; a seam of the scene that ends within a piece is a dart.
const char* kindOf(const FlatPattern& flat, const SeamSides& sides) {
  return isDartLeg(flat.cut, sides.left) ? "dart" : nameOf(flat.lines[sides.line].kind);
}

Json poseJson(const ResewnPose& pose) {
  return {{"pose", pose.pose}, {"rms_mm", 1e3 * pose.rms_m}, {"max_mm", 1e3 * pose.max_m}};
}

Json resewnJson(const Resewn& resewn) {
  Json json;
  const bool has_own = !resewn.own.pose.empty();
  const ResewnPose& first = has_own ? resewn.own : resewn.poses.front();
  json["rms_mm"] = 1e3 * first.rms_m;
  json["max_mm"] = 1e3 * first.max_m;
  json["poses"] = Json::array();
  for (const ResewnPose& pose : resewn.poses) json["poses"].push_back(poseJson(pose));
  json["seams"] = Json::array();
  for (const ResewnSeam& seam : resewn.seams)
    json["seams"].push_back({{"name", seam.name}, {"rms_mm", 1e3 * seam.rms_m}});
  json["share_over_limit"] = resewn.has_limit ? Json(resewn.over_limit) : Json();
  json["share_over_limit_as_designed"] = resewn.has_limit ? Json(resewn.designed_over_limit) : Json();
  json["let_out_rounds"] = resewn.rounds;
  json["let_out_area_ratio"] = resewn.area_ratio;
  json["wall_s"] = resewn.wall_s;
  return json;
}

Json cutsJson(const FoundCuts& cuts) {
  return {{"steps", cuts.energies.size() - 1},
          {"energy_at_start", cuts.energies.front()},
          {"energy", cuts.energies.back()},
          {"pieces_before_removal", cuts.pieces_before},
          {"length_before_removal_m", cuts.length_before},
          {"length_m", cuts.length},
          {"length_weight", cuts.length_weight},
          {"wall_s", cuts.wall_s}};
}

Json figuresOf(const Scene& scene, const MadePattern& made) {
  const FlatPattern& flat = made.flat;
  Json json;
  json["pieces"] = Json::array();
  double cloth = 0.0, seams = 0.0;
  std::map<std::string, double> by_kind = {{"seam", 0.0}, {"opening", 0.0}, {"dart", 0.0}};
  int darts = 0, flipped = 0;
  for (const FlatPiece& piece : flat.pieces) {
    json["pieces"].push_back({{"name", piece.name},
                              {"area_m2", piece.strain.area},
                              {"thread_mean", piece.strain.thread_mean},
                              {"thread_p98", piece.strain.thread_p98},
                              {"thread_over_limit_share", piece.strain.thread_over_share},
                              {"shear_p99_deg", piece.strain.shear_p99 * 180.0 / M_PI},
                              {"within_limits", keeps(piece.strain, scene.pattern.limits)},
                              {"flipped", piece.strain.flipped},
                              {"crosses_itself", piece.crosses_itself},
                              {"grain_deg", piece.grain * 180.0 / M_PI},
                              {"darts", piece.darts}});
    darts += piece.darts;
    flipped += piece.strain.flipped;
  }
  json["seams"] = Json::array();
  for (const SeamSides& sides : flat.seams) {
    const double difference = std::abs(sides.left_length - sides.right_length);
    json["seams"].push_back({{"name", flat.lines[sides.line].seam.name},
                             {"kind", kindOf(flat, sides)},
                             {"left_piece", flat.pieces[flat.cut.edges[sides.left].piece].name},
                             {"right_piece", flat.pieces[flat.cut.edges[sides.right].piece].name},
                             {"left_edge", sides.left},
                             {"right_edge", sides.right},
                             {"rest_m", sides.rest_length},
                             {"left_m", sides.left_length},
                             {"right_m", sides.right_length},
                             {"difference_mm", 1e3 * difference},
                             {"difference_mean_percent", 100.0 * difference / sides.rest_length}});
    seams += sides.rest_length;
    by_kind[kindOf(flat, sides)] += sides.rest_length;
  }
  for (const DrawnPiece& piece : made.pieces) cloth += 1e-6 * piece.quantity * areaWithin(piece.cut);
  json["length_of_seams_m"] = seams;  // all that is sewn, once
  json["length_by_kind_m"] = by_kind;
  json["cloth_m2"] = cloth;
  json["fabric_width_m"] = scene.pattern.fabric_width;
  json["fabric_length_m"] = 1e-3 * made.cloth_length_mm;
  json["use_of_fabric"] = cloth / (1e-3 * made.cloth_length_mm * scene.pattern.fabric_width);
  json["darts"] = darts;
  json["flipped"] = flipped;
  json["pieces_mended"] = flat.mended;
  if (made.resewn) json["resewn"] = resewnJson(*made.resewn);
  if (made.cuts) json["cuts"] = cutsJson(*made.cuts);
  json["warnings"] = warningsOf(made);
  json["wall_s"] = made.wall_s;
  return json;
}

/// Vertices of the garment that were not there before, as means of those that were.
Json verticesJson(const CutUp& cut) {
  Json json = Json::array();
  for (size_t v = 0; v < cut.vertices.size(); ++v)
    if (const CutVertex& at = cut.vertices[v]; at.share[0] != 1.0)
      json.push_back({{"garment_vertex", v}, {"of", at.from}, {"share", {at.share[0], at.share[1], at.share[2]}}});
  return json;
}

Json pointsJson(const std::vector<PaperPoint>& points) {
  Json json = Json::array();
  for (const PaperPoint& p : points) json.push_back({std::round(1e3 * p.x()) / 1e3, std::round(1e3 * p.y()) / 1e3});
  return json;
}

}  // namespace

std::string patternJson(const Scene& scene, const MadePattern& made) {
  const FlatPattern& flat = made.flat;
  Json json = {{"scene", scene.name}, {"version", EASE_VERSION}, {"units", "mm"}, {"grain", "along y"}};
  json.update(figuresOf(scene, made));
  if (made.cuts) json["cut_vertices"] = verticesJson(made.cuts->cut);
  json["slid_vertices"] = verticesJson(flat.slid);
  json["outlines"] = Json::array();
  for (const DrawnPiece& piece : made.sheet.pieces) {
    Json edges = Json::array();
    for (const int e : flat.cut.outlines[piece.source]) {
      const PieceEdge& edge = flat.cut.edges[e];
      Json garment_vertices = Json::array();
      Json points = Json::array();
      for (const int v : edge.vertices) {
        garment_vertices.push_back(made.file_vertex[v]);
        const PaperPoint p = piece.axes * flat.x.row(v).head<2>().transpose() + piece.origin;
        points.push_back({std::round(1e3 * p.x()) / 1e3, std::round(1e3 * p.y()) / 1e3});
      }
      edges.push_back({{"edge", e},
                       {"name", edge.name},
                       {"sewn_to", edge.partner >= 0 ? Json(edge.partner) : Json()},
                       {"garment_vertex", garment_vertices},
                       {"points", points}});
      if (const auto twin = piece.mirror_edges.find(e); twin != piece.mirror_edges.end() && twin->second >= 0) {
        const int sewn_to = flat.cut.edges[twin->second].partner;
        edges.back()["mirror_edge"] = {{"edge", twin->second},
                                       {"name", flat.cut.edges[twin->second].name},
                                       {"sewn_to", sewn_to >= 0 ? Json(sewn_to) : Json()}};
      }
    }
    Json notches = Json::array();
    for (const Notch& notch : piece.notches) notches.push_back({notch.at.x(), notch.at.y()});
    Json numbers = Json::array({piece.source});
    if (piece.mirror_image >= 0) numbers.push_back(piece.mirror_image);
    const auto grain = std::find_if(piece.lines.begin(), piece.lines.end(),
                                    [](const DrawnLine& line) { return line.ink == Ink::grain; });
    json["outlines"].push_back({{"name", piece.name},
                                {"piece", numbers},
                                {"quantity", piece.quantity},
                                {"mirrored", piece.mirrored},
                                {"cut", pointsJson(piece.cut)},
                                {"sew", pointsJson(piece.sew)},
                                {"notches", notches},
                                {"grain", grain == piece.lines.end() ? Json::array() : pointsJson(grain->points)},
                                {"name_at", pointsJson({piece.texts.front().at}).front()},
                                {"edges", edges}});
  }
  return json.dump() + "\n";
}

void addToReport(const Scene& scene, const MadePattern& made, const std::filesystem::path& report) {
  Json json = Json::object();
  if (std::ifstream in(report); in) json = Json::parse(in, nullptr, false);
  if (!json.is_object()) json = {{"scene", scene.name}};
  json["pattern"] = figuresOf(scene, made);
  writeWholeFile(report, json.dump(2) + "\n");
}

}  // namespace ease
