#include "apps/result_directory.h"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "solver/base/error.h"
#include "tests/apps/temporary_directory.h"

using namespace ease;
using Catch::Contains;

namespace {

constexpr const char* kOurs = R"({"quality": {}, "loops": []})";

/// Imitates a full disk during the lifetime of the object: no byte can be written to any file.
class FullDisk {
 public:
  FullDisk() : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit none{0, limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &none);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit limit_{};
  void (*handler_)(int);
};

}  // namespace

TEST_CASE("a directory is held by one command at a time, and left without a trace") {
  const TemporaryDirectory directory;
  {
    const ResultDirectory first(directory.path / "results");
    CHECK_THROWS_WITH(ResultDirectory(directory.path / "results"), Catch::Contains("another run writes into this"));
  }
  CHECK_FALSE(std::filesystem::exists(directory.path / "results"));
  CHECK_NOTHROW(ResultDirectory(directory.path / "results"));
}

TEST_CASE("a directory with the results of another scene is refused with what to do") {
  const TemporaryDirectory directory;
  directory.write("report.json", R"({"scene": "skirt"})");
  const ResultDirectory results(directory.path);
  CHECK_NOTHROW(results.refuseOtherScene("skirt"));
  CHECK_THROWS_WITH(
      results.refuseOtherScene("dress"),
      Catch::Contains("holds the results of the scene 'skirt', not of 'dress'") && Catch::Contains("--force"));
}

TEST_CASE("a run that was stopped is told from one that ended or has no checkpoint") {
  const TemporaryDirectory directory;
  const ResultDirectory results(directory.path);
  CHECK_FALSE(results.holdsStoppedRun());
  directory.write("report.json", R"({"interrupted": true})");
  CHECK_FALSE(results.holdsStoppedRun());
  directory.write("checkpoint.bin", "");
  CHECK(results.holdsStoppedRun());
  directory.write("report.json", R"({"interrupted": false})");
  CHECK_FALSE(results.holdsStoppedRun());
  directory.write("report.json", "{");
  CHECK_FALSE(results.holdsStoppedRun());
}

TEST_CASE("a directory made for nothing goes again, with those made on the way to it") {
  const TemporaryDirectory directory;
  { const ResultDirectory made(directory.path / "results/tunic"); }
  CHECK_FALSE(std::filesystem::exists(directory.path / "results"));
  {
    const ResultDirectory made(directory.path / "results/tunic");
    directory.write("results/tunic/garment.obj", "v 0 0 0");
  }
  { const ResultDirectory made(directory.path / "results/shirt"); }
  CHECK(std::filesystem::exists(directory.path / "results/tunic/garment.obj"));
  CHECK_FALSE(std::filesystem::exists(directory.path / "results/shirt"));
}

TEST_CASE("a disk that takes nothing is told with the system's reason, and leaves no directory") {
  const TemporaryDirectory directory;
  std::string message;
  {
    const FullDisk full;
    message = messageOf<InputError>([&] { const ResultDirectory made(directory.path / "results"); });
  }
  CHECK_THAT(message, Contains("results: cannot write into this directory: File too large"));
  CHECK_FALSE(std::filesystem::exists(directory.path / "results"));
}

TEST_CASE("the files of an earlier garment go, those of the user's own and those that the scene reads stay") {
  const TemporaryDirectory directory;
  Scene scene;
  scene.file = directory.path / "scene.toml";
  scene.garment.mesh = "mine.obj";
  const ResultDirectory made(directory.path);
  const auto exists = [&](const char* name) { return std::filesystem::exists(directory.path / name); };
  for (const char* name : {"mine.obj", "body.obj", "pieces.obj"}) directory.write(name, "");
  made.removeOldGarment(scene);
  CHECK(exists("body.obj"));  // without garment.json it is not Ease's
  directory.write("garment.json", "{\"my\": \"own\"}");
  made.removeOldGarment(scene);
  CHECK(exists("body.obj"));  // this garment.json is not Ease's either
  directory.write("garment.json", kOurs);
  made.removeOldGarment(scene);
  CHECK(exists("mine.obj"));
  for (const char* name : {"body.obj", "pieces.obj", "garment.json"}) CHECK_FALSE(exists(name));

  for (const char* name : {"garment.obj", "pieces.json"}) directory.write(name, "");
  directory.write("garment.json", kOurs);
  scene.garment.mesh = "garment.obj";
  made.removeOldGarment(scene);
  for (const char* name : {"garment.obj", "garment.json", "pieces.json"}) CHECK(exists(name));
}
