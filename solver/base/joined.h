// Text from words and numbers.
#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace ease {

/// Writes the parts one after the other; numbers with six significant digits as std::ostream does, independent of the
/// locale.
template <class... Parts>
std::string joined(const Parts&... parts) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  (text << ... << parts);
  return std::move(text).str();
}

}  // namespace ease
