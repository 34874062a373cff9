#include "apps/studio/document.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace ease {

namespace {

constexpr const char* kBuiltinScene = R"(# A garment that is being made in Ease Studio.

[body]
builtin = "mannequin"
poses = ["t", "a", "up"]

[garment]
resolution = 3000

[material]
density = 0.15
stretch = [800, 800]
shear = 200
bending = 1e-6
damping = { stretch = 20, shear = 2, bending = 1e-6 }

[collision]
friction = 0.3

[adaption]
limit = 0.08

[output]
every = 4
)";

/// The folder that a file's name is in, also where that is a link to a file elsewhere.
std::filesystem::path folderOf(const std::filesystem::path& file) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(file).lexically_normal().parent_path());
}

/// Name of a file in a scene that lies in `folder`: relative to it where it lies below it.
std::string nameFrom(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const std::filesystem::path full = folderOf(file) / file.filename(), below = full.lexically_relative(folder);
  const bool is_below = !below.empty() && *below.begin() != "..";
  return tomlText(is_below ? below.string() : full.string());
}

void setFiles(SceneText& text, const std::string& table, const std::string& key, const std::string& value) {
  if (text.count(table) == 0)
    throw InputError(fmt::format(
        "the scene writes {0} as an inline table {{ ... }}; write it as a table [{0}] to change its files here",
        table));
  text.setValue(table, 0, key, value);
}

std::string listOf(const std::vector<std::string>& names) {
  return fmt::format("[\n  {},\n]", fmt::join(names, ",\n  "));
}

/// The text of a scene as it must be in another file, for its meshes to be the same files.
std::string movedText(const std::string& text, const std::filesystem::path& from, const std::filesystem::path& to) {
  const std::filesystem::path before = folderOf(from), after = folderOf(to);
  if (before == after) return text;
  const Scene scene = readDraft(text, from);
  SceneText moved(text);
  if (scene.body && scene.body->builtin.empty()) {
    std::vector<std::string> names;
    for (const std::string& pose : scene.body->poses) names.push_back(nameFrom(after, before / pose));
    setFiles(moved, "body", "poses", listOf(names));
  }
  if (!scene.garment.mesh.empty()) setFiles(moved, "garment", "mesh", nameFrom(after, before / scene.garment.mesh));
  return moved.text();
}

/// Name of the k-th new scene in a folder.
std::filesystem::path newFile(const std::filesystem::path& folder, int k) {
  return folder / (k == 1 ? "studio.toml" : fmt::format("studio {}.toml", k));
}

/// What a scene says about the body.
std::string bodyOf(const std::string& text) {
  return SceneText(text).sectionsBelow("body");
}

bool hasItsScans(const Scene& scene) {
  if (!scene.body || !scene.body->builtin.empty()) return true;
  const std::filesystem::path folder = folderOf(scene.file);
  return std::all_of(scene.body->poses.begin(), scene.body->poses.end(),
                     [&](const std::string& pose) { return std::filesystem::exists(folder / pose); });
}

}  // namespace

Document::Document(std::string text, std::filesystem::path file) : file_(std::move(file)), saved_text_(text) {
  history_.push_back({std::move(text), ""});
  scene_ = readDraft(this->text(), file_);
}

Document Document::open(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    if (std::filesystem::is_regular_file(unsavedFile(file), ignored)) return builtin(file);  // a new one, never saved
    readScene(file);                                                                         // says what is wrong
  }
  Document document(contentOf(file), file);
  document.recover();
  return document;
}

Document Document::builtin(const std::filesystem::path& file) {
  Document document(kBuiltinScene, file);
  document.recover();
  return document;
}

Document Document::onScans(const std::vector<std::filesystem::path>& scans, const std::filesystem::path& file) {
  std::vector<std::string> names;
  for (const std::filesystem::path& scan : scans) names.push_back(nameFrom(folderOf(file), scan));
  SceneText text(kBuiltinScene);
  text.removeValue("body", 0, "builtin");
  text.setValue("body", 0, "poses", listOf(names));
  return {text.text(), file};
}

void Document::checkTakesPoses() const {
  const std::optional<BodyScene>& body = scene_.body;
  if (!body || !body->builtin.empty())
    throw InputError("the built-in body has poses of its own; File, New on scans begins a scene on yours");
  const std::string written = SceneText(text()).value("body", 0, "poses");
  for (const std::string& pose : body->poses)
    if (!written.empty() && written.find(pose) == std::string::npos)
      throw InputError("the scene names its poses by a folder or pattern: put the scan there and open the scene again");
}

