#include "garment/pattern/cut_flow.h"

#include <oneapi/tbb/global_control.h>
#include <catch2/catch.hpp>

#include "tests/garment/pattern/cut_shapes.h"

using namespace ease;

TEST_CASE("the energy falls in every step") {
  const RestSurface surface = cap(16);
  FlowSettings settings;
  settings.steps = 40;
  const FlowResult flow = followFlow(surface, discLevels(surface, 0.05, 0.02, 0.01), settings);
  REQUIRE(flow.energies.size() > 5);
  for (size_t i = 0; i + 1 < flow.energies.size(); ++i) CHECK(flow.energies[i + 1] < flow.energies[i]);
}

TEST_CASE("where only length counts, a region inside a flat sheet shrinks and vanishes") {
  const RestSurface sheet = flatSheet(16, 1.0);
  FlowSettings settings;
  settings.weights = {0.0, 5.0};
  const FlowResult flow = followFlow(sheet, discLevels(sheet, 0.2), settings);
  const RegionMap map = mapOf(sheet, flow.levels);
  CHECK(std::all_of(map.label.begin(), map.label.end(), [](int label) { return label == 0; }));
}

TEST_CASE("a slanting line becomes the shortest one and meets the border at a right angle") {
  const RestSurface sheet = flatSheet(20, 1.0);
  RegionLevels levels = halves(sheet, 0.0);
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    levels.of(1)[v] = 0.4 * sheet.mesh.positions(v, 1) - sheet.mesh.positions(v, 0);
    levels.of(0)[v] = -levels.of(1)[v];
  }
  FlowSettings settings;
  settings.weights = {0.0, 5.0};
  settings.tolerance = 1e-7;
  CHECK(followFlow(sheet, levels, settings).energies.back() == Approx(10.0).epsilon(2e-3));
}

TEST_CASE("the flow is the same with any number of threads") {
  const RestSurface surface = cap(16);
  FlowSettings settings;
  settings.steps = 10;
  const auto run = [&](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return followFlow(surface, discLevels(surface, 0.05, 0.02, 0.01), settings).levels.phi;
  };
  CHECK(run(1) == run(4));
}
