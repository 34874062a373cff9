// The command line: `ease run SCENE`, `ease garment SCENE`, `ease check SCENE`.
#pragma once

namespace ease {

/// What main() does: takes over SIGINT and SIGTERM, runs the command and returns its exit code (commands.h).  Whatever
/// goes wrong is one line on stderr.
int commandLine(int argc, char** argv);

}  // namespace ease
