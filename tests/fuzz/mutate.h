// Small damages to a file's bytes, the same for the same random numbers: what a slip of the keyboard, a full disk, a
// wrong program or malice make of an input.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace ease {

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  /// One or two damages, of one half of the seeds such that leave a number a number.
  std::string damaged(std::string bytes) {
    const bool mild = upTo(2) == 0;
    for (int count = upTo(2) + 1; count > 0; --count) {
      const size_t at = upTo(bytes.size());
      if (mild)
        scaleNumber(bytes, at);
      else
        damage(bytes, at);
    }
    return bytes;
  }

 private:
  int upTo(size_t end) { return static_cast<int>(random_() % std::max<size_t>(end, 1)); }

  void damage(std::string& bytes, size_t at) {
    static const std::vector<std::string> numbers = {
        "0",   "-1",         "1e308", "-1e308", "nan", "inf", "1e-320", "99999999999999999999",
        "0.5", "2147483648", "1",     "''",     "[]"};
    static const std::vector<std::string> tokens = {
        "[",        "]",           "=", "\"", "'", "\n", "{", "}", "#", ",", "[[garment.pin]]\n", std::string(1, '\0'),
        "\xff\xfe", "steps = 3\n", "<", "/>", "&"};
    const size_t length = 1 + upTo(12);
    switch (upTo(9)) {
      case 0:
        bytes.erase(at, length);
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.insert(at, bytes.substr(upTo(bytes.size()), length));
        break;
      case 3:
        bytes.insert(at, tokens[upTo(tokens.size())]);
        break;
      case 4:
        if (!bytes.empty()) bytes[at] = static_cast<char>(random_());
        break;
      case 5:
        overwrite(bytes, at);
        break;
      default:
        replaceNumber(bytes, at, numbers[upTo(numbers.size())]);
    }
  }

  /// Four bytes of a binary file: an extreme count, index or number.
  void overwrite(std::string& bytes, size_t at) {
    static const std::vector<std::uint32_t> words = {0,          1,          0x7fffffff, 0x80000000, 0xffffffff,
                                                     0x7f800000, 0x7fc00000, 0x7f7fffff, 0x00000001, 0x0000ffff};
    const std::uint32_t word = words[upTo(words.size())];
    if (at + sizeof word <= bytes.size()) std::memcpy(&bytes[at], &word, sizeof word);
  }

  struct Span {
    size_t begin, length;
  };

  /// The first number from `at` on, without its sign.
  static Span numberFrom(const std::string& bytes, size_t at) {
    const auto isDigit = [&](size_t k) { return std::isdigit(static_cast<unsigned char>(bytes[k])) != 0; };
    while (at < bytes.size() && !isDigit(at)) ++at;
    size_t end = at;
    while (end < bytes.size() && (isDigit(end) || bytes[end] == '.')) ++end;
    return {at, end - at};
  }

  static void replaceNumber(std::string& bytes, size_t at, const std::string& by) {
    const Span number = numberFrom(bytes, at);
    bytes.replace(number.begin, number.length, by);
  }

  void scaleNumber(std::string& bytes, size_t at) {
    static const std::vector<double> factors = {-1.0, 0.0, 0.1, 0.5, 0.9, 1.1, 1.5, 2.0, 5.0, 10.0, 100.0};
    const Span number = numberFrom(bytes, at);
    const std::string before = bytes.substr(number.begin, number.length);
    std::ostringstream scaled;
    scaled << factors[upTo(factors.size())] * std::strtod(before.c_str(), nullptr);
    bytes.replace(number.begin, number.length, scaled.str());
  }

  std::mt19937 random_;
};

}  // namespace ease
