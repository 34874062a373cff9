// The program itself, as a user starts it.
#include <sys/wait.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/apps/temporary_directory.h"

using namespace ease;
using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

namespace {

struct Outcome {
  int code;
  std::string out, err;
};

std::string contentOf(const std::filesystem::path& file) {
  std::ostringstream content;
  content << std::ifstream(file).rdbuf();
  return content.str();
}

/// Runs `ease ARGUMENTS` in `directory`, started by `launcher` (a command in front of it).
Outcome runEase(const TemporaryDirectory& directory, const std::string& arguments, const std::string& launcher = "") {
  const std::string in = "cd '" + directory.path.string() + "' && ";
  const int status = std::system((in + launcher + "'" EASE_COMMAND "' >out 2>err " + arguments).c_str());
  REQUIRE(WIFEXITED(status));
  return {WEXITSTATUS(status), contentOf(directory.path / "out"), contentOf(directory.path / "err")};
}

Outcome runEase(const std::string& arguments) {
  return runEase(TemporaryDirectory(), arguments);
}

bool isOneLine(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') == 1;
}

std::filesystem::path writeHangingScene(const TemporaryDirectory& directory, int steps) {
  return directory.write("hang.toml", "solver = {steps = " + std::to_string(steps) +
                                          "}\n[garment]\nmesh = 'cloth.obj'\n[[garment.pin]]\nvertices = [6, 7, 8]\n");
}

/// A square of cloth, 2 x 2 x 2 triangles, that hangs by its upper edge for `steps` time steps.
std::filesystem::path writeHangingCloth(const TemporaryDirectory& directory, int steps) {
  std::string obj;
  for (const char* y : {"1.0", "1.1", "1.2"})
    for (const char* x : {"0.0", "0.1", "0.2"}) obj += std::string("v ") + x + " " + y + " 0\n";
  obj += "f 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\nf 4 5 8\nf 4 8 7\nf 5 6 9\nf 5 9 8\n";
  directory.write("cloth.obj", obj);
  return writeHangingScene(directory, steps);
}

}  // namespace

TEST_CASE("help shows the commands, examples and exit codes") {
  const Outcome outcome = runEase("--help");
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, Contains("run") && Contains("check") && Contains("Examples:") && Contains("130 interrupted"));
}

TEST_CASE("every command has its help") {
  CHECK_THAT(runEase("run --help").out, Contains("--output") && Contains("--threads") && Contains("Examples:"));
  CHECK_THAT(runEase("check --help").out, Contains("SCENE") && Contains("Example:"));
}

TEST_CASE("an output that takes nothing is an error") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 4);
  for (const std::string arguments : {"--help", "--version", "check hang.toml", "run hang.toml"}) {
    INFO(arguments);
    const Outcome outcome = runEase(directory, arguments + " >/dev/full");
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, StartsWith("ease: error: standard output: "));
    CHECK(isOneLine(outcome.err));
  }
}

TEST_CASE("the version is printed") {
  const Outcome outcome = runEase("--version");
  CHECK(outcome.code == 0);
  CHECK(outcome.out == "ease " EASE_VERSION "\n");
}

TEST_CASE("misuse of the command line is one line and exit code 1") {
  const auto [arguments, message] = GENERATE(table<const char*, const char*>({
      {"", "no command: expected 'run', 'garment' or 'check'"},
      {"rum x.toml", "unknown command 'rum', did you mean 'run'?"},
      {"--fast", "unknown option '--fast'"},
      {"run", "SCENE is required"},
      {"run x.toml --threads many", "--threads"},
      {"run x.toml --treads 1", "unknown option '--treads', did you mean '--threads'?"},
      {"run --treads 1 x.toml", "unknown option '--treads', did you mean '--threads'?"},
      {"run x.toml --threads -2", "--threads"},
      {"run x.toml y.toml", "unknown argument 'y.toml'"},
      {"check x.toml -o out", "unknown option '-o'"},
  }));
  const Outcome outcome = runEase(arguments);
  INFO(arguments);
  CHECK(outcome.code == 1);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, StartsWith("ease: error: ") && Contains(message));
  CHECK(isOneLine(outcome.err));
}

