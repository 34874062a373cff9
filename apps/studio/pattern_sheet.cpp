#include "apps/studio/pattern_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "solver/base/error.h"
#include "solver/mesh/segment.h"
#include "viz/vtp_arrays.h"

namespace ease {

namespace {

using Json = nlohmann::json;

/// Numbers that the pattern's vertices have in the garment: some were cut out of its triangles, others are named by the
/// number that they have in the garment's file.
class GarmentVertices {
 public:
  GarmentVertices(const Json& pattern, const SceneInput& input) {
    if (!pattern.contains("cut_vertices")) {
      if (input.as_read) of_file_ = input.as_read->vertex;
      return;
    }
    for (const Json& vertex : pattern.at("cut_vertices")) {
      GarmentPoint point;
      for (int k = 0; k < 3; ++k)
        point.shares.emplace_back(vertex.at("of").at(k).get<int>(), vertex.at("share").at(k).get<double>());
      cut_[vertex.at("garment_vertex").get<int>()] = point;
    }
  }
  GarmentPoint at(int vertex) const {
    if (const auto found = cut_.find(vertex); found != cut_.end()) return found->second;
    return {{{of_file_.empty() ? vertex : of_file_.at(vertex), 1.0}}};
  }

 private:
  std::vector<int> of_file_;
  std::map<int, GarmentPoint> cut_;
};

PaperPoint pointOf(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>()};
}

std::vector<PaperPoint> pointsOf(const Json& json) {
  std::vector<PaperPoint> points;
  for (const Json& point : json) points.push_back(pointOf(point));
  return points;
}

SheetPiece pieceOf(const Json& outline, const GarmentVertices& vertices) {
  SheetPiece piece;
  piece.name = outline.at("name").get<std::string>();
  piece.numbers = outline.at("piece").get<std::vector<int>>();
  piece.cut = pointsOf(outline.at("cut"));
  piece.grain = pointsOf(outline.at("grain"));
  piece.name_at = pointOf(outline.at("name_at"));
  for (const Json& json : outline.at("edges")) {
    SheetEdge edge{json.at("name").get<std::string>(), !json.at("sewn_to").is_null(), pointsOf(json.at("points")), {}};
    for (const Json& vertex : json.at("garment_vertex")) edge.on_garment.push_back(vertices.at(vertex.get<int>()));
    piece.edges.push_back(std::move(edge));
  }
  return piece;
}

Json readJson(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in)
    throw InputError(
        fmt::format("{}: no such file: expected what `ease pattern` writes where [pattern] formats has "
                    "'json'",
                    file.string()));
  return Json::parse(in);
}

double distanceTo(const std::vector<PaperPoint>& line, const PaperPoint& point) {
  double nearest = INFINITY;
  for (size_t i = 0; i + 1 < line.size(); ++i)
    nearest = std::min(nearest, distanceToSegment(line[i], line[i + 1], point));
  return nearest;
}

bool isWithin(const std::vector<PaperPoint>& outline, const PaperPoint& point) {
  bool is_inside = false;
  for (size_t i = 0; i < outline.size(); ++i) {
    const PaperPoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      is_inside = !is_inside;
  }
  return is_inside;
}

Vec3 placed(const GarmentPoint& point, const Positions& cloth) {
  Vec3 at = Vec3::Zero();
  for (const auto& [vertex, share] : point.shares) at += share * cloth.row(vertex).transpose();
  return at;
}

void checkVertices(const PatternSheet& sheet, const std::filesystem::path& file) {
  const Eigen::Index count = sheet.made->input.garment.positions.rows();
  for (const SheetPiece& piece : sheet.pieces)
    for (const SheetEdge& edge : piece.edges)
      for (const GarmentPoint& point : edge.on_garment)
        for (const auto& [vertex, share] : point.shares)
          if (vertex < 0 || vertex >= count)
            throw InputError(
                fmt::format("{}: vertex {}: the garment has {}: make the pattern again", file.string(), vertex, count));
}

}  // namespace

