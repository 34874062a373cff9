// Time series of a mesh for ParaView: compressed binary .vtp frames and a .pvd that lists them with their times.
//
// A separate thread writes the frames.  Every file gets its final name only when it is complete, and the .pvd is
// rewritten after every frame, so the series of an interrupted run can be opened.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "solver/mesh/triangle_mesh.h"
#include "viz/vtp.h"

namespace ease {

/// Removes the .pvd file and the frames of a series in `directory`, incomplete files included.  Throws
/// ComputationError.
void removeSeries(const std::filesystem::path& directory, const std::string& name);

class Series {
 public:
  /// Starts a series: frames go to DIR/NAME/NAME_000000.vtp, ..., their list to DIR/NAME.pvd.  NAME may have letters,
  /// digits, '-' and '_'.  Creates the directories.  Frames of an earlier series of this name are kept up to the time
  /// `keep_until` (s) and removed after it; with the default, all are removed.  Throws ComputationError naming what
  /// could not be created or removed.
  Series(const std::filesystem::path& directory, const std::string& name, const Triangles& triangles,
         double keep_until = -1.0);
  ~Series();  // writes the frames that are queued; call finish() before to learn about errors

  /// Queues a frame; waits while the queue is full.  Throws ComputationError, naming the file and the reason, if an
  /// earlier frame could not be written; no frame after that one is written.
  void write(double time_s, Frame frame);

  /// Waits until all frames are on disk; throws like write().
  void finish();

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace ease
