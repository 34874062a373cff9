// A hash of bytes (FNV-1a, 64 bits), to find out whether data is the same bit for bit.  Changing any single byte
// changes the hash.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ease {

inline std::uint64_t fingerprint(const void* bytes, std::size_t size) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (std::size_t k = 0; k < size; ++k) h = (h ^ static_cast<const unsigned char*>(bytes)[k]) * 0x100000001b3;
  return h;
}

}  // namespace ease
