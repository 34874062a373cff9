#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "solver/base/error.h"
#include "solver/io/mesh_readers.h"

namespace ease {
namespace {

enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count_type;  // type of a list's length; empty if the property is a single number
};

struct Element {
  std::string name;
  long long count;
  std::vector<Property> properties;
};

enum class Encoding { kText, kLittleEndian, kBigEndian };

struct Header {
  std::optional<Encoding> encoding;
  std::vector<Element> elements;
};

std::optional<Type> typeNamed(std::string_view word) {
  if (word == "char" || word == "int8") return Type::kInt8;
  if (word == "uchar" || word == "uint8") return Type::kUint8;
  if (word == "short" || word == "int16") return Type::kInt16;
  if (word == "ushort" || word == "uint16") return Type::kUint16;
  if (word == "int" || word == "int32") return Type::kInt32;
  if (word == "uint" || word == "uint32") return Type::kUint32;
  if (word == "float" || word == "float32") return Type::kFloat32;
  if (word == "double" || word == "float64") return Type::kFloat64;
  return std::nullopt;
}

std::optional<Encoding> encodingNamed(std::string_view word) {
  if (word == "ascii") return Encoding::kText;
  if (word == "binary_little_endian") return Encoding::kLittleEndian;
  if (word == "binary_big_endian") return Encoding::kBigEndian;
  return std::nullopt;
}

/// Reads "property type name" or "property list count_type type name" into `header`; returns false if it is neither.
bool readProperty(std::string_view words, Header& header) {
  if (header.elements.empty()) return false;
  Property property{};
  std::string_view type_word = takeWord(words);
  if (type_word == "list") {
    property.count_type = typeNamed(takeWord(words));
    if (!property.count_type) return false;
    type_word = takeWord(words);
  }
  const std::optional<Type> type = typeNamed(type_word);
  if (!type) return false;
  property.type = *type;
  property.name = takeWord(words);
  header.elements.back().properties.push_back(property);
  return !property.name.empty();
}

/// Reads the header and removes it from `bytes`.
Header readHeader(std::string_view& bytes, const std::string& name) {
  std::string_view first = takeLine(bytes);
  if (!isWord(takeWord(first), "ply"))
    throw InputError(fmt::format("{}: not a PLY file: the first line is not \"ply\"", name));
  Header header;
  for (int line_number = 2; !bytes.empty(); ++line_number) {
    const std::string_view line = takeLine(bytes);
    std::string_view words = line;
    const std::string_view keyword = takeWord(words);
    bool understood = true;
    if (keyword == "end_header") {
      if (header.encoding) return header;
      throw InputError(fmt::format("{}: the header has no \"format\"", name));
    }
    if (keyword == "format") {
      header.encoding = encodingNamed(takeWord(words));
      understood = header.encoding.has_value();
    } else if (keyword == "element") {
      const std::string_view element_name = takeWord(words);
      const std::optional<long long> count = parseNumber<long long>(takeWord(words));
      understood = count && *count >= 0;
      if (understood) header.elements.push_back({std::string(element_name), *count, {}});
    } else if (keyword == "property") {
      understood = readProperty(words, header);
    } else {
      understood = keyword == "comment" || keyword == "obj_info" || keyword.empty();
    }
    if (!understood) {
      throw InputError(fmt::format("{}: line {} of the header is not understood: \"{}\"", name, line_number, line));
    }
  }
  throw InputError(fmt::format("{}: the header does not end with \"end_header\"", name));
}

template <class Number>
double takeBinary(std::string_view& bytes, bool swapped) {
  std::array<char, sizeof(Number)> value;
  std::memcpy(value.data(), bytes.data(), value.size());
  bytes.remove_prefix(value.size());
  if (swapped) std::reverse(value.begin(), value.end());
  return static_cast<double>(std::bit_cast<Number>(value));
}

std::size_t sizeOf(Type type) {
  switch (type) {
    case Type::kInt8:
    case Type::kUint8:
      return 1;
    case Type::kInt16:
    case Type::kUint16:
      return 2;
    case Type::kFloat64:
      return 8;
    default:
      return 4;
  }
}

/// Reads the numbers that follow the header, as double, which holds every PLY type exactly.
class Body {
 public:
  Body(std::string_view bytes, Encoding encoding)
      : bytes_(bytes),
        text_(encoding == Encoding::kText),
        swapped_((encoding == Encoding::kBigEndian) != (std::endian::native == std::endian::big)) {}

  bool isText() const { return text_; }
  std::size_t bytesLeft() const { return bytes_.size(); }

