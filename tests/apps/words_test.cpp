#include "apps/words.h"

#include <catch2/catch.hpp>

using namespace ease;

TEST_CASE("a list of words reads as English") {
  CHECK(listWords({}) == "");
  CHECK(listWords({"a"}) == "'a'");
  CHECK(listWords({"a", "b"}) == "'a' or 'b'");
  CHECK(listWords({"a", "b", "c"}) == "'a', 'b' or 'c'");
}

TEST_CASE("one thing is counted without an s") {
  CHECK(counted(0, "dart") == "0 darts");
  CHECK(counted(1, "dart") == "1 dart");
  CHECK(counted(2, "piece") == "2 pieces");
  CHECK(counted(3, "vertex") == "3 vertices");
}

TEST_CASE("a slip of the keyboard finds the word that was meant") {
  const std::vector<std::string> words = {"density", "stretch", "shear", "steps_per_pose"};
  CHECK(nearestWord("densty", words) == "density");    // a letter is missing
  CHECK(nearestWord("strretch", words) == "stretch");  // one too many
  CHECK(nearestWord("sheer", words) == "shear");       // a wrong one
  CHECK(nearestWord("shera", words) == "shear");       // two are swapped
  CHECK(nearestWord("steps_per_step", words) == "steps_per_pose");
}

TEST_CASE("advice names the word that was meant, or all that there are") {
  CHECK(adviceFor("hemm", {"hem", "neck"}, "there are") == "did you mean 'hem'?");
  CHECK(adviceFor("cuff", {"hem", "neck"}, "there are") == "there are 'hem' or 'neck'");
}

TEST_CASE("a word like none of the known ones has no nearest word") {
  CHECK(nearestWord("colour", {"density", "stretch", "shear"}) == "");
  CHECK(nearestWord("x", {"to", "up"}) == "");
  CHECK(nearestWord("", {"to"}) == "");
}
