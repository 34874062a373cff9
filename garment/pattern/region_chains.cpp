#include "garment/pattern/region_chains.h"

#include <fmt/format.h>

#include "solver/mesh/topology.h"

namespace ease {
namespace {

/// The edges between regions, by their ends.
class ChainWalk {
 public:
  ChainWalk(const TriangleMesh& mesh, const EdgeSet& edges, const EdgeSet& seams)
      : next_(mesh.positions.rows()), ends_(mesh.positions.rows(), 0) {
    for (const Edge& edge : buildTopology(mesh, "the cut garment").edges) {
      if (edge.isBoundary() || seams.contains(edge.vertex)) {
        for (const int v : edge.vertex) ends_[v] = 1;
      } else if (edges.contains(edge.vertex)) {
        for (const int side : {0, 1}) next_[edge.vertex[side]].push_back(edge.vertex[1 - side]);
      }
    }
    for (size_t v = 0; v < next_.size(); ++v)
      if (next_[v].size() != 2) ends_[v] = 1;
  }

  std::vector<std::vector<int>> chains() {
    std::vector<std::vector<int>> chains;
    for (const bool from_ends : {true, false})  // then closed ones, which pass no end
      for (size_t v = 0; v < next_.size(); ++v)
        for (const int w : next_[v])
          if ((ends_[v] || !from_ends) && !passed_.contains(edgeKey(static_cast<int>(v), w)))
            chains.push_back(follow(static_cast<int>(v), w));
    return chains;
  }

 private:
  std::vector<int> follow(int v, int w) {
    std::vector<int> chain = {v};
    for (int from = v, to = w;;) {
      chain.push_back(to);
      passed_.insert(edgeKey(from, to));
      if (ends_[to] || to == v) return chain;
      const int ahead = next_[to][0] == from ? next_[to][1] : next_[to][0];
      from = to;
      to = ahead;
    }
  }

  std::vector<std::vector<int>> next_;
  std::vector<char> ends_;
  EdgeSet passed_;
};

}  // namespace

double lengthOfSeam(const Seam& seam, const Positions& positions) {
  return polygonLength(positionsOf(seam.vertices, positions), seam.is_closed);
}

double lengthOfSeams(const std::vector<Seam>& seams, const Positions& positions) {
  double length = 0.0;
  for (const Seam& seam : seams) length += lengthOfSeam(seam, positions);
  return length;
}

void addEdges(const Seam& seam, EdgeSet& edges) {
  const size_t n = seam.vertices.size();
  for (size_t i = 0; i + (seam.is_closed ? 0 : 1) < n; ++i)
    edges.insert(edgeKey(seam.vertices[i], seam.vertices[(i + 1) % n]));
}

EdgeSet edgesBetween(const TriangleMesh& mesh, const std::vector<int>& triangle_label, const EdgeSet& seams) {
  EdgeSet edges;
  for (const Edge& edge : buildTopology(mesh, "the cut garment").edges)
    if (!edge.isBoundary() && !seams.contains(edge.vertex) &&
        triangle_label[edge.triangle[0]] != triangle_label[edge.triangle[1]])
      edges.insert(edge.vertex);
  return edges;
}

std::vector<Seam> chainsAlong(const TriangleMesh& mesh, const EdgeSet& edges, const EdgeSet& seams) {
  std::vector<Seam> chains;
  for (std::vector<int>& chain : ChainWalk(mesh, edges, seams).chains()) {
    const bool is_closed = chain.front() == chain.back();
    if (is_closed) chain.pop_back();
    chains.push_back({fmt::format("cut {}", chains.size() + 1), std::move(chain), is_closed});
  }
  return chains;
}

}  // namespace ease