  /// Reads the next number; returns nothing at the end of the file or if the text is not a number.
  std::optional<double> take(Type type) {
    if (text_) return parseNumber<double>(takeWord(bytes_));
    if (bytes_.size() < sizeOf(type)) return std::nullopt;
    switch (type) {
      case Type::kInt8:
        return takeBinary<std::int8_t>(bytes_, swapped_);
      case Type::kUint8:
        return takeBinary<std::uint8_t>(bytes_, swapped_);
      case Type::kInt16:
        return takeBinary<std::int16_t>(bytes_, swapped_);
      case Type::kUint16:
        return takeBinary<std::uint16_t>(bytes_, swapped_);
      case Type::kInt32:
        return takeBinary<std::int32_t>(bytes_, swapped_);
      case Type::kUint32:
        return takeBinary<std::uint32_t>(bytes_, swapped_);
      case Type::kFloat32:
        return takeBinary<float>(bytes_, swapped_);
      case Type::kFloat64:
        return takeBinary<double>(bytes_, swapped_);
    }
    return std::nullopt;
  }

 private:
  std::string_view bytes_;
  bool text_;
  bool swapped_;
};

/// Reads the number or the list of numbers of `property` into `values`; returns false if the file ends or has no number
/// there.
bool readValues(Body& body, const Property& property, bool needed, std::vector<double>& values) {
  values.clear();
  double count = 1.0;
  if (property.count_type) {
    const std::optional<double> promised = body.take(*property.count_type);
    if (!promised || !(*promised >= 0.0) || *promised != std::floor(*promised)) return false;
    count = *promised;
  }
  for (double k = 0.0; k < count; ++k) {
    const std::size_t left = body.bytesLeft();
    const std::optional<double> value = body.take(property.type);
    if (!value && (needed || body.bytesLeft() == left || !body.isText())) return false;
    values.push_back(value.value_or(0.0));
  }
  return true;
}

bool isCorners(const Property& p) {
  return p.count_type && (p.name == "vertex_indices" || p.name == "vertex_index");
}

/// Whether the mesh needs the values; others may be anything.
bool isNeeded(const Element& element, const Property& p) {
  if (element.name == "vertex") return !p.count_type && (p.name == "x" || p.name == "y" || p.name == "z");
  return (element.name == "face" || element.name == "tristrips") && isCorners(p);
}

/// Copies a property of one vertex or face to the mesh if the mesh needs it.
void keepValues(const Element& element, const Property& property, const std::vector<double>& values, long long index,
                const std::string& name, RawMesh& mesh) {
  if (element.name == "vertex") {
    mesh.points.back()[property.name[0] - 'x'] = values[0];
  } else {
    const bool strip = element.name == "tristrips";
    if (values.size() < 3 && !strip)
      throw InputError(fmt::format("{}: face {} has {} vertices", name, index, values.size()));
    std::vector<long long> corners(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
      // Text may hold any number in place of an index; only integers of moderate size can be converted.
      const bool is_index = values[k] == std::floor(values[k]) && std::abs(values[k]) < 1e15;
      if (!is_index) throw InputError(fmt::format("{}: face {} has the vertex index {}", name, index, values[k]));
      corners[k] = static_cast<long long>(values[k]);
    }
    if (!strip) return mesh.addPolygon(corners);
    for (auto begin = corners.begin(); begin != corners.end();) {  // -1 ends a strip
      const auto end = std::find(begin, corners.end(), -1);
      mesh.addStrip(std::span(begin, end));
      begin = end == corners.end() ? end : end + 1;
    }
  }
}

void checkHasCoordinates(const Header& header, const std::string& name) {
  for (const Element& element : header.elements) {
    if (element.name != "vertex") continue;
    for (const char* axis : {"x", "y", "z"}) {
      const auto is_axis = [&](const Property& p) { return p.name == axis && !p.count_type; };
      if (std::ranges::none_of(element.properties, is_axis)) {
        throw InputError(fmt::format("{}: the vertices have no \"{}\"", name, axis));
      }
    }
  }
}

}  // namespace

RawMesh readPly(std::string_view bytes, const std::string& name) {
  const Header header = readHeader(bytes, name);
  checkHasCoordinates(header, name);
  Body body(bytes, *header.encoding);
  RawMesh mesh;
  std::vector<double> values;
  for (const Element& element : header.elements) {
    // Every element takes at least one byte. A larger count is wrong and is refused before the elements are read.
    if (element.count > static_cast<long long>(body.bytesLeft())) {
      throw InputError(fmt::format("{}: the header promises {} elements \"{}\", but only {} bytes follow", name,
                                   element.count, element.name, body.bytesLeft()));
    }
    for (long long index = 0; index < element.count; ++index) {
      if (element.name == "vertex") mesh.points.emplace_back();
      for (const Property& property : element.properties) {
        const bool needed = isNeeded(element, property);
        if (!readValues(body, property, needed, values)) {
          throw InputError(fmt::format("{}: {} {} of {}: \"{}\" is not a number, or the file is cut short", name,
                                       element.name, index, element.count, property.name));
        }
        if (needed) keepValues(element, property, values, index, name, mesh);
      }
    }
  }
  return mesh;
}

}  // namespace ease