TEST_CASE("a wrong scene is one line and exit code 1, for run as for check") {
  for (const std::string command : {"run", "check"}) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", "[garment]\nmehs = 's.obj'\n");
    directory.write("missing.toml", "solver = {steps = 1}\n[garment]\nmesh = 's.obj'\n");
    const Outcome missing_scene = runEase(directory, command + " none.toml");
    CHECK(missing_scene.code == 1);
    CHECK(missing_scene.err == "ease: error: none.toml: no such scene file\n");
    const Outcome wrong_key = runEase(directory, command + " scene.toml");
    CHECK(wrong_key.code == 1);
    CHECK(wrong_key.err == "ease: error: scene.toml:2: [garment] 'mehs' is not a known key; did you mean 'mesh'?\n");
    const Outcome missing_mesh = runEase(directory, command + " missing.toml");
    CHECK(missing_mesh.code == 1);
    CHECK_THAT(missing_mesh.err, StartsWith("ease: error: ") && Contains("s.obj"));
    CHECK(isOneLine(missing_mesh.err));
    CHECK_FALSE(std::filesystem::exists(directory.path / "results"));
  }
}

TEST_CASE("check sums up a scene and writes nothing") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 400);
  const Outcome outcome = runEase(directory, "check hang.toml");
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, StartsWith("hang\n") && EndsWith("ok\n"));
  CHECK_THAT(outcome.out, Contains("9 vertices, 8 triangles, 1 boundary loop, 3 pinned vertices"));
  CHECK_THAT(outcome.out, Contains("400 time steps of 0.0025 s: 1 s"));
  CHECK_FALSE(std::filesystem::exists(directory.path / "results"));
}

TEST_CASE("a directory that cannot be written to is found before computing") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 1000000);
  directory.write("file", "");
  const Outcome outcome = runEase(directory, "run hang.toml -o file/results");
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.err, StartsWith("ease: error: file/results: cannot make this directory"));
  CHECK(isOneLine(outcome.err));
}

TEST_CASE("a run writes into its directory, by default one of the scene's name") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 4);
  CHECK(runEase(directory, "run hang.toml").code == 0);
  CHECK(std::filesystem::exists(directory.path / "results/hang/report.json"));
  CHECK(runEase(directory, "run hang.toml -o here --threads 1").code == 0);
  CHECK(std::filesystem::exists(directory.path / "here/report.json"));
}

TEST_CASE("an interrupted run ends with exit code 130 and says where its results are") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 1000000);
  for (const std::string signal : {"INT", "TERM"}) {
    const Outcome outcome =
        runEase(directory, "run hang.toml", "timeout --foreground --preserve-status --signal=" + signal + " 1 ");
    CHECK(outcome.code == 130);
    CHECK_THAT(outcome.err, Contains("ease: interrupted: ") && Contains("results/hang"));
  }
}

TEST_CASE("every method runs the whole job, and one thread and two write the same rest shape to the last byte") {
  const TemporaryDirectory directory;
  for (const std::string method : {"auto", "bw1", "newton", "pd", "pd-lbfgs"}) {
    INFO(method);
    directory.write("dressed.toml",
                    "[body]\nbuiltin = 'mannequin'\nposes = ['t', 'a']\nsteps = 4\n"
                    "[garment]\nbuiltin = 't-shirt'\nvertices = 400\n[[garment.pin]]\nloop = 'neck'\n"
                    "[material]\nbending = 1e-6\n[adaption]\nlimit = 0.02\nevery = 4\nverify = false\n"
                    "[solver]\nmethod = '" +
                        method + "'\n");
    for (const std::string threads : {"1", "2"}) {
      const Outcome outcome = runEase(directory, "run dressed.toml -o " + method + threads + " --threads " + threads);
      INFO(outcome.err);
      REQUIRE(outcome.code == 0);
    }
    const std::string one = contentOf(directory.path / (method + "1/rest_shape.obj"));
    CHECK(one.size() > 10000);
    CHECK(one == contentOf(directory.path / (method + "2/rest_shape.obj")));
    CHECK_THAT(contentOf(directory.path / (method + "1/report.json")), Contains("\"adaptions\": 4"));
  }
}

