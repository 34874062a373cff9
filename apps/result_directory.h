// The directory that a command writes its results into.
#pragma once

#include <filesystem>
#include <vector>

#include "apps/scene.h"

namespace ease {

class ResultDirectory {
 public:
  /// Makes the directory and, for a moment, a file in it, so that a run does not end with nowhere to write to.  Throws
  /// InputError with the system's reason.
  explicit ResultDirectory(const std::filesystem::path& path);
  /// Takes away those of the directories made that are still empty.
  ~ResultDirectory();
  ResultDirectory(const ResultDirectory&) = delete;
  ResultDirectory& operator=(const ResultDirectory&) = delete;

  /// Removes what an earlier command wrote of a garment that tools made, and of its pieces: it may be another garment
  /// than this scene's.  Nothing if the scene reads one of these files.
  void removeOldGarment(const Scene& scene) const;

 private:
  void removeEmpty() const;

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  // innermost first
};

/// Removes the results of an earlier run that the one to come may not write again, and what one that was killed left
/// unfinished.  `goes_on`: with that run; its series and checkpoint stay, and its report and pictures under other
/// names.
void removeOldResults(const std::filesystem::path& directory, bool goes_on);

/// Removes the report and pictures that removeOldResults() kept.
void removeEarlierReport(const std::filesystem::path& directory);

}  // namespace ease
