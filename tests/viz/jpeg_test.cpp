#include "viz/jpeg.h"

#include <catch2/catch.hpp>

using Catch::Matchers::StartsWith;

TEST_CASE("bytes become a data URI in base64") {
  CHECK(ease::dataUri("Man", "text/plain") == "data:text/plain;base64,TWFu");
  CHECK(ease::dataUri("Ma", "text/plain") == "data:text/plain;base64,TWE=");
  CHECK(ease::dataUri("", "text/plain") == "data:text/plain;base64,");
}

TEST_CASE("a picture becomes a JPEG in a data URI, smaller at lower quality") {
  ease::Picture picture{{64, 48}, {}};
  for (int i = 0; i < 64 * 48; ++i)
    for (const int value : {i % 256, (7 * i) % 256, (i / 64) % 256, 255})
      picture.pixels.push_back(static_cast<unsigned char>(value));
  const std::string fine = ease::jpegDataUri(picture, 95), rough = ease::jpegDataUri(picture, 20);
  CHECK_THAT(fine, StartsWith("data:image/jpeg;base64,/9j/"));
  CHECK(rough.size() < fine.size());
}
