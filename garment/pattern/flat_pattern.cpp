#include "garment/pattern/flat_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "garment/pattern/darts.h"
#include "garment/pattern/free_grain.h"
#include "garment/pattern/outline_crossing.h"
#include "garment/pattern/overlap.h"
#include "garment/pattern/piece_names.h"
#include "garment/pattern/piece_warnings.h"
#include "garment/pattern/slid_lines.h"

namespace ease {
namespace {

// Pieces far below the limit of shear may shear more so that their threads stretch less.  The softest shear is that of
// a wool cloth, of which FAST measures 0.4 to 0.7 % along threads and 4.7 % on the bias at 5 gf/cm: with stiffnesses 1
// along threads and k in shear that ratio is (1 + 1 / k) / 2, so that k is 0.04 to 0.08.
constexpr double kSoftest = 0.06;
constexpr double kRoom = 0.85;   // of the limit of shear, up to which a piece may shear then
constexpr double kSlowness = 4;  // shear at 99 % goes with about the fourth root of 1 / stiffness

constexpr const char* kOwn = "; to choose the place, add a [[garment.seam]] there";

// Darts are found along the mesh's edges, whose teeth give way where a straight line does not: once the lines slid,
// pieces may be over the limits again, and one more dart is looked for.
constexpr int kDartRounds = 2;

FlatPieces flatPieces(const CutGarment& cut, const std::vector<Mat2>& rest_edges) {
  FlatPieces flat{cut.pieces.mesh.triangles, rest_edges, {}, static_cast<int>(cut.pieces.glue.size())};
  for (int p = 0; p < cut.pieces.count; ++p) flat.outlines.push_back(outlineOf(cut, p));
  return flat;
}

/// How far along an edge its vertices lie in the garment, m.
std::vector<double> restLengthsAlong(const std::vector<int>& vertices, const FlatPieces& flat,
                                     const Topology& topology) {
  std::vector<double> lengths = {0.0};
  for (size_t i = 0; i + 1 < vertices.size(); ++i) {
    const std::array<int, 2> key = {std::min(vertices[i], vertices[i + 1]), std::max(vertices[i], vertices[i + 1])};
    const auto edge = std::lower_bound(topology.edges.begin(), topology.edges.end(), key,
                                       [](const Edge& e, const std::array<int, 2>& k) { return e.vertex < k; });
    const int t = edge->triangle[0];
    const double step = edgeLengths(flat.rest_edges[t])[cornerOf(flat.triangles, t, edge->opposite[0])];
    lengths.push_back(lengths.back() + step);
  }
  return lengths;
}

/// Strains, seam lengths and warnings of pieces that are flat.
void measure(const FlatSettings& settings, FlatPattern& pattern) {
  pattern.strains = threadStrains(pattern.flat, pattern.x);
  pattern.seams.clear();
  const Topology topology = buildTopology(pattern.cut.pieces.mesh, "the pattern's pieces");
  pattern.shares.clear();
  for (size_t e = 0; e < pattern.cut.edges.size(); ++e) {
    const PieceEdge& edge = pattern.cut.edges[e];
    std::vector<double> along = restLengthsAlong(edge.vertices, pattern.flat, topology);
    const double whole = along.back();
    for (double& length : along) length /= whole;
    pattern.shares.push_back(std::move(along));
    if (edge.partner <= static_cast<int>(e)) continue;
    SeamSides sides{edge.line, static_cast<int>(e), edge.partner, whole, 0.0, 0.0};
    sides.left_length = lengthOf(edge.vertices, pattern.x);
    sides.right_length = lengthOf(pattern.cut.edges[edge.partner].vertices, pattern.x);
    pattern.seams.push_back(sides);
  }
  for (size_t p = 0; p < pattern.pieces.size(); ++p) {
    FlatPiece& piece = pattern.pieces[p];
    const int number = static_cast<int>(p);
    piece.strain =
        strainOf(pattern.flat, pattern.x, pattern.strains, pattern.cut.pieces.piece, number, settings.limits);
    piece.crosses_itself = overlapsItself(pattern.cut, number, pattern.x);
    piece.darts = 0;
    for (const int e : pattern.cut.outlines[p]) piece.darts += isDartLeg(pattern.cut, e) ? 1 : 0;
    piece.darts /= 2;
  }
  pattern.warnings = pieceWarnings(pattern, settings.limits);
}

/// Flattens pieces once more that shear far less than they may, with softer shear; those stay that then went over it.
void softenShear(const FlatSettings& settings, FlatPattern& pattern) {
  const FlatPattern before = pattern;
  const double own = settings.woven.shear;
  bool is_softer = false;
  for (size_t p = 0; p < pattern.pieces.size(); ++p) {
    pattern.shear[p] = softerShear(pattern.pieces[p].strain, settings);
    is_softer = is_softer || pattern.shear[p] < own;
  }
  while (is_softer) {
    const Flattened softer = flatten(pattern.flat, sewnPairs(pattern.cut), settings.woven, &before.x, pattern.shear);
    pattern.x = softer.x;
    pattern.mended = before.mended + softer.mended;
    measure(settings, pattern);
    is_softer = false;
    for (size_t p = 0; p < pattern.pieces.size(); ++p) {
      const bool is_worse =
          keeps(before.pieces[p].strain, settings.limits) && !keeps(pattern.pieces[p].strain, settings.limits);
      if (!is_worse || pattern.shear[p] == own) continue;
      pattern.shear[p] = own;
      is_softer = true;
    }
  }
}

/// Whether the mouth of a dart is open on the paper, its legs drawn straight.  `in` leads from the mouth to the tip.
bool isOpen(const PieceEdge& in, const PieceEdge& out, const Positions& x) {
  const Vec3 to_tip = x.row(in.vertices.back()) - x.row(in.vertices.front());
  const Vec3 to_mouth = x.row(out.vertices.back()) - x.row(out.vertices.front());
  return to_tip.cross(to_mouth).z() < 0.0;
}

/// Number of the line of a dart without which a piece that overlaps itself might not: one that is not open, otherwise
/// the piece's last from `first_found` on, which nobody gave; -1: none.
int dartToLeaveOut(const FlatPattern& pattern, size_t first_found) {
  for (size_t p = 0; p < pattern.pieces.size(); ++p) {
    if (!pattern.pieces[p].crosses_itself) continue;
    int last = -1;
    for (const int e : pattern.cut.outlines[p]) {
      const PieceEdge& leg = pattern.cut.edges[e];
      if (!isDartLeg(pattern.cut, e)) continue;
      const PieceEdge& other = pattern.cut.edges[leg.partner];
      if (leg.vertices.back() == other.vertices.front() && !isOpen(leg, other, pattern.x)) return leg.line;
      if (leg.line >= static_cast<int>(first_found)) last = std::max(last, leg.line);
    }
    if (last >= 0) return last;
  }
  return -1;
}

/// Leaves a dart out; those after it are numbered anew.
void leaveOut(int dart, std::vector<CutLine>& lines) {
  for (size_t l = lines.size() - 1; l > static_cast<size_t>(dart); --l) lines[l].seam.name = lines[l - 1].seam.name;
  lines.erase(lines.begin() + dart);
}

/// Cuts along the pattern's lines, which have slid, flattens and measures the pieces.
void flattenAlongLines(const Pieces& pieces, const std::vector<double>& grain, const FlatSettings& settings,
                       FlatPattern& pattern) {
  const RestGarment garment = withGrain(pattern.slid.garment, pieces, grain);
  pattern.cut = cutGarment(garment.mesh, pattern.lines, garment.loops);
  pattern.flat = flatPieces(pattern.cut, garment.rest_edges);
  const Flattened flattened = flatten(pattern.flat, sewnPairs(pattern.cut), settings.woven);
  pattern.x = flattened.x;
  pattern.mended = flattened.mended;
  const std::vector<std::string> names = pieceNames(pattern.cut, garment.mesh, settings.names);
  const std::vector<char> backs = backPieces(pattern.cut, garment.mesh);
  pattern.pieces.clear();
  for (int p = 0; p < pattern.cut.pieces.count; ++p) {
    FlatPiece piece;
    piece.name = names[p];
    piece.grain = grain[p];  // darts divide no piece, so that pieces keep their numbers
    piece.upside_down = isUpsideDown(pattern.cut, garment.mesh, pattern.x, p);
    piece.is_back = backs[p];
    pattern.pieces.push_back(piece);
  }
  measure(settings, pattern);
  pattern.shear.assign(pattern.pieces.size(), settings.woven.shear);
  softenShear(settings, pattern);
}

}  // namespace

double lengthOf(const std::vector<int>& vertices, const Positions& x) {
  double length = 0.0;
  for (size_t i = 0; i + 1 < vertices.size(); ++i) length += (x.row(vertices[i + 1]) - x.row(vertices[i])).norm();
  return length;
}

std::vector<SewnPair> sewnPairs(const CutGarment& cut) {
  std::vector<SewnPair> pairs;
  for (size_t e = 0; e < cut.edges.size(); ++e) {
    const PieceEdge& a = cut.edges[e];
    if (a.partner < static_cast<int>(e)) continue;
    const PieceEdge& b = cut.edges[a.partner];
    const size_t n = a.vertices.size();
    for (size_t i = 0; i + 1 < n; ++i)
      pairs.push_back({a.vertices[i], a.vertices[i + 1], b.vertices[n - 1 - i], b.vertices[n - 2 - i]});
  }
  return pairs;
}

bool isDartLeg(const CutGarment& cut, int edge) {
  const PieceEdge& leg = cut.edges[edge];
  if (leg.partner < 0 || cut.edges[leg.partner].piece != leg.piece) return false;
  const PieceEdge& other = cut.edges[leg.partner];
  return leg.vertices.back() == other.vertices.front() || leg.vertices.front() == other.vertices.back();
}

bool overlapsItself(const CutGarment& cut, int piece, const Positions& x) {
  std::vector<int> outline;
  for (const int e : cut.outlines[piece]) {
    const std::vector<int>& vertices = cut.edges[e].vertices;
    const bool is_leg = isDartLeg(cut, e);
    outline.insert(outline.end(), vertices.begin(), is_leg ? vertices.begin() + 1 : vertices.end() - 1);
    if (!is_leg) continue;
    const PieceEdge& other = cut.edges[cut.edges[e].partner];
    if (vertices.back() == other.vertices.front() && !isOpen(cut.edges[e], other, x)) return true;
  }
  return crossesItself(outline, x);
}

std::vector<int> outlineOf(const CutGarment& cut, int piece) {
  std::vector<int> outline;
  for (const int e : cut.outlines[piece])
    outline.insert(outline.end(), cut.edges[e].vertices.begin(), cut.edges[e].vertices.end() - 1);
  return outline;
}

double softerShear(const StrainSummary& strain, const FlatSettings& settings) {
  const double own = settings.woven.shear, reached = strain.shear_p99 / (kRoom * settings.limits.shear);
  return std::min(own, std::max(kSoftest, own * std::pow(reached, kSlowness)));
}

FlatPattern flattenGarment(const RestGarment& given, const FlatSettings& settings) {
  FlatPattern pattern;
  for (const Seam& seam : given.seams) pattern.lines.push_back({seam, LineKind::seam});
  pattern.lines = makeDisks(given.mesh, given.rest_edges, pattern.lines, given.loops);
  const size_t asked = pattern.lines.size();
  pattern.lines = withoutOverlaps(given, pattern.lines, settings);
  size_t mended = pattern.lines.size();
  std::vector<std::string> warnings;
  for (size_t l = given.seams.size(); l < asked; ++l)
    warnings.push_back(
        fmt::format("a piece had a hole and was cut open along '{}'{}", pattern.lines[l].seam.name, kOwn));
  for (size_t l = asked; l < mended; ++l)
    warnings.push_back(fmt::format("a piece overlapped itself when flat and was cut in two along '{}'{}",
                                   pattern.lines[l].seam.name, kOwn));
  std::vector<Seam> seams;
  for (const CutLine& line : pattern.lines) seams.push_back(line.seam);
  const Pieces pieces = cutIntoPieces(given.mesh, seams);
  const std::vector<double> grain =
      settings.free_grain ? freeGrain(given, pieces, settings) : std::vector<double>(pieces.count, 0.0);
  pattern.slid.garment = given;
  for (int round = 0; round < kDartRounds; ++round) {
    const size_t before = pattern.lines.size();
    FlatSettings more = settings;
    if (round > 0) more.max_darts = std::min(settings.max_darts, static_cast<int>(before - mended) + 1);
    pattern.lines = withDarts(withGrain(pattern.slid.garment, pieces, grain), pattern.lines, more);
    if (round > 0 && pattern.lines.size() == before) break;
    pattern.slid = slideLines(given, pattern.lines);
    if (pattern.lines.size() == before) break;
  }
  flattenAlongLines(pieces, grain, settings, pattern);
  // A dart that opened along the mesh's edges may close once the lines slid, and a given one may never have opened.
  int left_out = 0;
  for (int l = dartToLeaveOut(pattern, mended); l >= 0; l = dartToLeaveOut(pattern, mended)) {
    if (l < static_cast<int>(mended)) {
      warnings.push_back(
          fmt::format("the dart '{}' was left out: its legs do not open on the paper, or it leads across a seam",
                      pattern.lines[l].seam.name));
      pattern.lines.erase(pattern.lines.begin() + l);
      --mended;
    } else {
      ++left_out;
      leaveOut(l, pattern.lines);
    }
    pattern.slid = slideLines(given, pattern.lines);
    flattenAlongLines(pieces, grain, settings, pattern);
  }
  if (left_out > 0)
    warnings.push_back(fmt::format(
        "darts that would not open on the paper were left out: {}; add a [[garment.seam]] there", left_out));
  pattern.warnings.insert(pattern.warnings.end(), warnings.begin(), warnings.end());
  return pattern;
}

FlatPattern flattenAgain(const FlatPattern& pattern, const std::vector<Mat2>& rest_edges, const FlatSettings& settings,
                         const std::vector<double>& excess_of_triangle) {
  FlatPattern again = pattern;
  again.flat.rest_edges = rest_edges;
  const Flattened flattened =
      flatten(again.flat, sewnPairs(again.cut), settings.woven, &pattern.x, pattern.shear, excess_of_triangle);
  again.x = flattened.x;
  again.mended += flattened.mended;
  measure(settings, again);
  again.strains = pattern.strains;
  again.warnings = pattern.warnings;
  for (size_t p = 0; p < again.pieces.size(); ++p) {
    const StrainSummary now = again.pieces[p].strain;
    again.pieces[p].strain = pattern.pieces[p].strain;
    again.pieces[p].strain.flipped = now.flipped;
    again.pieces[p].strain.area = now.area;
  }
  return again;
}

std::vector<Mat2> sewnEdges(const FlatPattern& pattern) {
  std::vector<Mat2> edges;
  for (int t = 0; t < pattern.flat.triangles.rows(); ++t)
    edges.push_back(edgeMatrix(pattern.x, pattern.flat.triangles, t).topRows<2>());
  return edges;
}

}  // namespace ease
