#include "apps/checkpoint.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "solver/base/error.h"
#include "tests/apps/temporary_directory.h"
#include "tests/sheet.h"

using namespace ease;
using Catch::Contains;

namespace {

Checkpoint someCheckpoint() {
  Checkpoint c;
  c.run.done = {130, 120, 10};
  c.poses_met = {7, 8, 9};
  c.fit_setting = 0x123456789abcdef0;
  c.time_step_s = 0.0025;
  c.steps_per_pose = 4;
  c.interpolation_steps = 60;
  c.run.cloth = {randomPositions(7, 1), randomPositions(7, 2), {0.0, 1.0 / 3.0, 2e-5}};
  c.start = {{randomPositions(7, 4), Triangles::Constant(5, 3, 6)}, 0.005};
  c.first_rest = {randomPositions(7, 5), std::vector<Mat2>(5, Mat2::Identity())};
  c.run.rest = {randomPositions(7, 3), std::vector<Mat2>(5, (Mat2() << 1.0 / 3.0, 0.1, 0.0, 2.0).finished())};
  c.paint = {1.0, 1.1, 1.2, 1.0, 0.9};
  c.run.pins = {{3, 7, {0.1, 0.2, 0.3}}, {1, -1, {1.0, 2.0, 3.0}}};
  c.numbering = {{6, 5, 4, 3, 2, 1, 0}, {1, 0, 2, 4, 3}};
  return c;
}

}  // namespace

TEST_CASE("a checkpoint is read as it was written, to the last bit") {
  const TemporaryDirectory directory;
  const auto file = directory.path / "checkpoint.bin";
  const Checkpoint written = someCheckpoint();
  writeCheckpoint(file, written);
  const Checkpoint read = readCheckpoint(file);
  CHECK(read.run.done.total == written.run.done.total);
  CHECK(read.run.done.moving == written.run.done.moving);
  CHECK(read.run.done.still == written.run.done.still);
  CHECK(read.poses_met == written.poses_met);
  CHECK(read.fit_setting == written.fit_setting);
  CHECK(read.time_step_s == written.time_step_s);
  CHECK(read.steps_per_pose == written.steps_per_pose);
  CHECK(read.interpolation_steps == written.interpolation_steps);
  CHECK(read.run.cloth.positions == written.run.cloth.positions);
  CHECK(read.run.cloth.velocities == written.run.cloth.velocities);
  CHECK(read.run.cloth.normal_forces == written.run.cloth.normal_forces);
  CHECK(read.start.mesh.positions == written.start.mesh.positions);
  CHECK(read.start.mesh.triangles == written.start.mesh.triangles);
  CHECK(read.start.offset == written.start.offset);
  CHECK(read.first_rest.positions == written.first_rest.positions);
  CHECK(read.first_rest.edges == written.first_rest.edges);
  CHECK(read.run.rest.positions == written.run.rest.positions);
  CHECK(read.run.rest.edges == written.run.rest.edges);
  CHECK(read.paint == written.paint);
  CHECK(read.run.wanted_edges.empty());
  REQUIRE(read.run.pins.size() == 2);
  for (int k = 0; k < 2; ++k) {
    CHECK(read.run.pins[k].vertex == written.run.pins[k].vertex);
    CHECK(read.run.pins[k].triangle == written.run.pins[k].triangle);
    CHECK(read.run.pins[k].local == written.run.pins[k].local);
  }
  CHECK(read.numbering.vertices == written.numbering.vertices);
  CHECK(read.numbering.triangles == written.numbering.triangles);
}

TEST_CASE("a checkpoint of which one bit changed is refused, and so is one of an older version") {
  const TemporaryDirectory directory;
  const auto file = directory.path / "checkpoint.bin";
  writeCheckpoint(file, someCheckpoint());
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  for (size_t at = 18; at < bytes.size(); at += 29) {
    std::string flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << at % 8));
    const auto damaged = directory.write("damaged.bin", flipped);
    CHECK_THAT(messageOf<InputError>([&] { readCheckpoint(damaged); }), Contains("damaged.bin: is damaged"));
  }
  const auto old = directory.write("old.bin", "ease checkpoint 3\n" + bytes.substr(18));
  CHECK_THAT(messageOf<InputError>([&] { readCheckpoint(old); }),
             Contains("old.bin: is a checkpoint of another version"));
}

TEST_CASE("a checkpoint that is cut short anywhere, or is another file, is refused by its name") {
  const TemporaryDirectory directory;
  const auto file = directory.path / "checkpoint.bin";
  writeCheckpoint(file, someCheckpoint());
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  for (size_t length = 0; length < bytes.size(); length += 37) {
    const auto cut = directory.write("cut.bin", bytes.substr(0, length));
    CHECK_THAT(messageOf<InputError>([&] { readCheckpoint(cut); }), Contains("cut.bin"));
  }
  CHECK_THAT(messageOf<InputError>([&] { readCheckpoint(directory.path / "none.bin"); }), Contains("none.bin"));
}
