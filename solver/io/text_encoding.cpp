#include "solver/io/text_encoding.h"

#include <cstdint>

namespace ease {

std::string asUtf8(std::string bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) return bytes.substr(3);
  const bool low_first = bytes.starts_with("\xFF\xFE");
  if (!low_first && !bytes.starts_with("\xFE\xFF")) return bytes;
  std::string text;
  for (std::size_t k = 2; k + 1 < bytes.size(); k += 2) {
    const auto low = static_cast<std::uint8_t>(bytes[k + (low_first ? 0 : 1)]);
    const auto high = static_cast<std::uint8_t>(bytes[k + (low_first ? 1 : 0)]);
    // Meshes are written in ASCII; only names of groups and materials are not, and nobody reads them.
    text += high == 0 && low < 128 ? static_cast<char>(low) : '?';
  }
  return text;
}

}  // namespace ease
