#include "viz/offscreen.h"

#include <catch2/catch.hpp>

#include "solver/base/error.h"

TEST_CASE("a context without a display is current for as long as it lives, and can be had again") {
  for (int k = 0; k < 2; ++k) {
    try {
      const ease::OffscreenContext context;
      CHECK(eglGetCurrentContext() != EGL_NO_CONTEXT);
    } catch (const ease::ComputationError& error) {
      WARN("skipped: " << error.what());
      CHECK_THAT(error.what(), Catch::Matchers::Contains("no OpenGL without a display: "));
    }
    CHECK(eglGetCurrentContext() == EGL_NO_CONTEXT);
  }
}
