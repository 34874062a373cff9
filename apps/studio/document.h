// The scene that is being edited: its text, with undo, and the file that it is saved to.
//
// Every gesture is a new text, which is read as any scene; one that cannot be read is refused and changes nothing. What
// is not saved yet lies in FILE~, which is read again after a crash.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/scene.h"
#include "apps/studio/scene_text.h"

namespace ease {

class Document {
 public:
  /// Begins with this text.  `file`: what it is saved to, and what its file names are relative to.  Throws InputError
  /// if it is no scene, nor a draft of one.
  Document(std::string text, std::filesystem::path file);
  /// Reads a file; unsaved work that a crash left beside it is a gesture more, which undo drops.
  static Document open(const std::filesystem::path& file);
  /// A new scene on the built-in body without a garment, and unsaved work of it, as open() does.
  static Document builtin(const std::filesystem::path& file);
  /// A new scene on scans of one person, the poses in this order.
  static Document onScans(const std::vector<std::filesystem::path>& scans, const std::filesystem::path& file);
  /// Begins a new scene on scans in a free file of this folder, or takes up the unsaved work on these scans that a
  /// crash left there.
  static Document newOnScans(const std::vector<std::filesystem::path>& scans, const std::filesystem::path& folder);
  /// A file in this folder for a new scene.
  static std::filesystem::path freeFile(const std::filesystem::path& folder);

  const std::string& text() const { return history_[now_].text; }
  const Scene& scene() const { return scene_; }
  const std::filesystem::path& file() const { return file_; }
  bool isSaved() const { return text() == saved_text_; }
  bool wasRecovered() const { return was_recovered_; }

  /// Takes a gesture's text.  Throws InputError if it is no scene; nothing has changed then.
  void apply(const std::string& text, const std::string& gesture);
  bool canUndo() const { return now_ > 0; }
  bool canRedo() const { return now_ + 1 < history_.size(); }
  /// Each returns the name of the gesture that was undone or done again; empty: there was none.
  std::string undo();
  std::string redo();
  /// Takes back the last gesture for good, as if it had been refused.
  void dropLast();

  /// Writes the file whole.  Throws ComputationError if that fails.
  void save();
  /// Writes another file; names of meshes, which are relative to the scene, are changed to hold from there.
  void saveAs(const std::filesystem::path& file);
  /// Throws InputError where no poses can be added: on the built-in body, or where a pattern names them.
  void checkTakesPoses() const;
  /// This scene with further scans as poses after its last one, not saved yet.  Earlier gestures cannot be undone
  /// there.
  Document withPoses(const std::vector<std::filesystem::path>& scans) const;
  /// What was saved last; of a scene that was never saved, a new one on the same scans.
  Document withoutUnsaved() const;
  /// Writes unsaved work beside the file, if there is any; a folder that cannot be written to is no error.
  void keepUnsaved() const;
  /// Forgets the unsaved work beside the file.
  void discardUnsaved() const;

  /// The file beside `file` that keeps unsaved work.
  static std::filesystem::path unsavedFile(const std::filesystem::path& file);

 private:
  struct Version {
    std::string text, gesture;
  };
  void readAgain();
  void recover();

  std::filesystem::path file_;
  std::vector<Version> history_;
  size_t now_ = 0;
  std::string saved_text_;
  bool was_recovered_ = false;
  Scene scene_;
};

}  // namespace ease
