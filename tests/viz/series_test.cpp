#include "viz/series.h"

#include <sys/resource.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <sstream>

#include "solver/base/error.h"
#include "tests/viz/fixtures.h"

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

namespace {

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Listed {
  double time;
  std::string file;
};

std::string attribute(const std::string& line, const std::string& name) {
  const auto start = line.find(" " + name + "=\"");
  REQUIRE(start != std::string::npos);
  const auto value = start + name.size() + 3;
  return line.substr(value, line.find('"', value) - value);
}

// What a .pvd lists; fails unless it is whole.
std::vector<Listed> readList(const fs::path& pvd) {
  const std::string text = contents(pvd);
  REQUIRE(text.find("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\"") == 0);
  REQUIRE(text.size() > 11);
  REQUIRE(text.substr(text.size() - 11) == "</VTKFile>\n");
  std::vector<Listed> listed;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("<DataSet") == std::string::npos) continue;
    listed.push_back({std::stod(attribute(line, "timestep")), attribute(line, "file")});
  }
  return listed;
}

std::vector<std::string> filesIn(const fs::path& directory) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file()) files.push_back(entry.path().filename().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

template <class Call>
std::string errorOf(const Call& call) {
  try {
    call();
  } catch (const ease::ComputationError& error) {
    return error.what();
  }
  return "";
}

// No file of this process can grow beyond `bytes` while this lives: what a full disk does, without one.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_before_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_before_);
  }

 private:
  rlimit before_;
  void (*handler_before_)(int);
};

}  // namespace

TEST_CASE("the list of a series names every frame with its time, in order, and no temporary file is left") {
  const test::Directory directory;
  const ease::TriangleMesh mesh = test::gridMesh(6);
  ease::Series series(directory.path(), "garment", mesh.triangles);
  constexpr int kFrames = 40;
  for (int k = 0; k < kFrames; ++k) {
    ease::Frame frame{mesh.positions, {}, {}};
    frame.positions(0, 2) = k;
    series.write(0.02 * k, frame);
  }
  series.finish();

  const auto listed = readList(directory.path() / "garment.pvd");
  REQUIRE(listed.size() == kFrames);
  for (int k = 0; k < kFrames; ++k) {
    CHECK(listed[k].time == 0.02 * k);
    const auto frame = test::readVtp(directory.path() / listed[k].file);
    CHECK(frame->GetPoint(0)[2] == k);
  }
  const auto files = filesIn(directory.path());
  CHECK(files.size() == kFrames + 1);
  for (const std::string& file : files) CHECK_THAT(file, !Contains(".part"));
}

TEST_CASE("at every moment the list is whole and names whole frames only") {
  const test::Directory directory;
  const ease::TriangleMesh mesh = test::gridMesh(20);
  ease::Series series(directory.path(), "body", mesh.triangles);
  std::size_t most = 0;
  for (int k = 0; k < 30; ++k) {
    series.write(k, {mesh.positions, {}, {}});
    if (!fs::exists(directory.path() / "body.pvd")) continue;
    const auto listed = readList(directory.path() / "body.pvd");
    CHECK(listed.size() >= most);
    most = listed.size();
    REQUIRE(most > 0);
    CHECK(test::readVtp(directory.path() / listed.back().file)->GetNumberOfPoints() == mesh.positions.rows());
  }
  series.finish();
  CHECK(readList(directory.path() / "body.pvd").size() == 30);
}

TEST_CASE("a series can be finished twice, go on, and be destroyed unfinished") {
  const test::Directory directory;
  const ease::TriangleMesh mesh = test::gridMesh(3);
  {
    ease::Series series(directory.path(), "rest", mesh.triangles);
    series.finish();
    series.write(0.0, {mesh.positions, {}, {}});
    series.finish();
    series.finish();
    CHECK(readList(directory.path() / "rest.pvd").size() == 1);
    series.write(1.0, {mesh.positions, {}, {}});
    series.write(2.0, {mesh.positions, {}, {}});
  }
  CHECK(readList(directory.path() / "rest.pvd").size() == 3);
}

