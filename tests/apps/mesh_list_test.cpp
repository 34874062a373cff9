#include "apps/mesh_list.h"

#include <catch2/catch.hpp>

#include "tests/apps/temporary_directory.h"

using namespace ease;
using Names = std::vector<std::string>;

TEST_CASE("wildcards and folders stand for their mesh files, sorted as people number them") {
  const TemporaryDirectory directory;
  for (const char* name : {"scan_10.obj", "scan_2.obj", "scan_1.PLY", "notes.txt", "other.stl"})
    directory.write(name, "x");
  std::filesystem::create_directory(directory.path / "motion");
  directory.write("motion/frame0010.obj", "x");
  directory.write("motion/frame0009.obj", "x");
  std::string missing;
  CHECK(expandFiles({"scan_*"}, directory.path, missing) == Names{"scan_1.PLY", "scan_2.obj", "scan_10.obj"});
  CHECK(expandFiles({"other.stl", "scan_?.obj"}, directory.path, missing) == Names{"other.stl", "scan_2.obj"});
  CHECK(expandFiles({"motion"}, directory.path, missing) == Names{"motion/frame0009.obj", "motion/frame0010.obj"});
  CHECK(expandFiles({"motion/frame*9.obj"}, directory.path, missing) == Names{"motion/frame0009.obj"});
  CHECK(missing.empty());
  CHECK(expandFiles({"scan_*", "none_*.ply"}, directory.path, missing).empty());
  CHECK(missing == "none_*.ply");
  CHECK(expandFiles({"not_yet.obj"}, directory.path, missing) == Names{"not_yet.obj"});
}

TEST_CASE("numbers in names count as numbers, whatever their zeros and length") {
  CHECK(comesBeforeAsNumbered("a2", "a10"));
  CHECK_FALSE(comesBeforeAsNumbered("a10", "a2"));
  CHECK(comesBeforeAsNumbered("a002b", "a3"));
  CHECK(comesBeforeAsNumbered("a99999999999999999999998", "a99999999999999999999999"));
  CHECK(comesBeforeAsNumbered("a", "b"));
  CHECK_FALSE(comesBeforeAsNumbered("a1", "a1"));
}

TEST_CASE("a list of many is told in short") {
  CHECK(shortList({"t", "a"}) == "t, a");
  CHECK(shortList(Names(300, "f")) == "f, f, ... f (300 in all)");
}