PatternSheet readPatternSheet(const std::filesystem::path& directory, std::shared_ptr<const MadeGarment> made) {
  PatternSheet sheet;
  sheet.made = std::move(made);
  const std::filesystem::path file = directory / "pattern.json";
  try {
    const Json pattern = readJson(file);
    const GarmentVertices vertices(pattern, sheet.made->input);
    for (const Json& outline : pattern.at("outlines")) sheet.pieces.push_back(pieceOf(outline, vertices));
    for (const Json& seam : pattern.at("seams"))
      sheet.seams.emplace_back(seam.at("name").get<std::string>(), seam.at("left_m").get<double>());
  } catch (const std::exception& error) {
    if (dynamic_cast<const InputError*>(&error)) throw;
    throw InputError(fmt::format("{}: expected a pattern that this program wrote: {}", file.string(), error.what()));
  }
  checkVertices(sheet, file);
  const VtpMesh flat = readVtpArrays(directory / "pattern.vtp", {"piece", "garment_triangle"});
  const auto count = static_cast<size_t>(sheet.made->input.garment.triangles.rows());
  for (size_t t = 0; t < flat.triangle_arrays[0].values.size(); ++t) {
    const auto piece = static_cast<size_t>(flat.triangle_arrays[0].values[t]);
    const auto triangle = static_cast<size_t>(flat.triangle_arrays[1].values[t]);
    if (triangle >= count)
      throw InputError(fmt::format("{}: triangle {}: the garment has {}: make the pattern again",
                                   (directory / "pattern.vtp").string(), triangle, count));
    if (piece >= sheet.triangles.size()) sheet.triangles.resize(piece + 1);
    sheet.triangles[piece].push_back(static_cast<int>(triangle));
  }
  return sheet;
}

Bounds PatternSheet::bounds() const {
  std::vector<PaperPoint> all = {PaperPoint::Zero()};
  for (const SheetPiece& piece : pieces) all.insert(all.end(), piece.cut.begin(), piece.cut.end());
  return boundsOf(all);
}

SheetPick PatternSheet::at(const PaperPoint& point, double near) const {
  SheetPick pick;
  double nearest = near;
  for (const SheetPiece& piece : pieces)
    for (const SheetEdge& edge : piece.edges)
      if (const double distance = distanceTo(edge.points, point); distance < nearest) {
        nearest = distance;
        pick = {SheetPick::What::line, 0, edge.name, edge.is_sewn};
      }
  for (size_t p = 0; p < pieces.size() && pick.what == SheetPick::What::none; ++p)
    if (isWithin(pieces[p].cut, point)) pick = {SheetPick::What::piece, p, "", false};
  return pick;
}

bool PatternSheet::has(const std::string& line, bool is_sewn) const {
  for (const SheetPiece& piece : pieces)
    for (const SheetEdge& edge : piece.edges)
      if (edge.name == line && edge.is_sewn == is_sewn) return true;
  return false;
}

std::string PatternSheet::wordsOf(const SheetPick& pick) const {
  if (pick.what == SheetPick::What::none) return "Click a piece or a line: it lights up on the garment";
  if (pick.what == SheetPick::What::piece)
    return fmt::format("piece '{}'{}", pieces[pick.piece].name,
                       pieces[pick.piece].numbers.size() > 1 ? ", cut twice, one of them mirrored" : "");
  if (!pick.is_sewn) return fmt::format("edge '{}' of the garment", pick.line);
  double length = 0.0;
  for (const auto& [name, metres] : seams)
    if (name == pick.line) length += metres;
  return fmt::format("'{}': {:.1f} cm to sew", pick.line, 100.0 * length);
}

void addPatternMarks(const PatternSheet& sheet, const SheetPick& pick, const Stage& stage, Marks& marks) {
  if (pick.what == SheetPick::What::none || !stage.hasCloth()) return;
  const Triangles &triangles = stage.clothAsMade().triangles, &of_sheet = sheet.made->input.garment.triangles;
  if (triangles.rows() != of_sheet.rows() || triangles != of_sheet) return;
  if (pick.what == SheetPick::What::piece) {
    marks.cloth_colors.assign(triangles.rows(), LiveView::kClothColor);
    for (const int number : sheet.pieces[pick.piece].numbers)
      for (const int t : sheet.triangles.at(number)) marks.cloth_colors[t] = kHoverColor;
    return;
  }
  for (const SheetPiece& piece : sheet.pieces)
    for (const SheetEdge& edge : piece.edges) {
      if (edge.name != pick.line || edge.is_sewn != pick.is_sewn) continue;
      MarkLine line{{}, false, kHoverColor, 7.0};
      for (const GarmentPoint& point : edge.on_garment) line.points.push_back(placed(point, stage.cloth()));
      marks.lines.push_back(std::move(line));
    }
}

}  // namespace ease
