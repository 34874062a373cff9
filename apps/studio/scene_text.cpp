#include "apps/studio/scene_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace ease {

namespace {

/// Follows brackets, strings and comments of TOML through a text, character by character.
class Scanner {
 public:
  /// Reads the character at `i`, and perhaps more that belong to it; returns the index of the next one.
  size_t next(const std::string& s, size_t i) {
    if (!quote_.empty()) {
      if (quote_[0] == '"' && s[i] == '\\') return i + 2;
      if (s.compare(i, quote_.size(), quote_) == 0) {
        const size_t end = i + quote_.size();
        quote_.clear();
        return end;
      }
      if (s[i] == '\n' && quote_.size() == 1) quote_.clear();  // not TOML; the reader will say so
      return i + 1;
    }
    if (s[i] == '\n') in_comment_ = false;
    if (in_comment_) return i + 1;
    if (s[i] == '#') in_comment_ = true;
    if (s[i] == '[' || s[i] == '{') ++depth_;
    if (s[i] == ']' || s[i] == '}') --depth_;
    if (s[i] != '"' && s[i] != '\'') return i + 1;
    const std::string three(3, s[i]);
    quote_ = s.compare(i, 3, three) == 0 ? three : std::string(1, s[i]);
    return i + quote_.size();
  }

  bool inside() const { return depth_ > 0 || !quote_.empty(); }
  bool inComment() const { return in_comment_; }

 private:
  std::string quote_;
  int depth_ = 0;
  bool in_comment_ = false;
};

bool isBlankOrComment(const std::string& line) {
  const size_t first = line.find_first_not_of(" \t\r\n");
  return first == std::string::npos || line[first] == '#';
}

/// The path in a header line, "garment.paint" of "[[ garment . paint ]]  # ...".
std::string pathIn(const std::string& line) {
  std::string path;
  const size_t begin = line.find('[');
  for (size_t i = begin; i < line.size() && line[i] != '#'; ++i) {
    if (line[i] == ']') break;
    if (std::string("[ \t\"'").find(line[i]) == std::string::npos) path += line[i];
  }
  return path;
}

bool isBelow(const std::string& path, const std::string& above) {
  return path.size() > above.size() && path.compare(0, above.size(), above) == 0 && path[above.size()] == '.';
}

}  // namespace

SceneText::SceneText(std::string text) : text_(std::move(text)) {
  newline_ = text_.find("\r\n") != std::string::npos ? "\r\n" : "\n";
  scan();
}

void SceneText::scan() {
  lines_.clear();
  continues_.clear();
  sections_ = {{"", 0, 0, 0}};
  Scanner scanner;
  for (size_t i = 0; i < text_.size();) {
    const bool continues = scanner.inside();
    const size_t end = std::min(text_.find('\n', i), text_.size() - 1) + 1;
    const std::string line = text_.substr(i, end - i);
    while (i < end) i = scanner.next(text_, i);
    i = end;
    const int number = static_cast<int>(lines_.size());
    const size_t first = line.find_first_not_of(" \t");
    if (!continues && first != std::string::npos && line[first] == '[')
      sections_.push_back({pathIn(line), number, number, number + 1});
    lines_.push_back(line);
    continues_.push_back(continues);
    sections_.back().last = number + 1;
    if (continues || !isBlankOrComment(line)) sections_.back().content_end = number + 1;
  }
}

const SceneText::Section* SceneText::find(const std::string& path, int k) const {
  for (const Section& section : sections_)
    if (section.path == path && k-- == 0) return &section;
  return nullptr;
}

int SceneText::count(const std::string& path) const {
  const auto has_path = [&](const Section& section) { return section.path == path; };
  return static_cast<int>(std::count_if(sections_.begin(), sections_.end(), has_path));
}

std::vector<SceneText::Key> SceneText::keysOf(const Section& section) const {
  std::vector<Key> keys;
  for (int line = section.first; line < section.content_end; ++line) {
    if (continues_[line] || isBlankOrComment(lines_[line])) continue;
    const size_t first = lines_[line].find_first_not_of(" \t");
    if (lines_[line][first] == '[') continue;
    int end = line + 1;
    while (end < section.content_end && continues_[end]) ++end;
    scanKey(line, end, keys);
  }
  return keys;
}

/// Reads the key whose value lies on the lines [line, end_line).
void SceneText::scanKey(int line, int end_line, std::vector<Key>& keys) const {
  std::string all;
  for (int k = line; k < end_line; ++k) all += lines_[k];
  const size_t equals = all.find('=');
  if (equals == std::string::npos) return;
  std::string name;
  for (const char c : all.substr(0, equals))
    if (std::string(" \t\"'").find(c) == std::string::npos) name += c;
  Scanner scanner;
  size_t end = equals + 1;  // behind the last character of the value
  for (size_t i = equals + 1; i < all.size();) {
    const size_t next = scanner.next(all, i);
    if (scanner.inComment()) {
      if (!scanner.inside()) break;
    } else if (std::string(" \t\r\n").find(all[i]) == std::string::npos) {
      end = std::min(next, all.size());
    }
    i = next;
  }
  const size_t begin = std::min(all.find_first_not_of(" \t", equals + 1), end);
  keys.push_back({name, line, end_line, begin, end - begin});
}

