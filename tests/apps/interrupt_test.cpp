// Tests that the files on disk are complete after a run was interrupted, was killed or filled the disk.
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include "apps/checkpoint.h"
#include "solver/io/mesh_io.h"
#include "tests/apps/command.h"
#include "tests/apps/result_check.h"
#include "tests/apps/started.h"
#include "tests/sheet.h"

using namespace ease;
using Catch::Contains;
using Catch::StartsWith;

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kRun = {"run", "sheet.toml", "-o", "there", "--threads", "1"};

/// Writes the scene of a hanging sheet of 21 x 21 vertices, with a frame for every step.
void writeScene(const TemporaryDirectory& directory, long steps, const char* more = "") {
  writeObj(directory.path / "sheet.obj", makeSheet(20, 20, 1.0, 1.0));
  directory.write("sheet.toml", "solver = {steps = " + std::to_string(steps) +
                                    ", method = 'bw1'}\n[garment]\nmesh = 'sheet.obj'\ngrain = [0, 1, 0]\n"
                                    "[[garment.pin]]\nvertices = [0, 20]\n[output]\nevery = 1\n" +
                                    more);
}

size_t framesIn(const fs::path& directory) {
  return fs::exists(directory / "garment.pvd") ? framesListed(directory / "garment.pvd").size() : 0;
}

bool hasTemporary(const fs::path& directory) {
  std::error_code gone;
  for (fs::directory_iterator entry(directory, gone), end; !gone && entry != end; entry.increment(gone))
    if (entry->path().extension() == ".part") return true;
  return false;
}

/// Mounts a file system of half a megabyte that only this process and its children see.  Returns false if that is not
/// permitted.
bool mountSmall(const fs::path& directory) {
  const uid_t user = ::getuid();
  const gid_t group = ::getgid();
  if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
  std::ofstream("/proc/self/setgroups") << "deny";
  std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
  std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
  return ::mount("none", directory.c_str(), "tmpfs", 0, "size=512k") == 0;
}

}  // namespace

TEST_CASE("a run that is interrupted leaves series that open and a checkpoint to go on from") {
  const auto [signal, frames] = GENERATE(table<int, size_t>({{SIGINT, 1}, {SIGTERM, 3}, {SIGINT, 14}}));
  const TemporaryDirectory directory;
  const fs::path there = directory.path / "there";
  writeScene(directory, 1000000);
  Started run(directory, kRun);
  run.waitUntil([&, wanted = frames] { return framesIn(there) >= wanted; });
  run.stop(signal);
  CHECK(run.code() == 130);
  const std::string err = contentOf(directory.path / "err");
  CHECK(err == "ease: interrupted: what was written until then is in there\n");
  CHECK(faultIn(there) == "");
  CHECK(framesIn(there) >= frames);
  CHECK_THAT(contentOf(there / "report.json"), Contains("\"interrupted\": true"));
  writeScene(directory, 40);
  const bool is_further = readCheckpoint(there / "checkpoint.bin").run.done.total >= 40;
  if (is_further) return;
  const Outcome on = runEase(directory, "run sheet.toml --resume there --threads 1");
  CHECK(on.code == 0);
  CHECK(faultIn(there) == "");
  CHECK(framesIn(there) == 41);
}

TEST_CASE("a run that is killed leaves series that open, the next run takes away what it left unfinished") {
  const bool goes_on = GENERATE(true, false);
  const TemporaryDirectory directory;
  const fs::path there = directory.path / "there";
  writeScene(directory, 1000000);
  Started run(directory, kRun);
  run.waitUntil([&] { return framesIn(there) >= 3 && hasTemporary(there / "garment"); });
  run.stop(SIGKILL);
  CHECK(run.signal() == SIGKILL);
  CHECK(faultIn(there, true) == "");
  CHECK(framesIn(there) >= 3);
  for (const char* stray : {"garment/garment_999999.vtp.part", "report.json.part", "checkpoint.bin.part",
                            "stretch.png.part", ".ease-writable"})
    std::ofstream(there / stray) << "cut sho";
  writeScene(directory, readCheckpoint(there / "checkpoint.bin").run.done.total + 5);
  CHECK(runEase(directory, goes_on ? "run sheet.toml --resume there" : "run sheet.toml -o there").code == 0);
  CHECK(faultIn(there) == "");
}

