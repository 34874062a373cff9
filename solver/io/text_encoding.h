// Conversion of text files in UTF-16 or with a byte order mark.
#pragma once

#include <string>

namespace ease {

/// Turns UTF-16 with a byte order mark into text, with '?' for every character that is not ASCII. Removes the mark of
/// UTF-8. Other bytes stay as they are.
std::string asUtf8(std::string bytes);

}  // namespace ease
