// What the program does, one function a command.
#pragma once

#include <atomic>
#include <functional>
#include <string>

namespace ease {

enum ExitCode { kDone = 0, kWrongInput = 1, kFailed = 2, kInterrupted = 130 };

struct Arguments {
  std::string scene;
  std::string directory;  // empty: results/<name>
  int threads = -1;       // -1: as the scene says
  std::string resumed;    // directory of an earlier run to go on from, or empty
  bool pieces = false;    // of `ease garment`
};

/// Prints "ease: KIND: LINE" on stderr, as one line whatever is in it.
void say(const char* kind, const std::string& line);

/// Calls `command`; whatever goes wrong becomes one line and an exit code.
ExitCode guarded(const std::function<ExitCode()>& command);

// Each looks at `interrupted` now and then and ends early where it is true.

ExitCode runCommand(const Arguments& arguments, const std::atomic<bool>& interrupted);
ExitCode checkCommand(const Arguments& arguments, const std::atomic<bool>& interrupted);
ExitCode garmentCommand(const Arguments& arguments, const std::atomic<bool>& interrupted);

}  // namespace ease
