#include "apps/garment_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/output_arrays.h"
#include "solver/base/whole_file.h"
#include "solver/io/mesh_io.h"
#include "viz/picture.h"
#include "viz/vtp.h"

namespace ease {

namespace {

using Json = nlohmann::ordered_json;

/// Makes a frame of the made garment with the arrays that show what the tools did.
Frame madeGarmentFrame(const SceneInput& input) {
  Frame frame{input.garment.positions, {}, {}};
  for (const OutputArray<SceneInput>& array : madeGarmentArrays()) addArray(array, input, frame);
  return frame;
}

Json qualityJson(const MeshQuality& quality) {
  return {{"vertices", quality.vertices},
          {"triangles", quality.triangles},
          {"smallest_angle_deg", quality.smallest_angle_deg},
          {"largest_angle_deg", quality.largest_angle_deg},
          {"share_of_triangles_from_20_deg", quality.share_from_20_deg},
          {"shortest_edge_m", quality.shortest_edge_m},
          {"mean_edge_m", quality.mean_edge_m},
          {"longest_edge_m", quality.longest_edge_m},
          {"self_intersections", quality.self_intersections},
          {"least_distance_to_body_m",
           {{"vertices", quality.vertex_distance_m},
            {"edge_midpoints", quality.midpoint_distance_m},
            {"centroids", quality.centroid_distance_m}}},
          {"samples_nearer_than_comfort", quality.too_near}};
}

Json garmentJson(const Scene& scene, const SceneInput& input, const MeshQuality& quality) {
  const AuthoredGarment& authored = *input.authored;
  Json loops = Json::array();
  for (const NamedLoop& loop : authored.garment.loops)
    loops.push_back({{"name", loop.name}, {"vertices", loop.vertices}});
  Json seams = Json::array();
  for (const Seam& seam : authored.seams)
    seams.push_back({{"name", seam.name}, {"closed", seam.is_closed}, {"vertices", seam.vertices}});
  const AuthoredGarment::Times& times = authored.times;
  return {{"scene", scene.name},
          {"body", input.pose_names.front()},
          {"quality", qualityJson(quality)},
          {"vertices_in_folds", authored.held_vertices},
          {"times_s",
           {{"loops", times.loops_s},
            {"region", times.region_s},
            {"extension", times.extension_s},
            {"remeshing", times.remeshing_s},
            {"seams", times.seams_s},
            {"comfort", times.comfort_s}}},
          {"loops", loops},
          {"seams", seams}};
}

/// Formats the comfort offsets as "5.00 mm", or as "5.00 to 30.00 mm" if they differ between regions.
std::string wantedText(const std::vector<double>& offsets) {
  const auto [least, most] = std::minmax_element(offsets.begin(), offsets.end());
  return *least < *most ? fmt::format("{:.2f} to {:.2f} mm", 1e3 * *least, 1e3 * *most)
                        : fmt::format("{:.2f} mm", 1e3 * *least);
}

std::string summaryOf(const AuthoredGarment& authored) {
  const AuthoredGarment::Times& times = authored.times;
  const MeshQuality& quality = authored.quality;
  return fmt::format(
      "garment   {} vertices, {} triangles, edges {:.1f} mm\n"
      "quality   smallest angle {:.1f} deg, {:.2f} % of triangles 20 deg or more, {} self-intersections\n"
      "distance  {:.2f} mm at least to the body, {} asked for; {} vertices in folds with less room than that\n"
      "times     {:.2f} s: loops {:.2f}, region {:.2f}, extension {:.2f}, remeshing {:.2f}, seams {:.2f}, comfort "
      "{:.2f}\n",
      quality.vertices, quality.triangles, 1e3 * quality.mean_edge_m, quality.smallest_angle_deg,
      100.0 * quality.share_from_20_deg, quality.self_intersections, 1e3 * quality.nearest(),
      wantedText(authored.offsets), authored.held_vertices, times.total(), times.loops_s, times.region_s,
      times.extension_s, times.remeshing_s, times.seams_s, times.comfort_s);
}

/// Draws the garment with its loops, coloured by its paint or, if it has none, by comfort.
std::string drawGarment(const SceneInput& input, const MeshQuality& quality, const std::filesystem::path& directory) {
  const TriangleMesh body{input.poses.front(), input.body_triangles};
  StretchView view{"", &input.garment, {}, &body};
  std::string label = "cloth painted, times as long";
  double low = 0.7, high = 1.3;
  if (!input.paint.empty()) {
    view.values.assign(input.paint.begin(), input.paint.end());
  } else {
    label = "comfort offset, mm";
    low = 0.0;
    high = 2e3 * *std::max_element(input.offsets.begin(), input.offsets.end()) + 1.0;
    for (const auto& t : input.garment.triangles.rowwise())
      view.values.push_back(
          static_cast<float>(1e3 * (input.offsets[t[0]] + input.offsets[t[1]] + input.offsets[t[2]]) / 3));
  }
  view.title = fmt::format("{} vertices on {}", quality.vertices, input.pose_names.front());
  view.summary = fmt::format("smallest angle {:.0f} degrees", quality.smallest_angle_deg);
  for (const NamedLoop& loop : input.authored->garment.loops)
    view.lines.push_back({positionsOf(loop.vertices, input.garment.positions), true, {20, 40, 120}});
  for (const Seam& seam : input.authored->seams)
    view.lines.push_back({positionsOf(seam.vertices, input.garment.positions), seam.is_closed, {190, 60, 20}});
  return drawStretch(directory / "garment.png", {view}, label, low, high, high);
}

}  // namespace

std::string writeGarment(const Scene& scene, const SceneInput& input, const std::filesystem::path& directory,
                         const std::atomic<bool>& interrupted) {
  const TriangleMesh body{input.poses.front(), input.body_triangles};
  const MeshQuality& quality = input.authored->quality;
  writeWholeFile(directory / "garment.json", garmentJson(scene, input, quality).dump(1) + "\n");
  writeObj(directory / "garment.obj", input.garment);
  writeObj(directory / "body.obj", body);
  writeVtp(directory / "garment.vtp", input.garment.triangles, madeGarmentFrame(input));
  std::string text = summaryOf(*input.authored);
  if (interrupted) return text;
  const std::string reason = drawGarment(input, quality, directory);
  if (!reason.empty()) text += "no picture: " + reason + "\n";
  return text;
}

std::string writePieces(const TriangleMesh& garment, const std::vector<Seam>& seams,
                        const std::filesystem::path& directory, const std::string& name,
                        const std::vector<int>& file_vertex) {
  Pieces pieces = cutIntoPieces(garment, seams);
  for (int& vertex : pieces.glue)
    if (!file_vertex.empty()) vertex = file_vertex[vertex];
  Frame frame{pieces.mesh.positions, {}, {}};
  for (const OutputArray<Pieces>& array : pieceArrays()) addArray(array, pieces, frame);
  writeObj(directory / (name + ".obj"), pieces.mesh);
  writeVtp(directory / (name + ".vtp"), pieces.mesh.triangles, frame);
  const Json json = {{"pieces", pieces.count}, {"garment_vertex", pieces.glue}, {"piece_of_triangle", pieces.piece}};
  writeWholeFile(directory / (name + ".json"), json.dump() + "\n");
  return fmt::format("pieces    {}, with {} vertices more than the garment\n", pieces.count,
                     pieces.mesh.positions.rows() - garment.positions.rows());
}

}  // namespace ease
