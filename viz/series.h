// Time series of a mesh for ParaView: compressed binary .vtp frames and a .pvd that lists them with their times.
//
// Frames are written by a thread of their own.  Every file appears under its final name only when it is whole, and the
// .pvd is renewed after every frame, so that a run cut short leaves a series that opens.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "solver/mesh/triangle_mesh.h"
#include "viz/vtp.h"

namespace ease {

/// Removes the list and the frames of a series in `directory`, also those not whole.  Throws ComputationError.
void removeSeries(const std::filesystem::path& directory, const std::string& name);

class Series {
 public:
  /// Frames go to DIR/NAME/NAME_000000.vtp, ..., their list to DIR/NAME.pvd; NAME is letters, digits, '-' and '_'.
  /// Makes the directories and removes an earlier series of that name, or goes on with it: its frames up to
  /// `keep_until` (s) stay.  Throws ComputationError naming what could not be made or removed.
  Series(const std::filesystem::path& directory, const std::string& name, const Triangles& triangles,
         double keep_until = -1.0);
  ~Series();  // finishes; errors are lost: call finish() to see them

  /// Queues a frame (waits while several are under way).  Throws ComputationError, naming the file and the reason, if
  /// an earlier frame could not be written; the frames after that one are not written.
  void write(double time_s, Frame frame);

  /// Waits until all frames are on disk; throws as write().
  void finish();

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace ease
