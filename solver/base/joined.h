// Text from words and numbers.
#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace ease {

/// The parts written one after the other; numbers as std::ostream writes them, with six significant digits, whatever
/// the locale.
template <class... Parts>
std::string joined(const Parts&... parts) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  (text << ... << parts);
  return std::move(text).str();
}

}  // namespace ease
