#include "solver/base/whole_file.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "solver/base/error.h"
#include "tests/apps/temporary_directory.h"

namespace fs = std::filesystem;
using Catch::Contains;

TEST_CASE("a file holds exactly the bytes written, and none of its earlier ones") {
  const ease::TemporaryDirectory directory;
  const fs::path file = directory.path / "frame.vtp";
  const std::string bytes("a\0b\r\n\xff", 6);
  for (const std::string& written : {std::string(100'000, 'x'), bytes, std::string()}) {
    ease::writeWholeFile(file, written);
    CHECK(ease::contentOf(file) == written);
  }
  CHECK(std::distance(fs::directory_iterator(directory.path), {}) == 1);
  CHECK(ease::contentOf(directory.path / "missing").empty());
}

TEST_CASE("the temporary name differs from the file's and lies in the same folder") {
  CHECK(ease::temporaryName("out/garment.pvd") == fs::path("out/garment.pvd.part"));
}

TEST_CASE("a temporary file left by an interrupted run is replaced") {
  const ease::TemporaryDirectory directory;
  const fs::path file = directory.path / "frame.vtp";
  std::ofstream(ease::temporaryName(file)) << "cut short, and longer than what follows";
  ease::writeWholeFile(file, "whole");
  CHECK(ease::contentOf(file) == "whole");
  CHECK_FALSE(fs::exists(ease::temporaryName(file)));
}

TEST_CASE("a file that cannot be written is an error with its name and the reason, and leaves nothing behind") {
  const ease::TemporaryDirectory directory;
  const fs::path gone = directory.path / "gone" / "frame.vtp", folder = directory.path / "folder";
  CHECK_THROWS_AS(ease::writeWholeFile(gone, "bytes"), ease::ComputationError);
  CHECK_THROWS_WITH(ease::writeWholeFile(gone, "bytes"),
                    "cannot write " + gone.string() + ": No such file or directory");
  fs::create_directory(folder);
  CHECK_THROWS_WITH(ease::writeWholeFile(folder, "bytes"), Contains(folder.string()) && Contains("Is a directory"));
  CHECK_FALSE(fs::exists(ease::temporaryName(folder)));
  CHECK(fs::is_directory(folder));
}
