#include "apps/run_pictures.h"

#include "adaption/stretch_measure.h"
#include "viz/picture.h"

namespace ease {

ShownGarment showGarment(const Cloth& cloth, const Positions& x) {
  std::vector<Stretch> stretch;
  measureStretch(cloth, x, stretch);
  ShownGarment shown{{x, cloth.triangles()}, {}};
  for (const Stretch& s : stretch) shown.sigma_1.push_back(static_cast<float>(s.sigma_1));
  return shown;
}

std::string drawGarments(const std::filesystem::path& file, const std::vector<ShownColumn>& columns,
                         const TriangleMesh& body, double limit) {
  std::vector<StretchView> views;
  for (const ShownColumn& column : columns)
    views.push_back(
        {column.title, &column.garment->mesh, column.garment->sigma_1, body.triangles.rows() > 0 ? &body : nullptr});
  return drawStretch(file, views, "largest principal stretch", 1.0, 1.0 + 2.0 * limit, 1.0 + limit);
}

}  // namespace ease
