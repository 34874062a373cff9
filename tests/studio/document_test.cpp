#include "apps/studio/document.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>

#include "apps/studio/parts.h"
#include "solver/base/error.h"
#include "tests/apps/temporary_directory.h"

namespace ease {
namespace {

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string withLoop(const Document& document, const char* name) {
  return withBoundary(document.text(), name, {{0.1, 1, 0}, {0, 1, 0.1}, {-0.1, 1, 0}});
}

TEST_CASE("a draft may lack a garment, and have boundaries without a region") {
  const TemporaryDirectory directory;
  Document document = Document::builtin(directory.path / "new.toml");
  CHECK(document.scene().garment.is_draft);
  document.apply(withLoop(document, "waist"), "boundary");
  CHECK(document.scene().garment.is_draft);
  document.apply(withRegion(document.text(), {0, 1.2, 0.1}), "region");
  CHECK_FALSE(document.scene().garment.is_draft);
}

TEST_CASE("a new scene on scans names those below its folder by their way from there") {
  const TemporaryDirectory directory, elsewhere;
  const std::filesystem::path scans = directory.path / "scans", t = scans / "t.ply",
                              up = elsewhere.path / "up \"2\".ply";
  const Document document = Document::onScans({t, up}, directory.path / "new.toml");
  const std::optional<BodyScene>& body = document.scene().body;
  REQUIRE(body);
  CHECK(body->builtin.empty());
  CHECK(body->poses == std::vector<std::string>{"scans/t.ply", std::filesystem::weakly_canonical(up).string()});
  CHECK(document.scene().garment.is_draft);
}

TEST_CASE("poses are added after the last one, and what was drawn stays, unsaved") {
  const TemporaryDirectory directory;
  Document document = Document::onScans({directory.path / "t.ply"}, directory.path / "new.toml");
  document.save();
  document.apply(withLoop(document, "waist"), "boundary");
  const Document more = document.withPoses({directory.path / "a.ply", directory.path / "up.ply"});
  CHECK(more.scene().body->poses == std::vector<std::string>{"t.ply", "a.ply", "up.ply"});
  CHECK(more.text().find("waist") != std::string::npos);
  CHECK_FALSE(more.isSaved());
  CHECK_FALSE(more.canUndo());
  CHECK(contentOf(Document::unsavedFile(more.file())) == document.text());  // the new poses may be refused yet
  more.keepUnsaved();
  CHECK(contentOf(Document::unsavedFile(more.file())) == more.text());
  CHECK_THROWS_AS(Document::builtin(directory.path / "own.toml").withPoses({directory.path / "a.ply"}), InputError);
}

TEST_CASE("no poses are added where a pattern names them, or the body is written in one line") {
  const TemporaryDirectory directory;
  directory.write("scan_1.ply", "");
  directory.write("scan_2.ply", "");
  const std::string by_pattern = "[body]\nposes = \"*.ply\"\n", in_line = "body = { poses = [\"scan_1.ply\"] }\n";
  for (const std::string& text : {by_pattern, in_line})
    CHECK_THROWS_AS(Document(text, directory.path / "s.toml").withPoses({directory.path / "scan_3.ply"}), InputError);
}

TEST_CASE("a scene saved in another folder, and what can be undone there, has the same scans") {
  const TemporaryDirectory directory, elsewhere;
  Document document = Document::onScans({directory.path / "t.ply"}, directory.path / "new.toml");
  document.apply(withLoop(document, "waist"), "boundary");
  document.saveAs(elsewhere.path / "moved.toml");
  const std::string scan = std::filesystem::weakly_canonical(directory.path / "t.ply").string();
  CHECK(document.scene().body->poses == std::vector<std::string>{scan});
  CHECK(contentOf(elsewhere.path / "moved.toml") == document.text());
  CHECK(document.isSaved());
  document.undo();
  CHECK(document.scene().body->poses == std::vector<std::string>{scan});
}

TEST_CASE("a new scene on the same scans takes up what a crash left unsaved") {
  const TemporaryDirectory directory;
  directory.write("t.ply", "");
  const std::vector<std::filesystem::path> scans = {directory.path / "t.ply"};
  directory.write("studio.toml", "");
  {
    Document document = Document::newOnScans(scans, directory.path);
    CHECK(document.file() == directory.path / "studio 2.toml");
    document.apply(withLoop(document, "waist"), "boundary");
  }  // as a crash would
  const Document again = Document::newOnScans(scans, directory.path);
  CHECK(again.wasRecovered());
  CHECK(again.text().find("waist") != std::string::npos);
  CHECK(again.withoutUnsaved().scene().body->poses == std::vector<std::string>{"t.ply"});
  CHECK(again.withoutUnsaved().text().find("waist") == std::string::npos);
  CHECK(Document::newOnScans({directory.path / "other.ply"}, directory.path).file() ==
        directory.path / "studio 3.toml");
}

TEST_CASE("unsaved work on another body is not undone to a body that the window does not show") {
  const TemporaryDirectory directory;
  directory.write("t.ply", "");
  const std::filesystem::path file = directory.path / "new.toml";
  {
    Document document = Document::onScans({directory.path / "t.ply"}, file);
    document.apply(withLoop(document, "waist"), "boundary");
  }  // as a crash would: it was never saved
  Document again = Document::open(file);
  CHECK(again.wasRecovered());
  CHECK(again.scene().body->poses == std::vector<std::string>{"t.ply"});
  CHECK_FALSE(again.canUndo());
  CHECK_FALSE(again.isSaved());

  std::filesystem::remove(directory.path / "t.ply");
  CHECK_FALSE(Document::open(file).wasRecovered());  // a scene whose scans are gone could not be shown
}

TEST_CASE("a new scene gets a file name that is free") {
  const TemporaryDirectory directory;
  CHECK(Document::freeFile(directory.path) == directory.path / "studio.toml");
  directory.write("studio.toml", "");
  directory.write("studio 2.toml~", "");  // unsaved work of a scene that was never saved
  CHECK(Document::freeFile(directory.path) == directory.path / "studio 3.toml");
}

TEST_CASE("a gesture that makes no scene is refused and changes nothing") {
  const TemporaryDirectory directory;
  Document document = Document::builtin(directory.path / "new.toml");
  document.apply(withLoop(document, "waist"), "boundary");
  const std::string before = document.text();
  CHECK_THROWS_AS(document.apply(withLoop(document, "waist"), "boundary"), InputError);  // the name is taken
  CHECK(document.text() == before);
  CHECK(document.undo() == "boundary");
  CHECK_FALSE(document.canUndo());
}

TEST_CASE("undo and redo go through all gestures, and a new one ends what could be done again") {
  const TemporaryDirectory directory;
  Document document = Document::builtin(directory.path / "new.toml");
  const std::string first = document.text();
  document.apply(withLoop(document, "a"), "one");
  document.apply(withLoop(document, "b"), "two");
  const std::string last = document.text();
  CHECK(document.undo() == "two");
  CHECK(document.undo() == "one");
  CHECK(document.text() == first);
  CHECK(document.redo() == "one");
  CHECK(document.redo() == "two");
  CHECK(document.text() == last);
  document.undo();
  document.apply(withLoop(document, "c"), "three");
  CHECK_FALSE(document.canRedo());
}

TEST_CASE("unsaved work survives a crash, and saving ends it") {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path / "scene.toml";
  std::string unsaved;
  {
    Document document = Document::builtin(file);
    document.save();
    document.apply(withLoop(document, "waist"), "boundary");
    unsaved = document.text();
  }  // as a crash would: nothing is saved
  Document again = Document::open(file);
  CHECK(again.wasRecovered());
  CHECK(again.text() == unsaved);
  CHECK_FALSE(again.isSaved());
  again.save();
  CHECK(contentOf(file) == unsaved);
  CHECK_FALSE(std::filesystem::exists(Document::unsavedFile(file)));
  CHECK_FALSE(Document::open(file).wasRecovered());
}

TEST_CASE("unsaved work on a new scene that was never saved survives a crash, and a refused gesture does not end it") {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path / "new.toml";
  std::string unsaved;
  {
    Document document = Document::builtin(file);
    CHECK_FALSE(document.wasRecovered());
    document.apply(withLoop(document, "waist"), "boundary");
    unsaved = document.text();
  }
  for (const bool by_name : {false, true}) {
    Document again = by_name ? Document::open(file) : Document::builtin(file);
    CHECK(again.wasRecovered());
    CHECK(again.text() == unsaved);
    again.apply(withLoop(again, "neck"), "boundary");
    again.dropLast();
    CHECK(contentOf(Document::unsavedFile(file)) == unsaved);
  }
  Document dropped = Document::builtin(file);
  dropped.undo();
  CHECK_FALSE(std::filesystem::exists(Document::unsavedFile(file)));
}

TEST_CASE("a file that is not there is refused by name") {
  CHECK_THROWS_AS(Document::open("/nowhere/scene.toml"), InputError);
}

}  // namespace
}  // namespace ease
