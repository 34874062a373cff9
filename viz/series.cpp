#include "viz/series.h"

#include <fmt/format.h>

#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <exception>
#include <fstream>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace ease {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestQueue = 4;  // frames; 10 MB for a mesh of 100,000 vertices

struct TimedFrame {
  double time;  // s
  Frame frame;
};

[[noreturn]] void fail(std::string_view what, const fs::path& path, const std::error_code& error) {
  throw ComputationError(fmt::format("cannot {} {}: {}", what, path.string(), error.message()));
}

void makeDirectory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) fail("make directory", directory, error);
  if (!fs::is_directory(directory, error)) {
    fail("make directory", directory, std::make_error_code(std::errc::not_a_directory));
  }
}

void removeFile(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) fail("remove", file, error);
}

/// Whether a file name is that of a frame, NAME_DIGITS.vtp, or of an incomplete frame.  Other files in the directory
/// are not the series' and stay.
bool isFrame(const std::string& file, const std::string& name) {
  const std::string start = name + "_";
  if (file.compare(0, start.size(), start) != 0) return false;
  const std::size_t end = file.find_first_not_of("0123456789", start.size());
  if (end == start.size() || end == std::string::npos) return false;
  const fs::path extension = file.substr(end);
  return extension == ".vtp" || extension == temporaryName(".vtp");
}

/// Removes all frames except those named in `listed`, lines of a .pvd file.
void removeFrames(const fs::path& directory, const std::string& name, const std::string& listed) {
  std::error_code error;
  std::vector<fs::path> frames_found;
  for (fs::directory_iterator entry(directory / name, error), end; !error && entry != end; entry.increment(error)) {
    const std::string file = entry->path().filename().string();
    const bool kept = listed.find("/" + file + "\"") != std::string::npos;
    if (isFrame(file, name) && !kept) frames_found.push_back(entry->path());
  }
  if (error) fail("read directory", directory / name, error);
  for (const fs::path& file : frames_found) removeFile(file);
}

}  // namespace

void removeSeries(const fs::path& directory, const std::string& name) {
  removeFile(directory / (name + ".pvd"));
  removeFile(temporaryName(directory / (name + ".pvd")));
  if (!fs::is_directory(directory / name)) return;
  removeFrames(directory, name, "");
  std::error_code not_empty;
  fs::remove(directory / name, not_empty);
}

struct Series::Data {
  fs::path directory;
  std::string name;
  Triangles triangles;

  std::mutex mutex;  // guards the next four members
  std::condition_variable changed;
  std::deque<TimedFrame> queue;  // its front is the frame being written
  std::string failure;           // message of the first error, or empty
  bool ended = false;

  std::string listed;  // lines of the .pvd; only the writing thread uses it
  int frames = 0;
  std::thread writer;

  fs::path list() const { return directory / (name + ".pvd"); }
  void keepUntil(double time_s);
  void removeEarlier() const;
  void writeList() const;
  void writeFrame(const TimedFrame& next);
  void writeFrames();
};

/// Reads the existing list up to `time_s` and rewrites it without the later frames.
void Series::Data::keepUntil(double time_s) {
  std::ifstream in(list());
  for (std::string line; std::getline(in, line);) {
    const std::string key = "timestep=\"";
    const std::size_t at = line.find(key);
    if (at == std::string::npos) continue;
    if (std::strtod(line.c_str() + at + key.size(), nullptr) > time_s) break;
    listed += line + '\n';
    ++frames;
  }
  if (frames > 0) writeList();
}

void Series::Data::writeList() const {
  writeWholeFile(list(), fmt::format("<?xml version=\"1.0\"?>\n"
                                     "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                                     "  <Collection>\n{}  </Collection>\n"
                                     "</VTKFile>\n",
                                     listed));
}

/// Removes the files of the earlier series that are not kept.  The list is removed before the frames, so that it never
/// names a frame that does not exist.
void Series::Data::removeEarlier() const {
  if (frames == 0) removeFile(list());
  removeFile(temporaryName(list()));
  removeFrames(directory, name, listed);
}

void Series::Data::writeFrame(const TimedFrame& next) {
  const std::string file = fmt::format("{0}/{0}_{1:06}.vtp", name, frames);
  writeVtp(directory / file, triangles, next.frame);
  const std::size_t before = listed.size();
  listed += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", next.time, file);
  try {
    writeList();
  } catch (const ComputationError&) {
    listed.resize(before);
    removeFile(directory / file);  // no list would name it
    throw;
  }
  ++frames;
}

/// The loop of the writing thread.  After a failure it only empties the queue, so that write() and finish() do not wait
/// for ever.
void Series::Data::writeFrames() {
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [&] { return ended || !queue.empty(); });
    if (queue.empty()) return;
    if (failure.empty()) {
      const TimedFrame& next = queue.front();  // stays in place while others are appended
      lock.unlock();
      std::string reason;
      try {
        writeFrame(next);
      } catch (const std::exception& error) {
        reason = error.what();
      }
      lock.lock();
      failure = reason;
    }
    queue.pop_front();
    changed.notify_all();
  }
}

Series::Series(const fs::path& directory, const std::string& name, const Triangles& triangles, double keep_until)
    : data_(std::make_unique<Data>()) {
  data_->directory = directory;
  data_->name = name;
  data_->triangles = triangles;
  makeDirectory(directory / name);
  data_->keepUntil(keep_until);
  data_->removeEarlier();
  data_->writer = std::thread([data = data_.get()] { data->writeFrames(); });
}

Series::~Series() {
  {
    const std::lock_guard lock(data_->mutex);
    data_->ended = true;
  }
  data_->changed.notify_all();
  data_->writer.join();
}

void Series::write(double time_s, Frame frame) {
  std::unique_lock lock(data_->mutex);
  data_->changed.wait(lock, [&] { return data_->queue.size() < kLargestQueue; });
  if (!data_->failure.empty()) throw ComputationError(data_->failure);
  data_->queue.push_back({time_s, std::move(frame)});
  data_->changed.notify_all();
}

void Series::finish() {
  std::unique_lock lock(data_->mutex);
  data_->changed.wait(lock, [&] { return data_->queue.empty(); });
  if (!data_->failure.empty()) throw ComputationError(data_->failure);
}

}  // namespace ease
