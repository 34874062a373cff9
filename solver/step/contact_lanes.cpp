#include "solver/step/contact_lanes.h"

namespace ease {

namespace {

double contactArea(const Cloth& cloth, int sample) {
  // Vertices, edges and triangles share the cloth's area evenly.
  const int n = cloth.vertexCount(), e = static_cast<int>(cloth.topology().edges.size());
  if (sample < n) return cloth.vertexAreas()[sample] / 3.0;
  if (sample >= n + e) return cloth.restAreas()[sample - n - e] / 3.0;
  double area = 0.0;
  for (int t : cloth.topology().edges[sample - n].triangle)
    if (t >= 0) area += cloth.restAreas()[t] / 9.0;
  return area;
}

}  // namespace

ContactLanes::ContactLanes() {
  for (int l = 0; l < kLanes; ++l) {
    sample[l] = -1;
    for (int a = 0; a < 3; ++a) corners[a][l] = 0;
  }
  for (int a = 0; a < 3; ++a) weights[a] = normal[a] = Lanes::Zero();
  offset = area = Lanes::Zero();
  give = Lanes::Ones();
}

void ContactLanes::set(int lane, const Cloth& cloth, int s, const ContactPlane& plane) {
  const int n = cloth.vertexCount(), e = static_cast<int>(cloth.topology().edges.size());
  int corner[3] = {s, s, s}, count = 1;
  if (s >= n + e) {
    count = 3;
    for (int a = 0; a < 3; ++a) corner[a] = cloth.triangles()(s - n - e, a);
  } else if (s >= n) {
    count = 2;
    corner[0] = corner[2] = cloth.topology().edges[s - n].vertex[0];
    corner[1] = cloth.topology().edges[s - n].vertex[1];
  }
  sample[lane] = s;
  for (int a = 0; a < 3; ++a) {
    corners[a][lane] = corner[a];
    weights[a][lane] = a < count ? 1.0 / count : 0.0;
    normal[a][lane] = plane.normal[a];
  }
  offset[lane] = plane.offset;
  give[lane] = plane.give;
  area[lane] = contactArea(cloth, s);
}

Lanes ContactLanes::depth(const Positions& x) const {
  Lanes height = Lanes::Zero();  // along the normal
  for (int a = 0; a < 3; ++a) {
    Column<Lanes> corner;
    gather(x, corners[a], corner);
    height += weights[a] * (corner.x * normal[0] + corner.y * normal[1] + corner.z * normal[2]);
  }
  return (offset - height).max(0.0);
}

}  // namespace ease