TEST_CASE("garment writes a made garment with its loops, seams and pieces") {
  const TemporaryDirectory directory;
  const std::string tube =
      "body = {builtin = 'mannequin', poses = ['t']}\n[garment]\nresolution = 400\n[garment.region]\n"
      "seed = [0, 1, 0.2]\n[[garment.boundary]]\nname = 'top'\nplane = {point = [0, 1.2, 0], normal = [0, 1, 0]}\n"
      "[[garment.boundary]]\nname = 'hem'\nplane = {point = [0, 0.9, 0], normal = [0, 1, 0]}\n"
      "[[garment.seam]]\nname = 'left'\nfrom = 'hem'\nto = 'top'\npoints = [[0.15, 1.05, 0]]\n"
      "[[garment.seam]]\nname = 'right'\nfrom = 'hem'\nto = 'top'\npoints = [[-0.15, 1.05, 0]]\n";
  directory.write("tube.toml", tube);
  const Outcome outcome = runEase(directory, "garment tube.toml --pieces -o made");
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, Contains("garment   ") && Contains("0 self-intersections") && Contains("pieces    2, with"));
  CHECK_THAT(outcome.out, Contains("mm at least to the body, 5.00 mm asked for"));
  const std::filesystem::path made = directory.path / "made";
  for (const char* file :
       {"garment.obj", "garment.vtp", "body.obj", "garment.json", "pieces.obj", "pieces.vtp", "pieces.json"})
    CHECK(std::filesystem::file_size(made / file) > 0);
  CHECK_THAT(contentOf(made / "garment.json"), Contains("\"name\": \"hem\"") && Contains("\"name\": \"left\""));

  directory.write("run.toml", tube + "[solver]\nsteps_per_pose = 1\n[adaption]\nverify = false\n");
  REQUIRE(runEase(directory, "run run.toml -o made").code == 0);
  const std::string pieces = contentOf(made / "rest_pieces.json");
  CHECK_THAT(pieces, StartsWith("{\"pieces\":2,"));
  CHECK(std::filesystem::file_size(made / "rest_pieces.obj") > std::filesystem::file_size(made / "rest_shape.obj"));
  CHECK(std::filesystem::file_size(made / "rest_pieces.vtp") > 0);

  REQUIRE(runEase(directory, "garment tube.toml -o made").code == 0);
  CHECK(std::filesystem::exists(made / "garment.obj"));
  CHECK_FALSE(std::filesystem::exists(made / "pieces.obj"));  // of the garment before
  writeHangingCloth(directory, 1);
  REQUIRE(runEase(directory, "run hang.toml -o made").code == 0);
  for (const char* file :
       {"garment.obj", "garment.vtp", "garment.json", "garment.png", "body.obj", "rest_pieces.obj", "rest_pieces.json"})
    CHECK_FALSE(std::filesystem::exists(made / file));
  const Outcome none = runEase(directory, "garment hang.toml");
  CHECK(none.code == 1);
  CHECK_THAT(none.err, StartsWith("ease: error: hang.toml: [garment] has no [[garment.boundary]]") && EndsWith("\n"));
  CHECK(isOneLine(none.err));
}

TEST_CASE("a run that is stopped and goes on gives what an unbroken one gives, to the last byte") {
  const std::string method = GENERATE("auto", "bw1");
  const TemporaryDirectory directory;
  const auto write = [&](const char* name, const char* poses) {
    directory.write(name,
                    std::string("name = 'dressed'\n[body]\nbuiltin = 'mannequin'\nposes = ") + poses +
                        "\nsteps = 4\n[garment]\nbuiltin = 't-shirt'\nvertices = 400\n[[garment.pin]]\nloop = 'neck'\n"
                        "[material]\nbending = 1e-6\n[adaption]\nlimit = 0.02\nevery = 4\nverify = false\n"
                        "[output]\nevery = 4\n[solver]\nmethod = '" +
                        method + "'\n");
  };
  write("whole.toml", "['t', 'a', 't']");
  write("half.toml", "['t', 'a']");  // as if stopped there
  REQUIRE(runEase(directory, "run whole.toml -o whole").code == 0);
  REQUIRE(runEase(directory, "run half.toml -o half").code == 0);
  const Outcome outcome = runEase(directory, "run whole.toml --resume half");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  for (const char* file : {"rest_shape.obj", "garment.pvd", "garment/garment_000003.vtp", "garment/garment_000008.vtp",
                           "checkpoint.bin"}) {
    INFO(file);
    const std::string whole = contentOf(directory.path / "whole" / file);
    CHECK(whole.size() > 100);
    const bool same = whole == contentOf(directory.path / "half" / file);
    CHECK(same);
  }
}

