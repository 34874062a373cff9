// The text of a scene, edited by lines: what is not edited stays as it is to the byte, comments too.
//
// A section is a table's header, [garment.region] or [[garment.paint]], with the lines up to the next header.  Keys
// before the first header belong to the section "".
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// A key and its value as TOML.
using KeyValue = std::pair<std::string, std::string>;

class SceneText {
 public:
  explicit SceneText(std::string text);

  const std::string& text() const { return text_; }

  /// Number of sections with this path, e.g. "garment.paint".
  int count(const std::string& path) const;
  /// Value of a key of the k-th section with this path as it is written; empty: no such key.
  std::string value(const std::string& path, int k, const std::string& key) const;
  /// All lines of sections whose path is `path` or lies below it.
  std::string sectionsBelow(const std::string& path) const;

  /// Adds an entry [[path]] below the last of its kind.
  void addEntry(const std::string& path, const std::vector<KeyValue>& values);
  /// Removes the k-th entry [[path]], with the tables that belong to it.
  void removeEntry(const std::string& path, int k);
  /// Sets a key of the k-th section with this path, and keeps the comment behind it.  Adds the table [path] if there is
  /// none.
  void setValue(const std::string& path, int k, const std::string& key, const std::string& value);
  /// Removes a key of the k-th section with this path, if it has it.
  void removeValue(const std::string& path, int k, const std::string& key);
  /// Removes every section with this path.
  void removeSections(const std::string& path);

 private:
  /// Lines [first, last) of the text.  The content ends before trailing comments and blank lines.
  struct Section {
    std::string path;
    int first, last, content_end;
  };
  struct Key {
    std::string name;
    int first, last;       // lines
    size_t begin, length;  // of the value, counted from the start of its first line
  };

  void scan();
  void scanKey(int line, int end_line, std::vector<Key>& keys) const;
  const Section* find(const std::string& path, int k) const;
  int lastOf(const std::string& path) const;
  std::vector<Key> keysOf(const Section& section) const;
  void insert(int line, const std::vector<std::string>& lines);
  void erase(int first, int last);

  std::string text_, newline_;
  std::vector<std::string> lines_;  // with their line ends
  std::vector<bool> continues_;     // whether a line lies within a value that began on an earlier one
  std::vector<Section> sections_;
};

/// Values as TOML.  Lengths in m are written to a hundredth of a millimetre.
std::string tomlText(const std::string& text);
std::string tomlNumber(double value);
std::string tomlPoint(const Vec3& point);
std::string tomlPoints(const std::vector<Vec3>& points);

}  // namespace ease
