// The compiler, flags and libraries that a program was built with, to be stored with its results.
#pragma once

#include <string>
#include <vector>

namespace ease {

/// Adds "compiler", "build_type", "flags", "eigen" and "libraries" to the context that Google Benchmark writes.
void describeBuild();

/// Returns the files of the loaded shared libraries whose versions matter for speed.  Symbolic links are resolved,
/// since only the names of the files themselves contain the version.
std::vector<std::string> loadedLibraries();

}  // namespace ease