TEST_CASE("a run that goes on keeps to the way of the body, which may be longer but not another") {
  const TemporaryDirectory directory;
  const auto resume = [&](const std::string& poses, const std::string& adaption, const std::string& arguments) {
    directory.write("on.toml", "[body]\nbuiltin = 'mannequin'\nposes = " + poses +
                                   "\nsteps = 2\n[garment]\nbuiltin = 't-shirt'\nvertices = 400\n[[garment.pin]]\n"
                                   "loop = 'neck'\n[adaption]\nverify = false\n" +
                                   adaption + "[output]\nevery = 2\n[solver]\nmethod = 'bw1'\n");
    return runEase(directory, "run on.toml " + arguments);
  };
  REQUIRE(resume("['t', 'a', 't']", "settle = 2\n", "-o done").code == 0);
  const auto made = nlohmann::json::parse(contentOf(directory.path / "done/report.json"));
  CHECK_FALSE(made.contains("resumed_from_step"));
  for (const char* other : {"['t', 'up', 't']", "['t', 'a', 'up', 't']", "['t', 't', 'a']"}) {
    const Outcome outcome = resume(other, "", "--resume done");
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, StartsWith("ease: error: on.toml: [body] poses: number ") &&
                                Contains("is not what the run in done met there"));
    CHECK(isOneLine(outcome.err));
  }
  const Outcome fewer = resume("['t', 'a']", "settle = 20\n", "--resume done");
  CHECK(fewer.code == 1);
  CHECK_THAT(fewer.err, Contains("[body] poses: the motion has 2 with its cycles, and the run in done met 3"));
  CHECK(std::filesystem::exists(directory.path / "done/report.json"));

  REQUIRE(resume("['t', 'a', 't', 'up']", "settle = 4\n[collision]\noffset = 0.008\n", "--resume done").code == 0);
  const auto report = nlohmann::json::parse(contentOf(directory.path / "done/report.json"));
  CHECK(report["vertices"] == made["vertices"]);  // the T-shirt is that of the offset before
  CHECK(report["resumed_from_step"] == 18);
  CHECK(report["steps"] == 12);
  CHECK(report["settle_steps"] == 4);
  const auto poses = report["sigma_1"]["run"]["poses"];
  REQUIRE(poses.size() == 4);
  for (const int not_reached : {0, 1, 2}) CHECK(poses[not_reached]["max"].is_null());
  CHECK(poses[3]["max"].get<double>() > 0.5);
  CHECK_THAT(contentOf(directory.path / "done/body.pvd"), Contains("body_000015.vtp") && !Contains("body_000016.vtp"));
}

TEST_CASE("a run goes on from a checkpoint of the same garment and clock alone") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 4);
  const Outcome none = runEase(directory, "run hang.toml --resume nowhere");
  CHECK(none.code == 1);
  CHECK_THAT(none.err, Contains("nowhere: no such directory: expected that of an earlier run"));
  std::filesystem::create_directory(directory.path / "begun");
  const Outcome too_soon = runEase(directory, "run hang.toml --resume begun");
  CHECK(too_soon.code == 1);
  CHECK_THAT(too_soon.err, Contains("begun: has no checkpoint yet"));
  REQUIRE(runEase(directory, "run hang.toml -o there").code == 0);
  directory.write("hang.toml", contentOf(directory.path / "hang.toml") + "[output]\nevery = 2\n");
  const std::string report = contentOf(directory.path / "there/report.json");
  const Outcome nothing = runEase(directory, "run hang.toml --resume there -o elsewhere");
  CHECK(nothing.code == 0);
  CHECK_THAT(nothing.out, StartsWith("nothing left to do: the run in there is at the end"));
  CHECK_FALSE(std::filesystem::exists(directory.path / "elsewhere"));
  CHECK(runEase(directory, "run hang.toml --resume there").code == 0);
  CHECK(contentOf(directory.path / "there/report.json") == report);
  std::string other = contentOf(directory.path / "hang.toml");
  other.replace(other.find("steps = 4"), 9, "steps = 9, time_step = 0.001");
  directory.write("hang.toml", other);
  const Outcome clock = runEase(directory, "run hang.toml --resume there");
  CHECK(clock.code == 1);
  CHECK_THAT(clock.err, Contains("[solver] time_step was 0.0025 and is 0.001"));
  const std::string whole = contentOf(directory.path / "there/checkpoint.bin");
  directory.write("there/checkpoint.bin", whole.substr(0, whole.size() / 2));
  const Outcome cut = runEase(directory, "run hang.toml --resume there");
  CHECK(cut.code == 1);
  CHECK_THAT(cut.err, Contains("checkpoint.bin: is damaged or cut short"));
  CHECK(std::filesystem::exists(directory.path / "there/stretch.png"));
}

