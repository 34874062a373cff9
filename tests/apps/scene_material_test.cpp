#include "apps/scene_material.h"

#include "tests/apps/scene_text.h"

using namespace ease;
using Catch::Contains;

TEST_CASE("compressed threads are soft in a fit in passes, and as stiff as stretched ones otherwise") {
  const auto compression = [](const std::string& text) { return sceneOf(kBody + text).material.compression; };
  CHECK(compression("[adaption]\n") == 0.05);
  CHECK(compression("[adaption]\nmode = 'sequential'\n") == 1.0);
  CHECK(compression("[output]\n") == 1.0);
  CHECK(compression("[material]\ncompression = 0.3\n[adaption]\n") == 0.3);
}

TEST_CASE("folds are damped in a fit in passes, unless the scene says how") {
  const auto damping = [](const std::string& text) { return sceneOf(kBody + text).material.damping_bending; };
  CHECK(damping("[adaption]\n") == 1e-5);
  CHECK(damping("[adaption]\nmode = 'sequential'\n") == 0.0);
  CHECK(damping("[output]\n") == 0.0);
  CHECK(damping("[material]\ndamping = { stretch = 20 }\n[adaption]\n") == 0.0);
}

TEST_CASE("keys of one membrane are refused for the other, with what takes their place") {
  CHECK_THAT(errorOf(kBody + "[material]\nmembrane = 'isotropic'\ncompression = 0.1\n"),
             Contains("no such key with membrane = 'isotropic': it belongs to membrane = 'woven'"));
  CHECK_THAT(errorOf(kBody + "[material]\nmu = 100\n"), Contains("it belongs to membrane = 'isotropic'"));
  CHECK_THAT(errorOf(kBody + "[material]\ncompression = 1.5\n"), Contains("a number from 0 to 1"));
  CHECK_THAT(errorOf(kBody + "[material]\nstretch = [1, 2, 3]\n"), Contains("[warp, weft]"));
}
