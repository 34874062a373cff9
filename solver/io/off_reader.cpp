#include <fmt/format.h>

#include "solver/base/error.h"
#include "solver/io/mesh_readers.h"

namespace ease {
namespace {

/// Reads a text word by word and counts its lines for messages. Comments, from # to the end of the line, are skipped.
class Words {
 public:
  Words(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// Next word of this line or, if `further` is set and the line has no more, of a later line; empty if there is none.
  std::string_view take(bool further) {
    std::string_view word = takeWord(line_);
    while (word.empty() && further && !text_.empty()) {
      nextLine();
      word = takeWord(line_);
    }
    return word;
  }

  template <class Number>
  Number number(const char* what, std::string_view word) const {
    const std::optional<Number> value = parseNumber<Number>(word);
    if (!value)
      throw InputError(fmt::format("{}: line {}: expected {}, found \"{}\"{}", name_, line_number_, what, word,
                                   word.empty() ? ": the file is cut short" : ""));
    return *value;
  }

  void nextLine() {
    line_ = takeLine(text_);
    line_ = line_.substr(0, line_.find('#'));
    ++line_number_;
  }

  std::size_t bytesLeft() const { return text_.size(); }
  int lineNumber() const { return line_number_; }

 private:
  std::string_view text_, line_;
  const std::string& name_;
  int line_number_ = 0;
};

}  // namespace

RawMesh readOff(std::string_view bytes, const std::string& name) {
  Words words(bytes, name);
  std::string_view kind = words.take(true);
  // Normals, colours and textures follow the coordinates of a vertex in its line and are left out.
  while (!kind.empty() && !isWord(kind, "off") && std::string_view("CNScns").find(kind.front()) != kind.npos)
    kind.remove_prefix(isWord(kind.substr(0, 2), "st") ? 2 : 1);
  if (!isWord(kind, "off"))
    throw InputError(fmt::format("{}: not an OFF file in three dimensions: the first word is not \"OFF\"", name));
  std::string_view word = words.take(true);
  if (isWord(word, "binary"))
    throw InputError(fmt::format("{}: is a binary OFF file; expected text: save it as text or as PLY", name));
  const auto vertices = words.number<long long>("the number of vertices", word);
  const auto faces = words.number<long long>("the number of faces", words.take(true));
  const long long most = static_cast<long long>(words.bytesLeft());
  if (vertices < 0 || faces < 0 || vertices > most || faces > most)
    throw InputError(
        fmt::format("{}: promises {} vertices and {} faces, but only {} bytes follow", name, vertices, faces, most));
  RawMesh mesh;
  for (long long v = 0; v < vertices; ++v) {
    words.nextLine();
    std::array<double, 3> point{};
    for (int k = 0; k < 3; ++k) point[k] = words.number<double>("a coordinate", words.take(k == 0));
    mesh.points.push_back(point);
  }
  std::vector<long long> corners;
  for (long long f = 0; f < faces; ++f) {
    words.nextLine();
    const auto count = words.number<long long>("a face's number of corners", words.take(true));
    if (count < 3)
      throw InputError(fmt::format("{}: line {}: a face with {} vertices", name, words.lineNumber(), count));
    corners.clear();
    for (long long k = 0; k < count; ++k) corners.push_back(words.number<long long>("a vertex", words.take(false)));
    mesh.addPolygon(corners);
  }
  return mesh;
}

}  // namespace ease
