// The commands of the program, one function each.
#pragma once

#include <atomic>
#include <functional>
#include <string>

namespace ease {

/// kDoubtful: all was computed and written, but the figures do not mean what they say (doubts.h).
enum ExitCode { kDone = 0, kWrongInput = 1, kFailed = 2, kDoubtful = 3, kInterrupted = 130 };

struct Arguments {
  std::string scene;      // `ease pattern`: or the directory of a finished run
  std::string directory;  // empty: results/<name>
  int threads = -1;       // number of threads; 0: all, -1: the scene's number
  std::string resumed;    // directory of an earlier run to resume, or empty
  bool force = false;     // replace the results of another scene
  bool pieces = false;    // `ease garment` also writes the garment cut into pieces
};

/// Prints "ease: KIND: LINE" on stderr; line ends within `line` become spaces.
void say(const char* kind, const std::string& line);

/// Calls `command` and returns its exit code.  Reports an exception as one line on stderr and returns the exit code
/// that belongs to it.
ExitCode guarded(const std::function<ExitCode()>& command);

// Each command tests `interrupted` regularly and ends early if it is true.

ExitCode runCommand(const Arguments& arguments, const std::atomic<bool>& interrupted);
ExitCode checkCommand(const Arguments& arguments, const std::atomic<bool>& interrupted);
ExitCode garmentCommand(const Arguments& arguments, const std::atomic<bool>& interrupted);
ExitCode patternCommand(const Arguments& arguments, const std::atomic<bool>& interrupted);

}  // namespace ease
