// Text as files of several systems have it.
#pragma once

#include <string>

namespace ease {

/// Turns UTF-16 with a byte order mark into UTF-8, and removes the mark of UTF-8. Other bytes stay as they are.
std::string asUtf8(std::string bytes);

}  // namespace ease
