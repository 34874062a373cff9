#include "garment/pattern/flattening.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/shapes.h"
#include "tests/tube.h"

using namespace ease;

namespace {

/// Largest difference between the lengths of edges in the plane and at rest, m.
double worstEdge(const FlatPattern& pattern) {
  double worst = 0.0;
  for (int t = 0; t < pattern.flat.triangles.rows(); ++t) {
    const Mat2 flat = edgeMatrix(pattern.x, pattern.flat.triangles, t).topRows<2>();
    worst = std::max(worst, (edgeLengths(flat) - edgeLengths(pattern.flat.rest_edges[t])).cwiseAbs().maxCoeff());
  }
  return worst;
}

/// A part of a sphere of radius 1 m between two meridians `angle` apart, to `reach` rad from the equator.
TriangleMesh gore(double angle, double reach) {
  TriangleMesh mesh = bentSheet(24, 1.0, [](double, double) { return 0.0; });
  for (auto x : mesh.positions.rowwise()) {
    const double longitude = angle * x[0], latitude = 2.0 * reach * x[1];
    x << std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude);
  }
  return mesh;
}

}  // namespace

TEST_CASE("a tube cut open becomes a rectangle with the lengths of its edges") {
  const TriangleMesh mesh = tube(24, 9, 2.0);
  Seam seam{"side", {}, false};
  for (int r = 0; r < 9; ++r) seam.vertices.push_back(24 * r);
  const FlatPattern pattern = flattenGarment(restGarment(mesh, {seam}), exactSettings());
  CHECK(pattern.pieces.size() == 1);
  CHECK(worstEdge(pattern) < 1e-6);
  CHECK(pattern.x.col(0).maxCoeff() - pattern.x.col(0).minCoeff() == Approx(2.0).epsilon(1e-6));
  CHECK(pattern.x.col(1).maxCoeff() - pattern.x.col(1).minCoeff() ==
        Approx(24 * 2.0 * std::sin(M_PI / 24)).epsilon(1e-6));
  CHECK(pattern.mended == 0);
}

TEST_CASE("a cone without its tip, cut open, becomes part of a ring with the lengths of its edges") {
  const TriangleMesh mesh = cone(32, 7, 0.3, 0.9, false);
  Seam seam{"back", {}, false};
  for (int r = 0; r < 7; ++r) seam.vertices.push_back(32 * r);
  CHECK(worstEdge(flattenGarment(restGarment(mesh, {seam}), exactSettings())) < 1e-6);
}

TEST_CASE("a cone with a dart to its tip becomes a sector, and the legs of the dart are equally long") {
  const TriangleMesh mesh = cone(32, 6, 0.5, 0.2, true);
  Seam dart{"dart", {}, false};
  for (int r = 5; r >= 0; --r) dart.vertices.push_back(1 + 32 * r);
  dart.vertices.push_back(0);
  const FlatPattern pattern = flattenGarment(restGarment(mesh, {dart}), exactSettings());
  CHECK(worstEdge(pattern) < 1e-6);
  CHECK(pattern.pieces.front().darts == 1);
  REQUIRE(pattern.seams.size() == 1);
  CHECK(pattern.seams.front().left_length == Approx(pattern.seams.front().right_length).epsilon(1e-9));
  CHECK(pattern.seams.front().rest_length == Approx(std::hypot(0.5, 0.2)).epsilon(1e-9));
}

TEST_CASE("narrow gores of a sphere lie flat, wide ones do not") {
  FlatSettings settings;
  settings.max_darts = 0;
  const StrainSummary narrow = flattenGarment(restGarment(gore(M_PI / 8, 1.2)), settings).pieces.front().strain,
                      wide = flattenGarment(restGarment(gore(M_PI, 1.2)), settings).pieces.front().strain;
  CHECK(narrow.thread_p98 < 0.01);
  CHECK(keeps(narrow, settings.limits));
  CHECK_FALSE(keeps(wide, settings.limits));
  CHECK(wide.flipped == 0);
}

TEST_CASE("cloth whose threads are stiff shears where it cannot lie flat, and its threads stretch less") {
  const RestGarment cap = restGarment(bentSheet(20, 0.6, [](double x, double y) { return 0.5 * (x * x + y * y); }));
  FlatSettings woven, even;
  woven.max_darts = even.max_darts = 0;
  woven.limits.shear = woven.woven.shear_limit = 1.0;
  even.woven.shear = 1.0;
  even.limits.shear = 1e-6;  // so that shear is not softened
  const StrainSummary soft = flattenGarment(cap, woven).pieces.front().strain,
                      stiff = flattenGarment(cap, even).pieces.front().strain;
  CHECK(soft.thread_mean < 0.8 * stiff.thread_mean);
  CHECK(soft.shear_p99 > stiff.shear_p99);
  CHECK(soft.shear_p99 > 1.3 * soft.thread_p98);
}

