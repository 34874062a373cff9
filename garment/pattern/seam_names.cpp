#include "garment/pattern/seam_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "garment/pattern/piece_names.h"

namespace ease {
namespace {

constexpr double kAside = 0.03;  // m from the middle of the garment: nearer seams lie on neither side

Vec3 middleOf(const Seam& seam, const Positions& positions) {
  Vec3 middle = Vec3::Zero();
  for (const int v : seam.vertices) middle += positions.row(v).transpose() / static_cast<double>(seam.vertices.size());
  return middle;
}

/// Numbers seams of one name from the top down.
void number(const std::vector<size_t>& alike, const Positions& positions, std::vector<Seam>& seams) {
  std::vector<size_t> order = alike;
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return middleOf(seams[a], positions).y() > middleOf(seams[b], positions).y();
  });
  for (size_t i = 0; i < order.size(); ++i) seams[order[i]].name += fmt::format(" {}", i + 1);
}

std::map<std::string, std::vector<size_t>> byName(size_t first, const std::vector<Seam>& seams) {
  std::map<std::string, std::vector<size_t>> named;
  for (size_t s = first; s < seams.size(); ++s) named[seams[s].name].push_back(s);
  return named;
}

}  // namespace

void nameFoundSeams(size_t first, const std::vector<PieceName>& given, RestGarment& garment) {
  if (first >= garment.seams.size()) return;
  std::vector<CutLine> lines;
  for (const Seam& seam : garment.seams) lines.push_back({seam, LineKind::seam});
  const CutGarment cut =
      cutGarment(garment.mesh, makeDisks(garment.mesh, garment.rest_edges, lines, garment.loops), garment.loops);
  const std::vector<std::string> names = pieceNames(cut, garment.mesh, given);
  for (const PieceEdge& edge : cut.edges) {
    if (edge.line < static_cast<int>(first) || edge.line >= static_cast<int>(garment.seams.size())) continue;
    if (edge.partner < 0) continue;
    const std::string &one = names[edge.piece], &other = names[cut.edges[edge.partner].piece];
    garment.seams[edge.line].name =
        one == other ? "within " + one : std::min(one, other) + " / " + std::max(one, other);
  }
  const Positions& x = garment.mesh.positions;
  const double middle = 0.5 * (x.col(0).minCoeff() + x.col(0).maxCoeff());
  for (const auto& [name, alike] : byName(first, garment.seams)) {
    if (alike.size() < 2) continue;
    for (const size_t s : alike) {
      const double aside = middleOf(garment.seams[s], x).x() - middle;
      if (std::abs(aside) > kAside) garment.seams[s].name = name + (aside > 0.0 ? ", left" : ", right");
    }
  }
  std::set<std::string> taken;
  for (size_t s = 0; s < first; ++s) taken.insert(garment.seams[s].name);
  for (const auto& [name, alike] : byName(first, garment.seams))
    if (alike.size() > 1 || taken.contains(name)) number(alike, x, garment.seams);
}

}  // namespace ease
