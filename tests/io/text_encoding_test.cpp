#include "solver/io/text_encoding.h"

#include <catch2/catch.hpp>

using ease::asUtf8;

TEST_CASE("plain bytes stay as they are, and the mark of UTF-8 goes") {
  CHECK(asUtf8("v 1 2 3\n") == "v 1 2 3\n");
  CHECK(asUtf8("\xEF\xBB\xBFv 1") == "v 1");
  CHECK(asUtf8("").empty());
}

TEST_CASE("UTF-16 of either byte order becomes plain text, letters beyond ASCII become question marks") {
  const std::string low_first("\xFF\xFEv\0 \0\x31\0", 8), high_first("\xFE\xFF\0v\0 \0\x31", 8);
  CHECK(asUtf8(low_first) == "v 1");
  CHECK(asUtf8(high_first) == "v 1");
  CHECK(asUtf8(std::string("\xFF\xFEg\0\xE9\0\xAC\x20", 8)) == "g??");
}

TEST_CASE("half a letter at the end of a file is left out") {
  CHECK(asUtf8(std::string("\xFF\xFEv\0w", 5)) == "v");
}