TEST_CASE("a run without output takes away the series that a killed one left") {
  const TemporaryDirectory directory;
  writeScene(directory, 3);
  REQUIRE(runEase(directory, "run sheet.toml -o there").code == 0);
  std::ofstream(directory.path / "there/rest/rest_000003.vtp.part") << "cut sho";
  std::ofstream(directory.path / "there/rest/notes.txt") << "mine";
  writeHangingCloth(directory, 2);
  REQUIRE(runEase(directory, "run hang.toml -o there --force").code == 0);
  CHECK(faultIn(directory.path / "there") == "");
  CHECK_FALSE(fs::exists(directory.path / "there/garment"));
  CHECK_FALSE(fs::exists(directory.path / "there/rest.pvd"));
  CHECK(fs::exists(directory.path / "there/rest/notes.txt"));
}

TEST_CASE("a run that is killed before its tenth frame goes on to what an unbroken one gives") {
  const TemporaryDirectory directory;
  const char* adaption = "[adaption]\nmode = 'sequential'\nlimit = 0.02\nevery = 2\nverify = false\n";
  writeScene(directory, 1000000, adaption);
  Started run(directory, kRun);
  run.waitUntil([&] { return fs::exists(directory.path / "there/checkpoint.bin"); });
  run.stop(SIGKILL);
  const int steps =
      readCheckpoint(directory.path / "there/checkpoint.bin").run.done.total + 20;  // the kill may come late
  writeScene(directory, steps, adaption);
  REQUIRE(runEase(directory, "run sheet.toml -o whole").code == 0);
  REQUIRE(runEase(directory, "run sheet.toml --resume there").code == 0);
  for (const char* file : {"rest_shape.obj", "garment.pvd", "garment/garment_000020.vtp", "checkpoint.bin"}) {
    INFO(file);
    const bool same = contentOf(directory.path / "whole" / file) == contentOf(directory.path / "there" / file);
    CHECK(same);
  }
}

TEST_CASE("a run that goes on keeps the report and the picture before it until it has ended") {
  const TemporaryDirectory directory;
  const fs::path there = directory.path / "there";
  writeScene(directory, 4);
  REQUIRE(runEase(directory, "run sheet.toml -o there").code == 0);
  const std::string report = contentOf(there / "report.json"), picture = contentOf(there / "stretch.png");
  for (int time = 0; time < 2; ++time) {
    writeScene(directory, 1000000);
    const size_t before = framesIn(there);
    Started run(directory, {"run", "sheet.toml", "--resume", "there"});
    // Only one file is looked at, since the list and its frames may change between two looks.
    const std::string number = std::to_string(before + 10);
    const fs::path eleventh = there / "garment" / ("garment_" + std::string(6 - number.size(), '0') + number + ".vtp");
    run.waitUntil([&] { return fs::exists(eleventh); });
    run.stop(SIGINT);
    CHECK(run.code() == 130);
    CHECK(contentOf(there / "earlier_report.json") == report);
    CHECK(contentOf(there / "earlier_stretch.png") == picture);
    CHECK_THAT(contentOf(there / "report.json"), Contains("\"interrupted\": true"));
  }
  writeScene(directory, readCheckpoint(there / "checkpoint.bin").run.done.total + 4);
  REQUIRE(runEase(directory, "run sheet.toml --resume there").code == 0);
  CHECK_FALSE(fs::exists(there / "earlier_report.json"));
  CHECK_FALSE(fs::exists(there / "earlier_stretch.png"));
  CHECK(fs::exists(there / "stretch.png"));
}

