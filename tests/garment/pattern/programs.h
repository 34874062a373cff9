// Programs of others that check what Ease writes, where they are installed.
#pragma once

#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "garment/pattern/sheet.h"

namespace ease {

/// What a command prints, and its exit code.
struct Ran {
  int code;
  std::string output;
};

inline Ran run(const std::string& command) {
  Ran ran{-1, {}};
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return ran;
  std::array<char, 4096> buffer;
  for (size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) ran.output.append(buffer.data(), n);
  ran.code = pclose(pipe);
  return ran;
}

inline bool hasProgram(const std::string& name) {
  return run("command -v " + name).code == 0;
}

/// A file of this text that is removed again.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : path_(std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_" + name)) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// A piece of 200 mm x 300 mm with an allowance of 10 mm, a notch, grain and words that need escaping.
inline DrawnPiece plainPiece(const std::string& name, double width = 200.0, double height = 300.0) {
  DrawnPiece piece;
  piece.name = name;
  piece.number = piece.count = 1;
  piece.sew = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  piece.cut = {{-10, -10}, {width + 10, -10}, {width + 10, height + 10}, {-10, height + 10}};
  piece.notches = {{{width + 10, 0.5 * height}, {-1, 0}, 5.0}};
  piece.lines = {{Ink::grain, {{20, 20}, {20, 120}}, false}};
  piece.texts = {{{0.5 * width, 0.5 * height}, 7.0, 0.0, name}};
  return piece;
}

}  // namespace ease
