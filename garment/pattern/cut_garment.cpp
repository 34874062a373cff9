#include "garment/pattern/cut_garment.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <set>

#include "solver/base/error.h"
#include "solver/mesh/topology.h"

namespace ease {
namespace {

std::vector<Seam> seamsOf(const std::vector<CutLine>& lines) {
  std::vector<Seam> seams;
  for (const CutLine& line : lines) seams.push_back(line.seam);
  return seams;
}

/// A boundary edge of the cut mesh, from one vertex to the next along the outline.
struct Side {
  int from, to;     // of the cut mesh
  int line = -1;    // cut line; -1: boundary of the garment
  int across = -1;  // the side that it is sewn to
};

/// The sides of all outlines, by the vertex where they begin.
class Sides {
 public:
  Sides(const TriangleMesh& garment, const Pieces& pieces, const std::vector<CutLine>& lines) : pieces_(pieces) {
    for (size_t l = 0; l < lines.size(); ++l) {
      const Seam& seam = lines[l].seam;
      const size_t n = seam.vertices.size();
      for (size_t i = 0; i + (seam.is_closed ? 0 : 1) < n; ++i)
        line_of_[key(seam.vertices[i], seam.vertices[(i + 1) % n])] = static_cast<int>(l);
    }
    topology_ = buildTopology(pieces.mesh, "the pattern's pieces");
    piece_of_.assign(pieces.glue.size(), -1);
    for (int t = 0; t < garment.triangles.rows(); ++t)
      for (int k = 0; k < 3; ++k) piece_of_[pieces.mesh.triangles(t, k)] = pieces.piece[t];
    std::map<std::pair<int, int>, int> directed;  // of the garment
    begins_at_.assign(pieces.glue.size(), -1);
    for (const std::vector<int>& loop : topology_.boundary_loops)
      for (size_t i = 0; i < loop.size(); ++i) {
        const int a = loop[i], b = loop[(i + 1) % loop.size()];
        const auto line = line_of_.find(key(pieces.glue[a], pieces.glue[b]));
        begins_at_[a] = static_cast<int>(sides_.size());
        directed[{pieces.glue[a], pieces.glue[b]}] = begins_at_[a];
        sides_.push_back({a, b, line == line_of_.end() ? -1 : line->second, -1});
      }
    for (Side& side : sides_) {
      const auto found = directed.find({pieces.glue[side.to], pieces.glue[side.from]});
      if (found != directed.end()) side.across = found->second;
    }
  }

  const Topology& topology() const { return topology_; }
  const Side& at(int side) const { return sides_[side]; }
  int pieceOf(int vertex) const { return piece_of_[vertex]; }
  int beginningAt(int vertex) const { return begins_at_[vertex]; }
  int next(int side) const { return begins_at_[sides_[side].to]; }

  /// Whether the outline is divided between `side` and the next one.
  bool endsAfter(int side) const {
    const Side &a = sides_[side], &b = sides_[next(side)];
    if (a.line != b.line) return true;
    if (a.line < 0) return false;
    return a.across == next(side) || sides_[b.across].to != sides_[a.across].from;
  }

 private:
  static std::pair<int, int> key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

