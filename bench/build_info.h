// What a program was built from, for its results: compiler, flags and libraries.
#pragma once

#include <string>
#include <vector>

namespace ease {

/// Adds "compiler", "build_type", "flags", "eigen" and "libraries" to what Google Benchmark writes about the machine.
void describeBuild();

/// Files of the shared libraries that this process has loaded and whose versions matter for its speed: the files' own
/// names, which have the versions, not those that they are linked by.
std::vector<std::string> loadedLibraries();

}  // namespace ease
