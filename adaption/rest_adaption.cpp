#include "adaption/rest_adaption.h"

namespace ease {

RestAdaption::RestAdaption(Cloth& cloth, double limit, std::span<const int> ordering)
    : cloth_(cloth), clip_(limit), stitcher_(cloth, ordering) {}

bool RestAdaption::adapt(const std::vector<Stretch>& stretch) {
  if (!clip_.clip(cloth_, stretch, growth_)) return false;
  stitcher_.stitch(cloth_, growth_);
  return true;
}

}  // namespace ease
