#include "apps/result_directory.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "apps/resume.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "viz/series.h"

namespace ease {

namespace {

namespace fs = std::filesystem;

// Files about a made garment.  The last one, garment.json, shows by its content whether Ease wrote it and the others;
// it is removed last.
constexpr std::array kGarmentFiles = {"garment.obj", "garment.vtp", "garment.png", "body.obj",
                                      "pieces.obj",  "pieces.vtp",  "pieces.json", "garment.json"};

constexpr const char* kLock = ".ease-lock";

constexpr std::array kShown = {"report.json", "stretch.png", "stretch_first_pose.png", "fit.html"};
constexpr std::array kShapes = {"rest_shape.obj", "rest_shape.vtp", "rest_pieces.obj", "rest_pieces.vtp",
                                "rest_pieces.json"};

constexpr std::array kPattern = {"pattern.svg", "pattern.pdf",  "pattern_a4.pdf", "pattern_letter.pdf", "pattern.dxf",
                                 "pattern.png", "pattern.json", "pattern.vtp",    "pattern_resewn.png"};

void removeResult(const fs::path& file) {
  if (fs::is_directory(file))
    throw InputError(fmt::format("{}: is a directory: a result of that name is to be written", file.string()));
  fs::remove(file);
}

fs::path earlier(const fs::path& directory, const std::string& name) {
  return directory / ("earlier_" + name);
}

bool reads(const Scene& scene, const fs::path& file) {
  const auto isFile = [&](const std::string& named) {
    std::error_code none;
    return !named.empty() && fs::equivalent(scene.file.parent_path() / named, file, none);
  };
  if (isFile(scene.garment.mesh)) return true;
  return scene.body && scene.body->builtin.empty() &&
         std::any_of(scene.body->poses.begin(), scene.body->poses.end(), isFile);
}

}  // namespace

ResultDirectory::ResultDirectory(const fs::path& path) : path_(path) {
  std::error_code error;
  for (fs::path part = fs::absolute(path).lexically_normal(); !part.empty() && !fs::exists(part, error);
       part = part.parent_path())
    made_.push_back(part);
  fs::create_directories(path, error);
  if (error) {
    removeEmpty();
    throw InputError(fmt::format("{}: cannot make this directory: {}", path.string(), error.message()));
  }
  const fs::path probe = path / ".ease-writable";  // a fixed name, so that the file of a killed run is removed, too
  errno = 0;
  const bool writable = static_cast<bool>(std::ofstream(probe) << '\n' << std::flush);
  const int reason = errno;
  fs::remove(probe, error);
  if (writable) {
    lock();
    return;
  }
  removeEmpty();
  throw InputError(fmt::format("{}: cannot write into this directory: {}", path.string(), std::strerror(reason)));
}

ResultDirectory::~ResultDirectory() {
  unlock();
  removeEmpty();
}

void ResultDirectory::lock() {
  lock_ = ::open((path_ / kLock).c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
  if (lock_ < 0 || ::flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;  // some disks have no locks
  ::close(std::exchange(lock_, -1));
  throw InputError(
      fmt::format("{}: another run writes into this directory: wait until it has ended, or choose another "
                  "directory with -o",
                  path_.string()));
}

void ResultDirectory::unlock() const {
  if (lock_ < 0) return;
  ::unlink((path_ / kLock).c_str());
  ::close(lock_);
}

void ResultDirectory::refuseOtherScene(const std::string& scene) const {
  std::ifstream in(path_ / "report.json");
  const nlohmann::json report = nlohmann::json::parse(in, nullptr, false);
  if (!report.is_object() || !report.contains("scene") || !report["scene"].is_string()) return;
  const std::string earlier_scene = report["scene"];
  if (earlier_scene == scene) return;
  throw InputError(
      fmt::format("{}: holds the results of the scene '{}', not of '{}': choose another directory with -o, "
                  "or replace them with --force",
                  path_.string(), earlier_scene, scene));
}

bool ResultDirectory::holdsStoppedRun() const {
  if (!fs::exists(path_ / "checkpoint.bin")) return false;
  std::ifstream in(path_ / "report.json");
  const nlohmann::json report = nlohmann::json::parse(in, nullptr, false);
  return report.is_object() && report.value("interrupted", false);
}

void ResultDirectory::removeEmpty() const {
  std::error_code not_empty;
  for (const fs::path& directory : made_) fs::remove(directory, not_empty);
}

void ResultDirectory::removeOldGarment(const Scene& scene) const {
  std::ifstream in(path_ / kGarmentFiles.back());
  const nlohmann::json made = nlohmann::json::parse(in, nullptr, false);
  if (!made.is_object() || !made.contains("quality") || !made.contains("loops")) return;
  const auto isRead = [&](const char* name) { return reads(scene, path_ / name); };
  if (std::any_of(kGarmentFiles.begin(), kGarmentFiles.end(), isRead)) return;
  std::error_code is_directory;  // not an error yet: writing the file will report it
  for (const char* name : kGarmentFiles) fs::remove(path_ / name, is_directory);
}

void removeOldResults(const fs::path& directory, bool goes_on) {
  for (const char* name : kShown) {
    removeResult(temporaryName(directory / name));
    const bool is_kept = goes_on && fs::is_regular_file(directory / name) && !fs::exists(earlier(directory, name));
    if (is_kept)
      fs::rename(directory / name, earlier(directory, name));
    else
      removeResult(directory / name);
  }
  for (const char* name : kShapes) {
    removeResult(temporaryName(directory / name));
    removeResult(directory / name);
  }
  removeOldPattern(directory);
  removeResult(temporaryName(directory / kCheckpoint));
  if (goes_on) return;
  removeEarlierReport(directory);
  removeResult(directory / kCheckpoint);
  for (const char* series : {"garment", "body", "rest", "before_garment", "before_body", "after_garment", "after_body"})
    removeSeries(directory, series);
}

void removeOldPattern(const fs::path& directory) {
  for (const char* name : kPattern) removeResult(directory / name);
}

void removeEarlierReport(const fs::path& directory) {
  for (const char* name : kShown) removeResult(earlier(directory, name));
}

}  // namespace ease
