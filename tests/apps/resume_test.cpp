// Tests of resumed runs, started as a user would.
#include "apps/resume.h"

#include <nlohmann/json.hpp>

#include "solver/io/mesh_io.h"
#include "tests/apps/command.h"

using namespace ease;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("a run that is stopped and goes on gives what an unbroken one gives, to the last byte") {
  const auto [method, friction] = GENERATE(table<std::string, std::string>({{"auto", "0.3"}, {"bw1", "0"}}));
  const TemporaryDirectory directory;
  const auto write = [&, &how = method, &mu = friction](const char* name, const char* poses) {
    directory.write(
        name,
        std::string("name = 'dressed'\n[body]\nbuiltin = 'mannequin'\nposes = ") + poses +
            "\nsteps = 4\n[garment]\nbuiltin = 't-shirt'\nvertices = 400\n[[garment.pin]]\nloop = 'neck'\n"
            "[material]\nbending = 1e-6\n[adaption]\nmode = 'sequential'\nlimit = 0.02\nevery = 4\nverify = false\n"
            "[output]\nevery = 4\n[solver]\nmethod = '" +
            how + "'\n[collision]\nfriction = " + mu + "\n");
  };
  write("whole.toml", "['t', 'a', 't']");
  write("half.toml", "['t', 'a']");  // as if the run had been stopped there
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
                                   "loop = 'neck'\n[adaption]\nmode = 'sequential'\nverify = false\n" +
                                   adaption + "[output]\nevery = 2\n[solver]\nmethod = 'bw1'\n");
    return runEase(directory, "run on.toml " + arguments);
  };
  REQUIRE(resume("['t', 'a']", "cycles = 2\nsettle = 2\n", "-o done").code == 0);
  const auto made = nlohmann::json::parse(contentOf(directory.path / "done/report.json"));
  CHECK_FALSE(made.contains("resumed_from_step"));
  for (const char* other : {"['t', 'up', 't']", "['t', 'a', 'up', 't']", "['t', 't', 'a']"}) {
    const Outcome outcome = resume(other, "", "--resume done");
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, Contains("ease: error: on.toml: [body] poses: number ") &&
                                Contains("is not what the run in done met there"));
  }
  const Outcome fewer = resume("['t', 'a']", "settle = 20\n", "--resume done");
  CHECK(fewer.code == 1);
  CHECK_THAT(fewer.err, Contains("[body] poses: the motion has 2 with its cycles, and the run in done met 3"));
  CHECK(std::filesystem::exists(directory.path / "done/report.json"));

  REQUIRE(resume("['t', 'a', 't', 'up']", "settle = 4\n[collision]\noffset = 0.008\n", "--resume done").code == 0);
  const auto report = nlohmann::json::parse(contentOf(directory.path / "done/report.json"));
  CHECK(report["vertices"] == made["vertices"]);  // the T-shirt is still made for the earlier offset
  CHECK(report["resumed_from_step"] == 18);
  CHECK(report["steps"] == 12);
  CHECK(report["settle_steps"] == 4);
  const auto poses = report["sigma_1"]["run"]["poses"];
  REQUIRE(poses.size() == 4);
  for (const int not_reached : {0, 1, 2}) CHECK(poses[not_reached]["max"].is_null());
  CHECK(poses[3]["max"].get<double>() > 0.5);
  // A frame is written every two steps: the body moves to 'a' and back until frame 8, is held until 9, then moves to
  // 'up'.
  CHECK_THAT(contentOf(directory.path / "done/body.pvd"), Contains("body_000015.vtp") && !Contains("body_000016.vtp"));
  const auto moved = [&](const char* from, const char* to) {
    const auto frame = [&](const char* k) {
      return readMesh(directory.path / ("done/body/body_0000" + std::string(k) + ".vtp")).positions;
    };
    return (frame(to) - frame(from)).rowwise().norm().maxCoeff();
  };
  CHECK(moved("00", "08") < 1e-6);
  CHECK(moved("08", "09") < 1e-6);
  CHECK(moved("09", "13") > 0.5);
  CHECK(moved("09", "10") < 0.5 * moved("09", "13"));
  CHECK(moved("12", "13") < 0.5 * moved("09", "13"));
  CHECK(moved("13", "15") < 1e-6);
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
       {std::pair(1.2, ""), std::pair(1.2, ""), std::pair(1.5, "[adaption]\nmode = 'sequential'\nverify = false\n"),
        std::pair(1.0, "")}) {
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
  std::ofstream(scene, std::ios::app) << "[adaption]\nmode = 'sequential'\n[output]\nevery = 2\n";
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

TEST_CASE("poses met are told apart, and by the body's way only while it is between them") {
  Scene scene;
  scene.body.emplace();
  scene.body->steps = 10;
  scene.adaption.emplace();
  SceneInput input;
  const auto met = [&](std::vector<std::string> poses, int cycles, int moving) {
    scene.body->poses = poses;
    scene.adaption->cycles = cycles;
    input.poses.clear();
    for (const std::string& pose : poses) input.poses.push_back(Positions::Constant(2, 3, pose.front()));
    return posesMet(scene, input, {moving, moving, 0});
  };
  CHECK(met({"t", "a"}, 1, 1).size() == 2);
  CHECK(met({"t", "a"}, 2, 40).size() == 2);
  CHECK(met({"t", "a"}, 2, 41).size() == 3);
  CHECK(met({"t", "a"}, 1, 41).size() == 2);
  CHECK(met({"t"}, 1, 0).size() == 1);
  CHECK(met({"t", "a", "u"}, 1, 40) == met({"t", "a", "b"}, 1, 40));
  CHECK(met({"t", "a", "u"}, 1, 41) != met({"t", "a", "b"}, 1, 41));
  CHECK(met({"t", "a"}, 2, 80) == met({"t", "a", "t", "u"}, 1, 80));
  CHECK(met({"t", "a"}, 2, 79) != met({"t", "a", "t", "u"}, 1, 79));
}

TEST_CASE("pins that a run got while going on stay where they were put when it goes on again") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 8);
  REQUIRE(runEase(directory, "run hang.toml -o there").code == 0);
  Positions held;
  for (const int steps : {12, 16}) {
    const auto scene = writeHangingScene(directory, steps);
    std::ofstream(scene, std::ios::app) << "[[garment.pin]]\nvertices = [0]\n[output]\nevery = 4\n";
    const Outcome outcome = runEase(directory, "run hang.toml --resume there");
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const Checkpoint now = readCheckpoint(directory.path / "there/checkpoint.bin");
    const Positions garment = restored(now.run.cloth.positions, now.numbering.vertices);
    if (held.rows() > 0) CHECK(garment.row(0) == held.row(0));
    held = garment;
    CHECK((held.row(0) - now.start.mesh.positions.row(0)).norm() > 1e-5);  // the cloth had fallen before it was pinned
  }
}

