#include "bench/build_info.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <set>

namespace ease {

std::vector<std::string> loadedLibraries() {
  const char* const wanted[] = {
      "libcholmod", "libsuitesparseconfig", "libopenblas",      "libblas",      "libmkl", "libblis",
      "libtbb.",    "libopenvdb",           "libvtkCommonCore", "libbenchmark", "libgomp"};
  std::set<std::string> found;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const size_t path = line.find('/');
    if (path == std::string::npos) continue;
    const std::string name = std::filesystem::path(line.substr(path)).filename().string();
    for (const char* prefix : wanted)
      if (name.starts_with(prefix)) found.insert(name);
  }
  return {found.begin(), found.end()};
}

void describeBuild() {
  benchmark::AddCustomContext("compiler", EASE_COMPILER);
  benchmark::AddCustomContext("build_type", EASE_BUILD_TYPE);
  benchmark::AddCustomContext("flags", EASE_FLAGS);
  benchmark::AddCustomContext("eigen",
                              fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
  benchmark::AddCustomContext("libraries", fmt::format("{}", fmt::join(loadedLibraries(), " ")));
}

}  // namespace ease
