#include "garment/pattern/piece_names.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "solver/base/error.h"

namespace ease {
namespace {

constexpr double kAround = 0.6;     // of a loop: a piece that has more of it goes around it, as a sleeve does
constexpr double kSideways = 1.5;   // how much more a side panel faces sideways than to the front or back
constexpr double kUpwards = 0.5;    // share of a piece's area that it faces up or down with, as at a shoulder
constexpr double kBackwards = 0.3;  // share of its area that a back faces backwards with
constexpr double kApart = 0.05;     // m: pieces whose middles are nearer to each other do not lie beside each other

/// Where a piece lies on the wearer.
struct Place {
  Vec3 middle = Vec3::Zero();           // m
  Vec3 normal = Vec3::Zero();           // sum over its triangles, m^2
  double area = 0.0;                    // m^2
  std::map<std::string, double> loops;  // length of each that lies on the piece, m
};

std::vector<Place> placesOf(const CutGarment& cut, const TriangleMesh& garment) {
  std::vector<Place> places(cut.pieces.count);
  for (int t = 0; t < garment.triangles.rows(); ++t) {
    Place& place = places[cut.pieces.piece[t]];
    const Vec3 a = garment.positions.row(garment.triangles(t, 0)), b = garment.positions.row(garment.triangles(t, 1)),
               c = garment.positions.row(garment.triangles(t, 2)), normal = doubleAreaNormal(a, b, c);
    place.normal += 0.5 * normal;
    place.area += 0.5 * normal.norm();
    place.middle += 0.5 * normal.norm() * (a + b + c) / 3.0;
  }
  for (Place& place : places) place.middle /= place.area;
  for (const PieceEdge& edge : cut.edges)
    if (edge.line < 0) places[edge.piece].loops[edge.name] += lengthOf(edge.vertices, cut.pieces.mesh.positions);
  return places;
}

/// Where the garment's middle is, from the wearer's right to the left, m.
double middleOf(const std::vector<Place>& places) {
  double sum = 0.0, area = 0.0;
  for (const Place& place : places) {
    sum += place.area * place.middle.x();
    area += place.area;
  }
  return sum / area;
}

/// Lengths of all loops, m.
std::map<std::string, double> wholeLoops(const std::vector<Place>& places) {
  std::map<std::string, double> whole;
  for (const Place& place : places)
    for (const auto& [loop, length] : place.loops) whole[loop] += length;
  return whole;
}

bool isOfTrunk(const std::string& loop) {
  for (const char* word : {"hem", "neck", "waist", "top", "bottom", "edge"})
    if (loop.find(word) != std::string::npos) return true;
  return false;
}

const char* frontOrBack(const Place& place) {
  return place.normal.z() >= 0.0 ? "front" : "back";
}

std::string ownName(const Place& place, const std::map<std::string, double>& whole) {
  if (place.loops.size() == 1 && !isOfTrunk(place.loops.begin()->first)) {
    const auto& [loop, length] = *place.loops.begin();
    if (length > kAround * whole.at(loop)) return loop == "left" || loop == "right" ? loop + " sleeve" : loop;
    if (std::abs(place.normal.y()) > kUpwards * place.area) {
      const std::string side = place.middle.x() > 0.0 ? "left " : "right ";
      return side + (place.normal.y() > 0.0 ? "shoulder" : "underarm");
    }
  }
  if (std::abs(place.normal.x()) > kSideways * std::abs(place.normal.z()))
    return place.normal.x() > 0 ? "left side" : "right side";
  return frontOrBack(place);
}

/// Tells pieces of one name apart by a word, where that gives each of them another one.
template <class Word>
void tellApart(const std::vector<Place>& places, const Word& word, std::vector<std::string>& names) {
  std::map<std::string, std::vector<size_t>> alike;
  for (size_t p = 0; p < names.size(); ++p) alike[names[p]].push_back(p);
  for (const auto& [name, pieces] : alike) {
    if (pieces.size() < 2) continue;
    std::set<std::string> words;
    const auto wordOf = [&, &others = pieces](size_t p) {
      return word(places[p], places[others.front() == p ? others.back() : others.front()]);
    };
    for (const size_t p : pieces) words.insert(wordOf(p));
    if (words.size() < 2) continue;
    for (const size_t p : pieces) {
      const std::string prefix = wordOf(p);
      if (!prefix.empty() && name.find(prefix) == std::string::npos) names[p] = prefix + " " + name;
    }
  }
}

/// The piece of the triangle nearest to a point.
int pieceAt(const PieceName& name, const CutGarment& cut, const TriangleMesh& garment) {
  constexpr double kReach = 0.2;  // m, from the middle of a triangle
  int nearest = 0;
  double least = INFINITY;
  for (int t = 0; t < garment.triangles.rows(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (int k = 0; k < 3; ++k) middle += garment.positions.row(garment.triangles(t, k)).transpose() / 3.0;
    if ((middle - name.at).squaredNorm() >= least) continue;
    least = (middle - name.at).squaredNorm();
    nearest = cut.pieces.piece[t];
  }
  if (least > kReach * kReach)
    throw InputError(fmt::format("piece '{}' at [{:g}, {:g}, {:g}]: {:.2f} m from the garment: expected a point on it",
                                 name.name, name.at.x(), name.at.y(), name.at.z(), std::sqrt(least)));
  return nearest;
}

}  // namespace

std::vector<std::string> pieceNames(const CutGarment& cut, const TriangleMesh& garment,
                                    const std::vector<PieceName>& given) {
  const std::vector<Place> places = placesOf(cut, garment);
  std::vector<std::string> names;
  const std::map<std::string, double> whole = wholeLoops(places);
  for (const Place& place : places) names.push_back(ownName(place, whole));
  const auto beside = [](double p, double q, const char* more, const char* less) -> std::string {
    return std::abs(p - q) < kApart ? "" : p > q ? more : less;
  };
  tellApart(
      places, [](const Place& p, const Place&) -> std::string { return frontOrBack(p); }, names);
  const double middle = middleOf(places);
  const auto side = [&](const Place& p, const Place& q) -> std::string {  // none for what lies across the middle
    const std::string word = beside(p.middle.x(), q.middle.x(), "left", "right");
    return word == beside(p.middle.x(), middle, "left", "right") ? word : "";
  };
  tellApart(places, side, names);
  tellApart(
      places, [&](const Place& p, const Place& q) { return beside(p.middle.y(), q.middle.y(), "upper", "lower"); },
      names);
  std::map<int, std::string> named;
  for (const PieceName& name : given) {
    const int piece = pieceAt(name, cut, garment);
    if (const auto [other, is_new] = named.emplace(piece, name.name); !is_new)
      throw InputError(fmt::format("piece '{}' at [{:g}, {:g}, {:g}]: that piece is named '{}' already", name.name,
                                   name.at.x(), name.at.y(), name.at.z(), other->second));
    names[piece] = name.name;
  }
  std::map<std::string, int> count, so_far;
  for (const std::string& name : names) ++count[name];
  std::set<std::string> taken(names.begin(), names.end());
  for (size_t p = 0; p < names.size(); ++p) {
    const std::string name = names[p];
    if (count[name] < 2 || named.contains(static_cast<int>(p))) continue;
    do names[p] = fmt::format("{} {}", name, ++so_far[name]);
    while (!taken.insert(names[p]).second);
  }
  return names;
}

std::vector<char> backPieces(const CutGarment& cut, const TriangleMesh& garment) {
  std::vector<char> backs;
  for (const Place& place : placesOf(cut, garment))
    backs.push_back(place.normal.z() < -kBackwards * place.area ? 1 : 0);
  return backs;
}

bool isUpsideDown(const CutGarment& cut, const TriangleMesh& garment, const Positions& x, int piece) {
  double up = 0.0;  // correlation of warp and height
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  std::vector<int> vertices = outlineOf(cut, piece);
  for (const int v : vertices)
    mean += Eigen::Vector2d(x(v, 0), garment.positions(cut.pieces.glue[v], 1)) / static_cast<double>(vertices.size());
  for (const int v : vertices) up += (x(v, 0) - mean.x()) * (garment.positions(cut.pieces.glue[v], 1) - mean.y());
  return up > 0.0;
}

}  // namespace ease
