#include "apps/toml_values.h"

#include <catch2/catch.hpp>

using namespace ease;

namespace {

const toml::table kTable = toml::parse("whole = 3\nfraction = 2.0\ntext = 'a'\nlist = [1, 2.5]\nyes = true\n");

std::string textOf(const char* key) {
  return valueText(*kTable.get(key));
}

}  // namespace

TEST_CASE("a value is told as TOML, a fraction with its point, a long one shortened") {
  CHECK(textOf("whole") == "3");
  CHECK(textOf("fraction") == "2.0");
  CHECK(textOf("list") == "[1, 2.5]");
  const toml::table long_one = toml::parse("text = '" + std::string(200, 'x') + "'");
  CHECK(valueText(*long_one.get("text")).size() < 70);
  CHECK(typeText(*kTable.get("whole")) == "a whole number");
  CHECK(typeText(*kTable.get("yes")) == "true or false");
}

TEST_CASE("a number is taken within its range alone, with its unit in words") {
  const Range above{0.0, 2.0, true, "m"};
  CHECK(rangeText(above) == "a number above 0 and at most 2 m");
  CHECK(numberIn(*kTable.get("fraction"), above) == 2.0);
  CHECK_FALSE(numberIn(*kTable.get("whole"), above));
  CHECK_FALSE(numberIn(*kTable.get("text"), above));
  CHECK(integerIn(*kTable.get("whole"), 0, 3) == 3);
  CHECK_FALSE(integerIn(*kTable.get("whole"), 0, 2));
  CHECK_FALSE(integerIn(*kTable.get("fraction"), 0, 3));
}

TEST_CASE("the entry of an array that is wrong is named") {
  std::string fault;
  const auto read = [](const toml::node& entry) { return integerIn(entry, 0, 9); };
  readArray<int>(*kTable.get("list"), read, fault);
  CHECK(fault == "entry 2 is 2.5");
  readArray<int>(*kTable.get("text"), read, fault);
  CHECK(fault == "found a string");
}
