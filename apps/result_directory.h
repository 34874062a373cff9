// The directory that a command writes its results into.
#pragma once

#include <filesystem>
#include <vector>

#include "apps/scene.h"

namespace ease {

class ResultDirectory {
 public:
  /// Creates the directory and tests that a file can be written into it, so that a long run does not fail only when it
  /// writes its results.  Throws InputError with the system's reason.
  /// Holds the directory until the end of its life: refuses one that another command holds.
  explicit ResultDirectory(const std::filesystem::path& path);
  /// Removes the directories that the constructor created and that are still empty.
  ~ResultDirectory();
  ResultDirectory(const ResultDirectory&) = delete;
  ResultDirectory& operator=(const ResultDirectory&) = delete;

  /// Throws InputError where the directory holds the results of another scene, naming that.
  void refuseOtherScene(const std::string& scene) const;

  /// Whether the directory holds a run that was stopped and could go on from its checkpoint.
  bool holdsStoppedRun() const;

  /// Removes the files that an earlier command wrote about a garment made by tools and about its pieces, because the
  /// scene may now make another garment.  Removes nothing if the scene reads one of these files.
  void removeOldGarment(const Scene& scene) const;

 private:
  void lock();
  void unlock() const;
  void removeEmpty() const;

  std::filesystem::path path_;
  int lock_ = -1;                            // file descriptor
  std::vector<std::filesystem::path> made_;  // innermost first
};

/// Removes the results of an earlier run, since the next run may not overwrite all of them, and the incomplete files of
/// a run that was killed.  `goes_on`: the next run resumes the earlier one, whose series and checkpoint therefore stay,
/// and whose report and pictures are kept under other names.
void removeOldResults(const std::filesystem::path& directory, bool goes_on);

/// Removes the files of an earlier sewing pattern, whose garment may have been another one.
void removeOldPattern(const std::filesystem::path& directory);

/// Removes the report and pictures that removeOldResults() kept under other names.
void removeEarlierReport(const std::filesystem::path& directory);

}  // namespace ease
