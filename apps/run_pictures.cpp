#include "apps/run_pictures.h"

#include <fmt/format.h>

#include <limits>

#include "viz/picture.h"

namespace ease {

double shownLimit(const Scene& scene) {
  return scene.adaption ? scene.adaption->limit : 0.1;
}

ShownGarment showGarment(const Cloth& cloth, const Positions& x) {
  ShownGarment shown{{x, cloth.triangles()}, {}};
  measureStretch(cloth, x, shown.stretch);
  return shown;
}

std::string drawGarments(const std::filesystem::path& file, const std::vector<ShownColumn>& columns,
                         const TriangleMesh& body, double limit, const std::vector<std::string>& doubts) {
  const std::string doubt = doubts.empty() ? "" : doubts.front().substr(0, doubts.front().find(", "));
  std::vector<StretchView> views;
  // Pictures are drawn in single precision: around the origin, wherever the garment is.
  const Eigen::RowVector3d origin = columns.front().garment->mesh.positions.row(0).array().round();
  const auto moved = [&](const TriangleMesh& mesh) {
    return TriangleMesh{mesh.positions.rowwise() - origin, mesh.triangles};
  };
  const TriangleMesh moved_body = moved(body);
  std::vector<TriangleMesh> meshes;
  for (const ShownColumn& column : columns) meshes.push_back(moved(column.garment->mesh));
  for (size_t c = 0; c < columns.size(); ++c) {
    const ShownColumn& column = columns[c];
    const std::vector<Stretch>& stretch = column.garment->stretch;
    const StretchStatistics statistics = momentStatistics(stretch, limit);
    StretchView view{column.title, &meshes[c], {}, body.triangles.rows() > 0 ? &moved_body : nullptr};
    for (const Stretch& s : stretch)
      view.values.push_back(isCrumpled(s, limit) ? std::numeric_limits<float>::quiet_NaN()
                                                 : static_cast<float>(s.sigma_1));
    view.summary = fmt::format("largest {:.2f}, {:.2f} % of triangles over the limit", statistics.max,
                               100.0 * statistics.share_over_limit);
    if (statistics.taut_share_over_limit < statistics.share_over_limit)
      view.summary += fmt::format(", {:.2f} % taut (crumpled: grey)", 100.0 * statistics.taut_share_over_limit);
    if (!doubt.empty()) view.summary = doubt;
    views.push_back(view);
  }
  return drawStretch(file, views, "largest principal stretch", 1.0, 1.0 + 2.0 * limit, 1.0 + limit);
}

std::vector<std::string> drawReplays(const std::filesystem::path& directory, const ShownReplay& before,
                                     const ShownReplay& after, const TriangleMesh& last_body,
                                     const TriangleMesh& first_body, double limit,
                                     const std::vector<std::string>& doubts) {
  std::vector<std::string> reasons = {
      drawGarments(directory / "stretch.png", {{"before, last pose", &before.end}, {"after, last pose", &after.end}},
                   last_body, limit, doubts),
      drawGarments(directory / "stretch_first_pose.png",
                   {{"before, first pose", &before.start}, {"after, first pose", &after.start}}, first_body, limit,
                   doubts)};
  std::erase(reasons, "");
  return reasons;
}

}  // namespace ease
