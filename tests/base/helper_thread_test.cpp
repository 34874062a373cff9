#include "solver/base/helper_thread.h"

#include <catch2/catch.hpp>
#include <stdexcept>

using namespace ease;

TEST_CASE("a helper thread does one task after another beside its owner") {
  HelperThread helper;
  int done = 0;
  const std::thread::id owner = std::this_thread::get_id();
  std::thread::id worker = owner;
  const std::function<void()> task = [&] {
    ++done;
    worker = std::this_thread::get_id();
  };
  for (int k = 0; k < 100; ++k) {
    helper.start(task);
    CHECK(helper.isBusy());
    helper.wait();
    REQUIRE(done == k + 1);
  }
  CHECK_FALSE(helper.isBusy());
  CHECK(worker != owner);
}

TEST_CASE("a helper thread hands on what its task throws, and works on") {
  HelperThread helper;
  const std::function<void()> fails = [] { throw std::runtime_error("no"); };
  helper.start(fails);
  CHECK_THROWS_AS(helper.wait(), std::runtime_error);
  bool is_done = false;
  const std::function<void()> works = [&] { is_done = true; };
  helper.start(works);
  helper.wait();
  CHECK(is_done);
}