std::string SceneText::value(const std::string& path, int k, const std::string& key) const {
  const Section* section = find(path, k);
  if (!section) return "";
  for (const Key& entry : keysOf(*section)) {
    if (entry.name != key) continue;
    std::string all;
    for (int line = entry.first; line < entry.last; ++line) all += lines_[line];
    return all.substr(entry.begin, entry.length);
  }
  return "";
}

std::string SceneText::sectionsBelow(const std::string& path) const {
  std::string text;
  for (const Section& section : sections_)
    if (section.path == path || isBelow(section.path, path))
      for (int line = section.first; line < section.content_end; ++line) text += lines_[line];
  return text;
}

/// Number of the last section with this path or below it; -1 if there is none.
int SceneText::lastOf(const std::string& path) const {
  for (int s = static_cast<int>(sections_.size()) - 1; s >= 0; --s)
    if (sections_[s].path == path || isBelow(sections_[s].path, path)) return s;
  return -1;
}

void SceneText::insert(int line, const std::vector<std::string>& lines) {
  std::string text;
  for (int k = 0; k < line; ++k) text += lines_[k];
  if (!text.empty() && text.back() != '\n') text += newline_;
  for (const std::string& added : lines) text += added + newline_;
  for (size_t k = line; k < lines_.size(); ++k) text += lines_[k];
  text_ = text;
  scan();
}

void SceneText::erase(int first, int last) {
  std::string text;
  for (int k = 0; k < static_cast<int>(lines_.size()); ++k)
    if (k < first || k >= last) text += lines_[k];
  text_ = text;
  scan();
}

void SceneText::addEntry(const std::string& path, const std::vector<KeyValue>& values) {
  int after = lastOf(path);
  if (after < 0) after = lastOf(path.substr(0, path.find('.')));
  const int line = after < 0 ? static_cast<int>(lines_.size()) : sections_[after].content_end;
  std::vector<std::string> lines = {"", "[[" + path + "]]"};
  if (line == 0) lines.erase(lines.begin());
  for (const auto& [key, value] : values) lines.push_back(key + " = " + value);
  insert(line, lines);
}

void SceneText::removeEntry(const std::string& path, int k) {
  const Section* section = find(path, k);
  if (!section) return;
  int first = section->first, last = section->content_end;
  for (const Section* next = section + 1; next < sections_.data() + sections_.size() && isBelow(next->path, path);
       ++next)
    last = next->content_end;
  const auto isBlank = [&](int line) { return lines_[line].find_first_not_of(" \t\r\n") == std::string::npos; };
  if (first > 0 && isBlank(first - 1)) --first;
  erase(first, last);
}

void SceneText::removeSections(const std::string& path) {
  while (count(path) > 0) removeEntry(path, 0);
}

void SceneText::setValue(const std::string& path, int k, const std::string& key, const std::string& value) {
  const Section* section = find(path, k);
  if (!section) {
    const int after = lastOf(path.substr(0, path.find('.')));
    const int line = after < 0 ? static_cast<int>(lines_.size()) : sections_[after].content_end;
    std::vector<std::string> lines = {"", "[" + path + "]", key + " = " + value};
    if (line == 0) lines.erase(lines.begin());
    insert(line, lines);
    return;
  }
  for (const Key& entry : keysOf(*section)) {
    if (entry.name != key) continue;
    std::string all;
    for (int line = entry.first; line < entry.last; ++line) all += lines_[line];
    const std::string before = all.substr(0, entry.begin), behind = all.substr(entry.begin + entry.length);
    std::string changed = before + value;
    // A comment behind the value stays in its column if there is room.
    const size_t gap = behind.find_first_not_of(' ');
    if (gap != std::string::npos && gap > 0 && behind[gap] == '#') {
      const size_t column = entry.begin + entry.length + gap;
      changed += std::string(changed.size() < column ? column - changed.size() : 1, ' ') + behind.substr(gap);
    } else {
      changed += behind;
    }
    std::string text;
    for (int line = 0; line < entry.first; ++line) text += lines_[line];
    text += changed;
    for (size_t line = entry.last; line < lines_.size(); ++line) text += lines_[line];
    text_ = text;
    scan();
    return;
  }
  insert(section->content_end, {key + " = " + value});
}

void SceneText::removeValue(const std::string& path, int k, const std::string& key) {
  const Section* section = find(path, k);
  if (!section) return;
  for (const Key& entry : keysOf(*section))
    if (entry.name == key) return erase(entry.first, entry.last);
}

std::string tomlText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (static_cast<unsigned char>(c) >= ' ') quoted += c;
  }
  return quoted + "\"";
}

std::string tomlNumber(double value) {
  std::string text = fmt::format("{:.5f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text += '0';
  return text == "-0.0" ? "0.0" : text;
}

std::string tomlPoint(const Vec3& point) {
  return fmt::format("[{}, {}, {}]", tomlNumber(point.x()), tomlNumber(point.y()), tomlNumber(point.z()));
}

std::string tomlPoints(const std::vector<Vec3>& points) {
  std::string text;
  for (const Vec3& point : points) text += (text.empty() ? "" : ", ") + tomlPoint(point);
  return "[" + text + "]";
}

}  // namespace ease