  const Pieces& pieces_;
  Topology topology_;
  std::map<std::pair<int, int>, int> line_of_;  // by the edge's vertices in the garment
  std::vector<int> piece_of_;                   // by vertex of the cut mesh
  std::vector<Side> sides_;
  std::vector<int> begins_at_;  // side by its first vertex
};

std::string loopNameOf(int vertex, const std::vector<NamedLoop>& loops) {
  for (const NamedLoop& loop : loops)
    if (std::find(loop.vertices.begin(), loop.vertices.end(), vertex) != loop.vertices.end()) return loop.name;
  return "edge";
}

/// The names of lines and loops around a piece, for messages.
std::string surroundings(int piece, const Sides& sides, const Pieces& pieces, const std::vector<CutLine>& lines,
                         const std::vector<NamedLoop>& loops) {
  std::set<std::string> names;
  for (const std::vector<int>& loop : sides.topology().boundary_loops) {
    if (sides.pieceOf(loop.front()) != piece) continue;
    for (size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i], b = loop[(i + 1) % loop.size()];
      std::string name;
      for (const CutLine& line : lines) {
        const auto& v = line.seam.vertices;
        const auto has = [&](int w) { return std::find(v.begin(), v.end(), pieces.glue[w]) != v.end(); };
        if (has(a) && has(b)) name = line.seam.name;
      }
      names.insert(name.empty() ? loopNameOf(pieces.glue[a], loops) : name);
    }
  }
  return fmt::format("'{}'", fmt::join(names, "', '"));
}

/// Shortest path over inner edges of a piece from its first outline to another one; empty: there is none.
std::vector<int> shortestOpening(int piece, const Sides& sides, const Pieces& pieces,
                                 const std::vector<std::vector<std::pair<int, double>>>& neighbours) {
  const size_t n = pieces.glue.size();
  std::vector<double> reached(n, std::numeric_limits<double>::infinity());
  std::vector<int> before(n, -1), outline(n, -1);
  int first = -1, number = 0;
  for (const std::vector<int>& loop : sides.topology().boundary_loops) {
    if (sides.pieceOf(loop.front()) != piece) continue;
    if (first < 0) first = number;
    for (const int v : loop) outline[v] = number;
    ++number;
  }
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (size_t v = 0; v < n; ++v)
    if (outline[v] == first && sides.pieceOf(static_cast<int>(v)) == piece) {
      reached[v] = 0.0;
      front.push({0.0, static_cast<int>(v)});
    }
  while (!front.empty()) {
    const auto [length, v] = front.top();
    front.pop();
    if (length > reached[v]) continue;
    if (outline[v] >= 0 && outline[v] != first) {
      std::vector<int> path;
      for (int w = v; w >= 0; w = before[w]) path.push_back(pieces.glue[w]);
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (const auto& [w, edge] : neighbours[v]) {
      if (outline[w] == first || length + edge >= reached[w]) continue;
      reached[w] = length + edge;
      before[w] = v;
      front.push({reached[w], w});
    }
  }
  return {};
}

/// Inner edges of the cut mesh with their lengths, m.
std::vector<std::vector<std::pair<int, double>>> innerNeighbours(const Topology& topology, size_t vertices,
                                                                 const Triangles& triangles,
                                                                 const std::vector<Mat2>& rest_edges) {
  std::vector<std::vector<std::pair<int, double>>> neighbours(vertices);
  for (const Edge& edge : topology.edges) {
    if (edge.isBoundary()) continue;
    const int t = edge.triangle[0];
    const double length = edgeLengths(rest_edges[t])[cornerOf(triangles, t, edge.opposite[0])];
    neighbours[edge.vertex[0]].emplace_back(edge.vertex[1], length);
    neighbours[edge.vertex[1]].emplace_back(edge.vertex[0], length);
  }
  return neighbours;
}

}  // namespace

std::vector<CutLine> makeDisks(const TriangleMesh& garment, const std::vector<Mat2>& rest_edges,
                               const std::vector<CutLine>& lines, const std::vector<NamedLoop>& loops) {
  std::vector<CutLine> all = lines;
  for (;;) {
    const Pieces pieces = cutIntoPieces(garment, seamsOf(all));
    const Sides sides(garment, pieces, all);
    std::vector<int> outlines(pieces.count, 0);
    for (const std::vector<int>& loop : sides.topology().boundary_loops) ++outlines[sides.pieceOf(loop.front())];
    const auto open = std::find_if(outlines.begin(), outlines.end(), [](int count) { return count > 1; });
    if (open == outlines.end()) break;
    const int piece = static_cast<int>(open - outlines.begin());
    const std::vector<int> path = shortestOpening(
        piece, sides, pieces, innerNeighbours(sides.topology(), pieces.glue.size(), pieces.mesh.triangles, rest_edges));
    if (path.size() < 2)
      throw InputError(
          fmt::format("the piece between {} has a hole and no way to cut it open: expected a seam there, "
                      "or smaller triangles",
                      surroundings(piece, sides, pieces, all, loops)));
    const int number = static_cast<int>(
        std::count_if(all.begin(), all.end(), [](const CutLine& line) { return line.kind == LineKind::opened; }));
    all.push_back({{fmt::format("opening {}", number + 1), path, false}, LineKind::opened});
  }
  return all;
}

CutGarment cutGarment(const TriangleMesh& garment, const std::vector<CutLine>& lines,
                      const std::vector<NamedLoop>& loops) {
  CutGarment cut;
  cut.pieces = cutIntoPieces(garment, seamsOf(lines));
  const Sides sides(garment, cut.pieces, lines);
  cut.outlines.resize(cut.pieces.count);
  std::vector<int> outlines(cut.pieces.count, 0);
  std::map<int, int> edge_of;  // by side: the edge that begins with it
  for (const std::vector<int>& loop : sides.topology().boundary_loops) {
    const int piece = sides.pieceOf(loop.front());
    if (++outlines[piece] > 1)
      throw InputError(fmt::format("the piece between {} has a hole: expected a seam that opens it",
                                   surroundings(piece, sides, cut.pieces, lines, loops)));
    int side = sides.beginningAt(loop.front());
    const int first = side;
    do {  // begin where an edge begins
      if (sides.endsAfter(side)) break;
      side = sides.next(side);
    } while (side != first);
    side = sides.next(side);
    const int begin = side;
    do {
      const Side& at = sides.at(side);
      PieceEdge edge{piece, {at.from}, at.line, LineKind::seam, "", -1};
      edge.name = at.line < 0 ? loopNameOf(cut.pieces.glue[at.from], loops) : lines[at.line].seam.name;
      if (at.line >= 0) edge.kind = lines[at.line].kind;
      edge_of[side] = static_cast<int>(cut.edges.size());
      bool ends = false;
      do {
        edge.vertices.push_back(sides.at(side).to);
        ends = sides.endsAfter(side);
        side = sides.next(side);
      } while (!ends && side != begin);
      if (edge.line >= 0)  // the edge across begins with what is across the last side
        edge.partner = sides.at(sides.beginningAt(edge.vertices[edge.vertices.size() - 2])).across;
      cut.outlines[piece].push_back(static_cast<int>(cut.edges.size()));
      cut.edges.push_back(std::move(edge));
    } while (side != begin);
  }
  for (PieceEdge& edge : cut.edges)
    if (edge.line >= 0) edge.partner = edge.partner < 0 || !edge_of.contains(edge.partner) ? -1 : edge_of[edge.partner];
  std::vector<int> euler(cut.pieces.count, 0);  // of each piece: vertices - edges + triangles, 1 for a disk
  for (size_t v = 0; v < cut.pieces.glue.size(); ++v) ++euler[sides.pieceOf(static_cast<int>(v))];
  for (const Edge& edge : sides.topology().edges) --euler[sides.pieceOf(edge.vertex[0])];
  for (const int piece : cut.pieces.piece) ++euler[piece];
  for (int piece = 0; piece < cut.pieces.count; ++piece) {
    if (outlines[piece] == 0)
      throw InputError("a piece has no outline: expected seams that open it, or a garment with an opening");
    if (euler[piece] != 1)
      throw InputError(fmt::format("the piece between {} has a handle, like a cup: expected a seam that opens it",
                                   surroundings(piece, sides, cut.pieces, lines, loops)));
  }
  return cut;
}

}  // namespace ease