TEST_CASE("a run that goes on elsewhere leaves nothing there of another run") {
  const TemporaryDirectory directory;
  const auto write = [&](int steps) {
    std::ofstream(writeHangingScene(directory, steps), std::ios::app) << "[output]\nevery = 2\n";
  };
  writeHangingCloth(directory, 8);
  write(8);
  for (const char* results : {"run hang.toml -o one", "run hang.toml -o other"})
    REQUIRE(runEase(directory, results).code == 0);
  write(12);
  REQUIRE(runEase(directory, "run hang.toml --resume one -o other").code == 0);
  const std::string series = contentOf(directory.path / "other/garment.pvd");
  CHECK_THAT(series, Contains("timestep=\"0.03\"") && !Contains("timestep=\"0.005\""));
  CHECK(readCheckpoint(directory.path / "other/checkpoint.bin").run.done.total == 12);
}

TEST_CASE("replays asked for after a run has ended are made") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 8);
  const auto write = [&](const char* verify) {
    std::ofstream(writeHangingScene(directory, 8), std::ios::app)
        << "[adaption]\nmode = 'sequential'\nverify = " << verify << "\n";
  };
  write("false");
  REQUIRE(runEase(directory, "run hang.toml -o there").code == 0);
  write("true");
  const Outcome outcome = runEase(directory, "run hang.toml --resume there");
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.out, StartsWith("9 vertices, no time step was left to do") && Contains("stretch after"));
  const auto report = nlohmann::json::parse(contentOf(directory.path / "there/report.json"));
  CHECK(report["fps"]["full"].is_null());
  CHECK(report["sigma_1"].contains("after"));
  CHECK_THAT(runEase(directory, "run hang.toml --resume there").out, StartsWith("nothing left to do"));
}