TEST_CASE("a run goes on with the garment that it began with, its triangles as they were") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 4);
  REQUIRE(runEase(directory, "run hang.toml -o there").code == 0);
  const std::string cloth = contentOf(directory.path / "cloth.obj");
  const auto resumeWith = [&](const std::string& before, const std::string& now) {
    std::string other = cloth;
    directory.write("cloth.obj", other.replace(other.find(before), before.size(), now));
    writeHangingScene(directory, 8);
    return runEase(directory, "run hang.toml --resume there");
  };
  for (const auto& [now, message] : {std::pair("f 2 5 1", "its triangles are not those of the run that goes on"),
                                     std::pair("f 5 9 8\nf 1 2 5", "9 vertices and 9 triangles: expected")}) {
    const Outcome outcome = resumeWith("f 1 2 5", now);
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, StartsWith("ease: error: cloth.obj: ") && Contains(message));
    CHECK(isOneLine(outcome.err));
  }
  const Outcome moved = resumeWith("v 0.2 1.0 0", "v 0.3 0.9 0");
  CHECK(moved.code == 0);
  CHECK_THAT(moved.err, StartsWith("ease: warning: cloth.obj: its vertices lie elsewhere"));
  CHECK(isOneLine(moved.err));
  const auto report = nlohmann::json::parse(contentOf(directory.path / "there/report.json"));
  CHECK(report["steps"] == 4);
  CHECK(report["rest_growth"]["max"].get<double>() == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("paint in a run that goes on scales the rest shape once, by what is more than before") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 4);
  REQUIRE(runEase(directory, "run hang.toml -o there").code == 0);
  int steps = 4;
  for (const auto& [scale, adaption] :
       {std::pair(1.2, ""), std::pair(1.2, ""), std::pair(1.5, "[adaption]\nverify = false\n"), std::pair(1.0, "")}) {
    steps += 4;
    const auto scene = writeHangingScene(directory, steps);
    std::ofstream(scene, std::ios::app) << "[[garment.paint]]\nat = [0.1, 1.1, 0]\nradius = 1\nscale = " << scale
                                        << "\n"
                                        << adaption;
    const Outcome outcome = runEase(directory, "run hang.toml --resume there");
    INFO(outcome.err << scale);
    REQUIRE(outcome.code == 0);
    const auto report = nlohmann::json::parse(contentOf(directory.path / "there/report.json"));
    CHECK(report["rest_growth"]["max"].get<double>() == Approx(scale).epsilon(0.01));
    CHECK(report["rest_growth"]["area_ratio"].get<double>() == Approx(scale * scale).epsilon(0.02));
  }
}

TEST_CASE("a run that was killed in its replays goes on with them, and leaves its series as they are") {
  const TemporaryDirectory directory;
  const auto scene = writeHangingCloth(directory, 8);
  std::ofstream(scene, std::ios::app) << "[adaption]\n[output]\nevery = 2\n";
  REQUIRE(runEase(directory, "run hang.toml -o there").code == 0);
  const auto whole = nlohmann::json::parse(contentOf(directory.path / "there/report.json"));
  const std::string series = contentOf(directory.path / "there/garment.pvd");
  std::filesystem::remove(directory.path / "there/report.json");
  REQUIRE(runEase(directory, "run hang.toml --resume there").code == 0);
  const auto report = nlohmann::json::parse(contentOf(directory.path / "there/report.json"));
  CHECK(report["resumed_from_step"] == 8);
  CHECK(report["steps"] == 0);
  CHECK(report["sigma_1"]["run"]["max"].is_null());
  CHECK(report["sigma_1"]["before"] == whole["sigma_1"]["before"]);
  CHECK(report["sigma_1"]["after"] == whole["sigma_1"]["after"]);
  CHECK(contentOf(directory.path / "there/garment.pvd") == series);
}
