// Runs the program as a user would, and writes a small scene for it.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <sstream>
#include <string>

#include "tests/apps/temporary_directory.h"

namespace ease {

struct Outcome {
  int code;
  std::string out, err;
};

inline std::string contentOf(const std::filesystem::path& file) {
  std::ostringstream content;
  content << std::ifstream(file).rdbuf();
  return content.str();
}

/// Runs `ease ARGUMENTS` in `directory`.  `launcher` is a command that is put before it and starts it.
inline Outcome runEase(const TemporaryDirectory& directory, const std::string& arguments,
                       const std::string& launcher = "") {
  const std::string in = "cd '" + directory.path.string() + "' && ";
  const int status = std::system((in + launcher + "'" EASE_COMMAND "' >out 2>err " + arguments).c_str());
  REQUIRE(WIFEXITED(status));
  return {WEXITSTATUS(status), contentOf(directory.path / "out"), contentOf(directory.path / "err")};
}

inline Outcome runEase(const std::string& arguments) {
  return runEase(TemporaryDirectory(), arguments);
}

inline bool isOneLine(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') == 1;
}

inline std::filesystem::path writeHangingScene(const TemporaryDirectory& directory, int steps) {
  return directory.write("hang.toml", "solver = {steps = " + std::to_string(steps) +
                                          "}\n[garment]\nmesh = 'cloth.obj'\n[[garment.pin]]\nvertices = [6, 7, 8]\n");
}

/// Writes a scene in which a square of cloth, 2 x 2 x 2 triangles, hangs by its upper edge for `steps` time steps.
inline std::filesystem::path writeHangingCloth(const TemporaryDirectory& directory, int steps) {
  std::string obj;
  for (const char* y : {"1.0", "1.1", "1.2"})
    for (const char* x : {"0.0", "0.1", "0.2"}) obj += std::string("v ") + x + " " + y + " 0\n";
  obj += "f 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\nf 4 5 8\nf 4 8 7\nf 5 6 9\nf 5 9 8\n";
  directory.write("cloth.obj", obj);
  return writeHangingScene(directory, steps);
}

}  // namespace ease
