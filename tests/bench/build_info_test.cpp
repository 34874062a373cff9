#include "bench/build_info.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>

using namespace ease;

TEST_CASE("the libraries that are named are the loaded ones, with their versions") {
  const std::vector<std::string> libraries = loadedLibraries();
  for (const char* name : {"libcholmod.so.", "libbenchmark.so.", "blas"}) {
    CAPTURE(name);
    const auto found = std::find_if(libraries.begin(), libraries.end(),
                                    [&](const std::string& file) { return file.find(name) != std::string::npos; });
    REQUIRE(found != libraries.end());
    CHECK(std::any_of(found->begin(), found->end(), [](unsigned char c) { return std::isdigit(c) != 0; }));
  }
}
