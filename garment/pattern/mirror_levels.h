// Levels made symmetric: the wearer's right side (x below the plane) takes those of the left one.
#pragma once

#include "garment/pattern/region_levels.h"

namespace ease {

class MirrorLevels {
 public:
  /// Mirrors in the plane x = `plane`, m.  Vertices whose image is further than `reach` from the surface, m, stay as
  /// they are, as where a garment has one sleeve only.
  MirrorLevels(const RestSurface& surface, double plane, double reach);

  /// Replaces the levels of the right side by those at the mirrored places on the left.
  void operator()(RegionLevels& levels) const;

  /// The derivative of an energy of mirrored levels, by the left ones, from that by all levels, both ordered as phi.
  void gather(int labels, std::vector<double>& derivative) const;

 private:
  /// `vertex` gets sum_k share_k phi(from_k): the levels at its mirror image, interpolated in the triangle `from`.
  /// Corners that are replaced themselves have the share 0.
  struct Image {
    int vertex;
    std::array<int, 3> from;
    Vec3 share;
  };

  std::vector<Image> images_;
};

/// The plane x = ... that halves the area of a surface, m.
double middlePlane(const RestSurface& surface);

}  // namespace ease
