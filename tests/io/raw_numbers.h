// Numbers as binary files hold them.
#pragma once

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>

namespace ease {

/// Appends a number as it is in memory, or from its last byte to its first.
template <class Number>
void append(std::string& bytes, Number value, bool swapped = false) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (swapped) std::reverse(std::begin(raw), std::end(raw));
  bytes.append(raw, sizeof value);
}

}  // namespace ease
