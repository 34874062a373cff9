// Checks numbers in a .vtp file that VTK's reader uses unchecked: counts that determine how much memory it allocates,
// and block sizes by which it divides.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <vector>

#include "solver/base/error.h"
#include "solver/io/mesh_readers.h"

namespace ease {
namespace {

constexpr std::uint64_t kMaxCompression = 4096;  // bytes of content per byte of the file
constexpr std::size_t npos = std::string_view::npos;

/// Value of an attribute in a tag's text; empty if the tag has no such attribute.
std::string_view attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != npos; at = tag.find(name, at + 1)) {
    std::size_t quote = at + name.size();
    if (at == 0 || !std::isspace(static_cast<unsigned char>(tag[at - 1]))) continue;
    while (quote < tag.size() && (tag[quote] == '=' || std::isspace(static_cast<unsigned char>(tag[quote])))) ++quote;
    if (quote >= tag.size() || (tag[quote] != '"' && tag[quote] != '\'')) continue;
    const std::size_t end = tag.find(tag[quote], quote + 1);
    if (end != npos) return tag.substr(quote + 1, end - quote - 1);
  }
  return {};
}

/// Decodes base64 text, at most `count` bytes of it.
std::vector<unsigned char> fromBase64(std::string_view text, std::size_t count) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (bytes.size() >= count || c == '=' || c == '<') break;
    if (digit == npos) continue;
    bits = bits << 6 | static_cast<unsigned>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> held));
  }
  return bytes;
}

class Counts {
 public:
  Counts(std::string_view bytes, const std::string& name)
      : bytes_(bytes), name_(name), most_(kMaxCompression * bytes.size()) {
    const std::string_view file = tagNamed("<VTKFile", 0);
    compressed_ = !attribute(file, "compressor").empty();
    word_ = attribute(file, "header_type") == "UInt64" ? 8 : 4;
    swapped_ = attribute(file, "byte_order") == "BigEndian";
    const std::size_t appended = bytes.find("<AppendedData");
    if (appended == npos) return;
    in_base64_ = attribute(tagNamed("<AppendedData", appended), "encoding") != "raw";
    appended_ = bytes.find('_', appended);
  }

  void check() const {
    for (std::size_t at = bytes_.find("<Piece"); at != npos; at = bytes_.find("<Piece", at + 1))
      for (const char* count : {"NumberOfPoints", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys"})
        expectCount(tagNamed("<Piece", at), count);
    for (std::size_t at = bytes_.find("<DataArray"); at != npos; at = bytes_.find("<DataArray", at + 1)) {
      const std::string_view tag = tagNamed("<DataArray", at), format = attribute(tag, "format");
      for (const char* count : {"NumberOfComponents", "NumberOfTuples", "offset"}) expectCount(tag, count);
      if (!compressed_) continue;
      if (format == "binary") checkBlocks(bytes_.substr(std::min(at + tag.size(), bytes_.size())), true);
      const std::uint64_t offset = number(attribute(tag, "offset"));
      if (format == "appended" && appended_ < bytes_.size() && offset < bytes_.size() - appended_ - 1)
        checkBlocks(bytes_.substr(appended_ + 1 + offset), in_base64_);
    }
  }

 private:
  /// Text of the first tag at or after position `from` that begins with `start`, including its '>'; empty if there is
  /// none.
  std::string_view tagNamed(std::string_view start, std::size_t from) const {
    const std::size_t at = bytes_.find(start, from), end = at == npos ? npos : bytes_.find('>', at);
    return end == npos ? std::string_view() : bytes_.substr(at, end + 1 - at);
  }

  /// Reads a whole number as VTK does. A negative number or one that is too large becomes the largest representable
  /// one.
  static std::uint64_t number(std::string_view text) {
    while (!text.empty() && (std::isspace(static_cast<unsigned char>(text.front())) || text.front() == '+'))
      text.remove_prefix(1);
    std::uint64_t value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return text.starts_with('-') || result.ec == std::errc::result_out_of_range ? UINT64_MAX : value;
  }

  void expectCount(std::string_view tag, const char* what) const {
    const std::string_view text = attribute(tag, what);
    if (number(text) > most_)
      throw InputError(fmt::format("{}: damaged: {} = {} in a file of {} bytes", name_, what, text, bytes_.size()));
  }

  void expectLittle(std::uint64_t count, const char* what) const {
    if (count > most_)
      throw InputError(fmt::format("{}: damaged: {} = {} in a file of {} bytes", name_, what, count, bytes_.size()));
  }

  std::uint64_t wordAt(const std::vector<unsigned char>& bytes, std::size_t k) const {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < word_; ++i) value = value << 8 | bytes[k * word_ + (swapped_ ? i : word_ - 1 - i)];
    return value;
  }

  /// Checks the start of a compressed array, three numbers: the number of blocks, the bytes per block, and the bytes of
  /// the last block, which may be 0.
  void checkBlocks(std::string_view content, bool in_base64) const {
    const std::size_t size = 3 * word_;
    const auto end = content.begin() + static_cast<long>(std::min(size, content.size()));
    const std::vector<unsigned char> header =
        in_base64 ? fromBase64(content, size) : std::vector<unsigned char>(content.begin(), end);
    if (header.size() < size) return;  // VTK itself reports a file that is cut short
    const std::uint64_t blocks = wordAt(header, 0), block = wordAt(header, 1), last = wordAt(header, 2);
    if (blocks > 0 && block == 0) throw InputError(fmt::format("{}: damaged: an array in blocks of 0 bytes", name_));
    expectLittle(blocks, "blocks of an array");
    expectLittle(block, "bytes in a block of an array");
    expectLittle(last, "bytes in the last block of an array");
  }

  std::string_view bytes_;
  const std::string& name_;
  std::uint64_t most_;
  bool compressed_ = false, swapped_ = false, in_base64_ = true;
  std::size_t word_ = 4, appended_ = npos;
};

}  // namespace

void checkVtpCounts(std::string_view bytes, const std::string& name) {
  Counts(bytes, name).check();
}

}  // namespace ease
