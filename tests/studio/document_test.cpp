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