Document Document::withPoses(const std::vector<std::filesystem::path>& scans) const {
  checkTakesPoses();
  std::vector<std::string> names;
  for (const std::string& pose : scene_.body->poses) names.push_back(tomlText(pose));
  for (const std::filesystem::path& scan : scans) names.push_back(nameFrom(folderOf(file_), scan));
  SceneText text(this->text());
  setFiles(text, "body", "poses", listOf(names));
  Document next(text.text(), file_);
  next.saved_text_ = saved_text_;
  return next;
}

Document Document::withoutUnsaved() const {
  if (std::filesystem::exists(file_)) return open(file_);
  if (!scene_.body || !scene_.body->builtin.empty()) return builtin(file_);
  std::vector<std::filesystem::path> scans;
  for (const std::string& pose : scene_.body->poses) scans.push_back(folderOf(file_) / pose);
  return onScans(scans, file_);
}

Document Document::newOnScans(const std::vector<std::filesystem::path>& scans, const std::filesystem::path& folder) {
  const std::filesystem::path free = freeFile(folder);
  for (int k = 1; newFile(folder, k) != free; ++k) {
    const std::filesystem::path file = newFile(folder, k);
    if (std::filesystem::exists(file)) continue;
    if (bodyOf(contentOf(unsavedFile(file))) == bodyOf(onScans(scans, file).text())) return open(file);
  }
  return onScans(scans, free);
}

std::filesystem::path Document::freeFile(const std::filesystem::path& folder) {
  int k = 1;
  while (std::filesystem::exists(newFile(folder, k)) || std::filesystem::exists(unsavedFile(newFile(folder, k)))) ++k;
  return newFile(folder, k);
}

void Document::recover() {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(unsavedFile(file_), ignored)) return;
  const std::string unsaved = contentOf(unsavedFile(file_));
  if (unsaved.empty() || unsaved == text()) return;
  try {
    if (bodyOf(unsaved) == bodyOf(text())) {
      apply(unsaved, "unsaved work");
    } else {  // the window shows one body: that it was another cannot be undone there
      Scene scene = readDraft(unsaved, file_);
      if (!hasItsScans(scene)) return;  // what was saved can still be opened
      scene_ = std::move(scene);
      history_.front().text = unsaved;
    }
    was_recovered_ = true;
  } catch (const InputError&) {  // not from this program; the file itself counts
  }
}

std::filesystem::path Document::unsavedFile(const std::filesystem::path& file) {
  return file.string() + "~";
}

void Document::readAgain() {
  scene_ = readDraft(text(), file_);
  if (isSaved()) discardUnsaved();
  keepUnsaved();
}

void Document::keepUnsaved() const {
  try {
    if (!isSaved()) writeWholeFile(unsavedFile(file_), text());
  } catch (const std::exception&) {  // saving will say so
  }
}

void Document::apply(const std::string& text, const std::string& gesture) {
  if (text == this->text())
    throw InputError(
        "nothing would change: perhaps the scene writes this part as an inline table { ... }; write it as tables "
        "[[garment...]] to edit it here");
  readDraft(text, file_);
  history_.resize(now_ + 1);
  history_.push_back({text, gesture});
  ++now_;
  readAgain();
}

std::string Document::undo() {
  if (!canUndo()) return "";
  const std::string gesture = history_[now_--].gesture;
  readAgain();
  return gesture;
}

std::string Document::redo() {
  if (!canRedo()) return "";
  const std::string gesture = history_[++now_].gesture;
  readAgain();
  return gesture;
}

void Document::dropLast() {
  if (!canUndo()) return;
  history_.resize(now_--);
  readAgain();
}

void Document::save() {
  writeWholeFile(file_, text());
  saved_text_ = text();
  discardUnsaved();
}

void Document::saveAs(const std::filesystem::path& file) {
  Version present{movedText(text(), file_, file), history_[now_].gesture};
  readDraft(present.text, file);
  std::vector<Version> moved = history_;
  try {
    for (Version& version : moved) version.text = movedText(version.text, file_, file);
  } catch (const InputError&) {  // files are gone that an earlier version names: it cannot be gone back to
    moved = {present};
  }
  writeWholeFile(file, present.text);
  discardUnsaved();
  if (moved.size() < history_.size()) now_ = 0;
  history_ = std::move(moved);
  file_ = file;
  saved_text_ = text();
  scene_ = readDraft(text(), file_);
}

void Document::discardUnsaved() const {
  std::error_code ignored;
  std::filesystem::remove(unsavedFile(file_), ignored);
}

}  // namespace ease
