#include "garment/pattern/normal_clusters.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ease {
namespace {

std::vector<Vec3> vertexNormals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.rows(), Vec3::Zero());
  for (const auto& t : mesh.triangles.rowwise()) {
    const Vec3 n = doubleAreaNormal(mesh.positions.row(t[0]), mesh.positions.row(t[1]), mesh.positions.row(t[2]));
    for (int k = 0; k < 3; ++k) normals[t[k]] += n;
  }
  for (Vec3& n : normals) n.stableNormalize();
  return normals;
}

/// The label that fewest neighbours have; of several the one that fewest clusters have, so that far regions differ.
int rarestLabel(const std::vector<int>& cluster_label, const std::set<int>& neighbours, int most) {
  std::vector<std::pair<int, int>> uses(most, {0, 0});
  for (const int label : cluster_label)
    if (label >= 0) ++uses[label].second;
  for (const int c : neighbours)
    if (cluster_label[c] >= 0) ++uses[cluster_label[c]].first;
  return static_cast<int>(std::min_element(uses.begin(), uses.end()) - uses.begin());
}

}  // namespace

Clusters normalClusters(const RestSurface& surface, double angle, int most) {
  const int n = surface.vertexCount();
  const std::vector<Vec3> normals = vertexNormals(surface.mesh);
  const std::vector<std::vector<int>> neighbours = vertexNeighbours(surface.topology, n);
  std::vector<int> cluster(n, -1);
  int count = 0;
  for (int seed = 0; seed < n; ++seed) {
    if (cluster[seed] >= 0) continue;
    std::vector<int> front = {seed};
    cluster[seed] = count;
    for (size_t i = 0; i < front.size(); ++i)
      for (const int w : neighbours[front[i]]) {
        if (cluster[w] >= 0 || normals[w].dot(normals[seed]) < std::cos(angle)) continue;
        cluster[w] = count;
        front.push_back(w);
      }
    ++count;
  }
  std::vector<std::set<int>> beside(count);
  for (const Edge& edge : surface.topology.edges) {
    const int a = cluster[edge.vertex[0]], b = cluster[edge.vertex[1]];
    if (a == b) continue;
    beside[a].insert(b);
    beside[b].insert(a);
  }
  std::vector<int> label(count, -1);
  Clusters clusters;
  for (int c = 0; c < count; ++c) {
    label[c] = rarestLabel(label, beside[c], most);
    clusters.labels = std::max(clusters.labels, label[c] + 1);
  }
  for (const int c : cluster) clusters.label.push_back(label[c]);
  return clusters;
}

}  // namespace ease