TEST_CASE("a program that is stopped as it starts ends in order at any moment") {
  for (const int signal : {SIGINT, SIGTERM, SIGKILL})
    for (const int milliseconds : {0, 10, 20, 40, 60, 90}) {
      const TemporaryDirectory directory;
      const fs::path there = directory.path / "there";
      writeScene(directory, 1000000);
      Started run(directory, kRun);
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      run.stop(signal);
      const std::string err = contentOf(directory.path / "err");
      INFO(signal << " after " << milliseconds << " ms: " << err);
      const bool before_main = run.signal() == signal;
      CHECK((before_main || run.code() == 130));
      if (before_main)
        CHECK(err.empty());
      else
        CHECK_THAT(err, StartsWith("ease: interrupted: "));
      CHECK((err.empty() || isOneLine(err)));
      CHECK(faultIn(there, signal == SIGKILL) == "");
      if (before_main && signal != SIGKILL) CHECK_FALSE(fs::exists(there));
    }
}

TEST_CASE("the tools that make a garment can be interrupted, and have written nothing then") {
  const TemporaryDirectory directory;
  directory.write("tube.toml",
                  "body = {builtin = 'mannequin', poses = ['t']}\n[garment]\nresolution = 50000\n[garment.region]\n"
                  "seed = [0, 1, 0.2]\n"
                  "[[garment.boundary]]\nname = 'top'\nplane = {point = [0, 1.2, 0], normal = [0, 1, 0]}\n"
                  "[[garment.boundary]]\nname = 'hem'\nplane = {point = [0, 0.9, 0], normal = [0, 1, 0]}\n");
  for (const char* command : {"garment", "run"}) {
    int code = -1;
    for (const int milliseconds : {300, 1000, 3000}) {  // on a slow machine the program has not begun after the first
      Started made(directory, {command, "tube.toml", "-o", "made"});
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      made.stop(SIGINT);
      code = made.code();
      if (made.signal() != SIGINT) break;
    }
    CHECK(code == 130);
    CHECK(contentOf(directory.path / "err") == "ease: interrupted: nothing was written\n");
    CHECK_FALSE(fs::exists(directory.path / "made"));
  }
}

TEST_CASE("files that may not grow end a run with the file and the reason, and what is there is whole") {
  const TemporaryDirectory directory;
  const fs::path there = directory.path / "there";
  writeScene(directory, 60);
  for (const rlim_t bytes : {0, 100, 1000, 10000, 20000, 50000}) {
    const rlimit limit{bytes, bytes};
    Started run(directory, kRun, [&] { ::setrlimit(RLIMIT_FSIZE, &limit); });
    run.wait();
    const std::string err = contentOf(directory.path / "err");
    INFO(bytes << ": " << err);
    if (bytes > 0) CHECK(run.code() == 2);
    CHECK(faultIn(there) == "");
  }
  CHECK(framesIn(there) > 0);
}

TEST_CASE("a full disk ends a run in one line, and its series open up to the last whole frame") {
  const TemporaryDirectory directory;
  const fs::path there = directory.path / "there";
  writeScene(directory, 1000);
  fs::create_directory(there);
  const pid_t child = ::fork();  // the child's mounts end with it
  REQUIRE(child >= 0);
  if (child == 0) {
    if (!mountSmall(there)) ::_exit(77);
    Started run(directory, kRun);
    run.wait();
    directory.write("fault", faultIn(there));
    directory.write("frames", std::to_string(framesIn(there)));
    ::_exit(run.code());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  if (WEXITSTATUS(status) == 77) {
    WARN("no file system can be mounted here");
    return;
  }
  const std::string err = contentOf(directory.path / "err");
  INFO(err);
  CHECK(WEXITSTATUS(status) == 2);
  CHECK_THAT(err, Contains("ease: error: ") && Contains("No space left on device"));
  CHECK(contentOf(directory.path / "fault") == "");
  CHECK(std::stoi(contentOf(directory.path / "frames")) > 1);  // more than one frame fits
}
