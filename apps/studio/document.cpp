#include "apps/studio/document.h"

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

void Document::recover() {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(unsavedFile(file_), ignored)) return;
  const std::string unsaved = contentOf(unsavedFile(file_));
  if (unsaved.empty() || unsaved == text()) return;
  try {
    apply(unsaved, "unsaved work");
    was_recovered_ = true;
  } catch (const InputError&) {  // not from this program; the file itself counts
  }
}

std::filesystem::path Document::unsavedFile(const std::filesystem::path& file) {
  return file.string() + "~";
}

void Document::readAgain() {
  scene_ = readDraft(text(), file_);
  try {
    if (isSaved())
      discardUnsaved();
    else
      writeWholeFile(unsavedFile(file_), text());
  } catch (const std::exception&) {  // a folder that cannot be written to: saving will say so
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
  const std::filesystem::path before = file_;
  writeWholeFile(file, text());
  discardUnsaved();
  file_ = file;
  saved_text_ = text();
  scene_ = readDraft(text(), file_);
}

void Document::discardUnsaved() const {
  std::error_code ignored;
  std::filesystem::remove(unsavedFile(file_), ignored);
}

}  // namespace ease