TEST_CASE("an earlier series of the same name goes, and nothing else") {
  const test::Directory directory;
  const ease::TriangleMesh mesh = test::gridMesh(3);
  {
    ease::Series earlier(directory.path(), "garment", mesh.triangles);
    for (int k = 0; k < 5; ++k) earlier.write(k, {mesh.positions, {}, {}});
  }
  const std::vector<std::string> others = {"garment_notes.txt", "garment_000001.png", "garment_a.vtp", "other.vtp"};
  for (const std::string& other : others) std::ofstream(directory.path() / "garment" / other) << "mine";
  std::ofstream(directory.path() / "garment" / "garment_000005.vtp.part") << "cut short";
  std::ofstream(directory.path() / "garment.pvd.part") << "cut short";

  ease::Series series(directory.path(), "garment", mesh.triangles);
  std::vector<std::string> expected = others;
  std::sort(expected.begin(), expected.end());
  CHECK(filesIn(directory.path()) == expected);
}

TEST_CASE("a series goes on after the frames up to a time") {
  const test::Directory directory;
  const ease::TriangleMesh mesh = test::gridMesh(3);
  {
    ease::Series earlier(directory.path(), "garment", mesh.triangles);
    for (int k = 0; k < 5; ++k) earlier.write(0.1 * k, {mesh.positions, {}, {}});
  }
  ease::Series series(directory.path(), "garment", mesh.triangles, 0.25);
  CHECK(filesIn(directory.path() / "garment").size() == 3);
  CHECK(readList(directory.path() / "garment.pvd").size() == 3);
  series.write(0.3, {mesh.positions, {}, {}});
  series.finish();
  CHECK(readList(directory.path() / "garment.pvd").size() == 4);
  CHECK(filesIn(directory.path() / "garment").size() == 4);
}

TEST_CASE("a directory that cannot be made is one clear error") {
  const test::Directory directory;
  std::ofstream(directory.path() / "file") << "not a directory";
  const auto make = [&] { ease::Series(directory.path() / "file", "garment", test::gridMesh(3).triangles); };
  const std::string message = errorOf(make);
  CHECK_THAT(message, Contains((directory.path() / "file").string()) && Contains("Not a directory"));
  CHECK_THAT(message, !Contains("\n"));
}

TEST_CASE("a directory that vanishes under way reaches the caller, with the file and the reason") {
  const test::Directory directory;
  const ease::TriangleMesh mesh = test::gridMesh(3);
  ease::Series series(directory.path(), "garment", mesh.triangles);
  series.write(0.0, {mesh.positions, {}, {}});
  series.finish();
  fs::remove_all(directory.path() / "garment");
  const std::string message = errorOf([&] {
    series.write(1.0, {mesh.positions, {}, {}});
    series.finish();
  });
  CHECK_THAT(message, Contains("garment_000001.vtp") && Contains("No such file or directory"));
  CHECK(errorOf([&] { series.write(2.0, {mesh.positions, {}, {}}); }) == message);
  CHECK(errorOf([&] { series.finish(); }) == message);
}

TEST_CASE("a full disk is an error, leaves the frames before it listed and no temporary file") {
  const test::Directory directory;
  const ease::TriangleMesh small = test::gridMesh(10);
  ease::Series series(directory.path(), "garment", small.triangles);
  series.write(0.0, {small.positions, {}, {}});
  series.finish();
  const auto frame_bytes = fs::file_size(directory.path() / "garment" / "garment_000000.vtp");
  std::string message;
  {
    const SmallDisk disk(frame_bytes + 100);
    const ease::NamedArray noise = test::noise("sigma_1", 1, small.triangles.rows());
    message = errorOf([&] {
      series.write(1.0, {small.positions, {}, {noise}});
      series.finish();
    });
  }
  CHECK_THAT(message, Contains("garment_000001.vtp") && Contains("File too large"));
  CHECK(readList(directory.path() / "garment.pvd").size() == 1);
  CHECK(filesIn(directory.path()) == std::vector<std::string>{"garment.pvd", "garment_000000.vtp"});
}

TEST_CASE("frames are the same to the last byte in every run") {
  const test::Directory first, second;
  const ease::TriangleMesh mesh = test::gridMesh(8);
  for (const fs::path& directory : {first.path(), second.path()}) {
    ease::Series series(directory, "garment", mesh.triangles);
    series.write(0.5, {mesh.positions, {test::noise("gap_m", 1, mesh.positions.rows())}, {}});
  }
  const fs::path frame = "garment/garment_000000.vtp";
  CHECK(!contents(first.path() / frame).empty());
  CHECK(contents(first.path() / frame) == contents(second.path() / frame));
  CHECK(contents(first.path() / "garment.pvd") == contents(second.path() / "garment.pvd"));
}
