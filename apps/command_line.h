// The command line: `ease run`, `ease check`, `ease garment` and `ease pattern`.
#pragma once

namespace ease {

/// Parses the command line, handles SIGINT and SIGTERM, runs the command and returns its exit code (commands.h); main()
/// does nothing else.  Every error is reported as one line on stderr.
int commandLine(int argc, char** argv);

}  // namespace ease