TEST_CASE("both sides of a seam between pieces that stretch differently become equally long") {
  // The left half is a bowl, the right half is flat: by themselves their sides differ.
  const RestGarment sheet = restGarment(
      bentSheet(20, 0.8, [](double x, double y) { return x < 0.0 ? x * x * (1.5 - 4.0 * y * y) : 0.0; }), [] {
        Seam seam{"middle", {}, false};
        for (int j = 0; j <= 20; ++j) seam.vertices.push_back(21 * j + 10);
        return std::vector<Seam>{seam};
      }());
  FlatSettings loose, joined;
  loose.max_darts = joined.max_darts = 0;
  loose.woven.seam_weight = 1e-9;
  const auto difference = [&](const FlatSettings& settings) {
    const SeamSides sides = flattenGarment(sheet, settings).seams.front();
    return std::abs(sides.left_length - sides.right_length);
  };
  CHECK(difference(joined) < 1e-5);
  CHECK(difference(loose) > 1e-3);
}

TEST_CASE("a piece that is let out is hardly smaller than the garment anywhere, and uses more cloth") {
  const RestGarment bowl = restGarment(bentSheet(20, 0.5, [](double x, double y) { return 1.6 * (x * x + y * y); }));
  FlatSettings fitting, loose;
  fitting.max_darts = loose.max_darts = 0;
  loose.woven.excess = 0.1;
  const auto shortest = [&](const FlatPattern& pattern, double& area) {
    double least = 1.0;
    const std::vector<Mat2> sewn = sewnEdges(pattern);
    for (size_t t = 0; t < sewn.size(); ++t) {
      const Mat2 F = sewn[t] * bowl.rest_edges[t].inverse();
      least = std::min(least, F.jacobiSvd().singularValues()[1]);
      area += 0.5 * sewn[t].determinant();
    }
    return least;
  };
  double area = 0.0, loose_area = 0.0;
  const double least = shortest(flattenGarment(bowl, fitting), area),
               loose_least = shortest(flattenGarment(bowl, loose), loose_area);
  CHECK(least < 0.95);
  CHECK(1.0 - loose_least < 0.4 * (1.0 - least));
  CHECK(loose_area > 1.01 * area);
}

TEST_CASE("cloth that may become too large does so, and only there") {
  const RestGarment sheet = restGarment(bentSheet(20, 0.5, [](double, double) { return 0.0; }));
  FlatSettings settings;
  settings.max_darts = 0;
  const FlatPattern pattern = flattenGarment(sheet, settings);
  const auto middle = [](size_t t, int reach) {  // of the 20 x 20 cells, two triangles each
    const int cell = static_cast<int>(t) / 2, i = cell % 20 - 10, j = cell / 20 - 10;
    return std::max(std::abs(i), std::abs(j)) < reach;
  };
  std::vector<Mat2> grown = sheet.rest_edges;
  std::vector<double> excess(grown.size(), 1.0);
  for (size_t t = 0; t < grown.size(); ++t) {
    if (middle(t, 3)) grown[t] *= 1.05;
    if (middle(t, 6)) excess[t] = 0.1;
  }
  const auto area = [&](const FlatPattern& of, int from, int to) {
    const std::vector<Mat2> sewn = sewnEdges(of);
    double sum = 0.0;
    for (size_t t = 0; t < sewn.size(); ++t)
      if (middle(t, to) && !middle(t, from)) sum += 0.5 * sewn[t].determinant();
    return sum;
  };
  const FlatPattern stiff = flattenAgain(pattern, grown, settings),
                    loose = flattenAgain(pattern, grown, settings, excess);
  CHECK(area(loose, 0, 3) > 1.002 * area(stiff, 0, 3));
  CHECK(area(loose, 3, 6) > area(stiff, 3, 6));
  CHECK(flattenAgain(pattern, grown, settings, std::vector<double>(grown.size(), 1.0)).x == stiff.x);
}

TEST_CASE("the garment sewn from flat pieces has the same rest shape where these lie flat without strain") {
  const RestGarment sheet = restGarment(bentSheet(6, 0.5, [](double, double) { return 0.0; }));
  const FlatPattern pattern = flattenGarment(sheet, exactSettings());
  const std::vector<Mat2> sewn = sewnEdges(pattern);
  for (size_t t = 0; t < sewn.size(); ++t) CHECK((sewn[t] - sheet.rest_edges[t]).norm() < 1e-9);
}

TEST_CASE("every piece may have a stiffness in shear of its own") {
  const RestGarment cap = restGarment(bentSheet(12, 0.6, [](double x, double y) { return 0.3 * (x * x + y * y); }));
  FlatSettings settings;
  const FlatPattern pattern = flattenGarment(cap, settings);
  const auto shearWith = [&](const std::vector<double>& shear_of_piece) {
    const Flattened flat = flatten(pattern.flat, {}, settings.woven, &pattern.x, shear_of_piece);
    return strainOf(pattern.flat, flat.x, threadStrains(pattern.flat, flat.x), pattern.cut.pieces.piece, 0,
                    settings.limits)
        .shear_p99;
  };
  CHECK(shearWith({settings.woven.shear}) == shearWith({}));
  CHECK(shearWith({0.2 * settings.woven.shear}) > 1.1 * shearWith({}));
}
