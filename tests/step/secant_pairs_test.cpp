#include "solver/step/secant_pairs.h"

#include <catch2/catch.hpp>
#include <deque>

#include "tests/sheet.h"

using namespace ease;

namespace {

double product(const Positions& a, const Positions& b) {
  return a.cwiseProduct(b).sum();
}

/// The two-loop recursion as in textbooks, with `scale` times the identity as initial inverse Hessian.
struct TwoLoops {
  struct Pair {
    Positions s, y;
  };
  std::deque<Pair> pairs;  // the newest first

  Positions direction(const Positions& gradient, double scale) const {
    Positions q = -gradient;
    std::vector<double> alpha;
    for (const Pair& p : pairs) {
      alpha.push_back(product(p.s, q) / product(p.s, p.y));
      q -= alpha.back() * p.y;
    }
    Positions d = scale * q;
    for (size_t k = pairs.size(); k-- > 0;)
      d += (alpha[k] - product(pairs[k].y, d) / product(pairs[k].s, pairs[k].y)) * pairs[k].s;
    return d;
  }
};

/// Gradient of a quadratic energy whose Hessian has eigenvalues from 1 to 10.
Positions gradientAt(const Positions& x) {
  Positions gradient = x;
  for (int i = 0; i < x.rows(); ++i) gradient.row(i) *= 1.0 + 9.0 * i / x.rows();
  return gradient;
}

}  // namespace

TEST_CASE("secant pairs make the directions of the two loops, however many there have been") {
  const int rows = GENERATE(20, 2500);
  SecantPairs pairs;
  TwoLoops loops;
  Positions x = randomPositions(rows, 1);
  for (int n = 0; n < 12; ++n) {
    const Positions gradient = gradientAt(x), expected = loops.direction(gradient, 0.3);
    Positions d;
    pairs.applyFirstLoop(gradient, d);
    d *= 0.3;
    const double slope = pairs.applySecondLoop(gradient, d);
    CHECK((d - expected).norm() < 1e-10 * expected.norm());
    CHECK(slope == Approx(product(gradient, expected)));
    const Positions next = x + 0.5 * expected + 0.01 * randomPositions(rows, n);
    pairs.remember(x, gradient, next, gradientAt(next));
    loops.pairs.push_front({next - x, gradientAt(next) - gradient});
    if (loops.pairs.size() > 5) loops.pairs.pop_back();
    x = next;
  }
}

TEST_CASE("secant pairs that are not convex are left out") {
  const Positions x = randomPositions(20, 1), next = randomPositions(20, 2), gradient = randomPositions(20, 3);
  SecantPairs pairs;
  pairs.remember(x, x, next, next);
  REQUIRE_FALSE(pairs.empty());
  Positions before, after;
  pairs.applyFirstLoop(gradient, before);
  pairs.applySecondLoop(gradient, before);
  pairs.remember(x, x, next, 2.0 * x - next);
  pairs.applyFirstLoop(gradient, after);
  pairs.applySecondLoop(gradient, after);
  CHECK(after == before);
  pairs.clear();
  CHECK(pairs.empty());
}
