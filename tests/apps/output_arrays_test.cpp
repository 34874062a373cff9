// Tests that the tables of output arrays, docs/results.md and the written files agree about the names of the arrays.
#include "apps/output_arrays.h"

#include "apps/frames.h"
#include "tests/apps/command.h"
#include "tests/apps/result_check.h"
#include "tests/sheet.h"

using namespace ease;

namespace Catch {
template <>
struct StringMaker<WrittenArray> {
  static std::string convert(const WrittenArray& a) {
    return a.name + " (" + a.element + ", " + std::to_string(a.components) + ")";
  }
};
}  // namespace Catch

namespace {

using Arrays = std::vector<WrittenArray>;

// The names of the arrays that users and their ParaView state files rely on.  A change of a name breaks these files, so
// it must be mentioned in CHANGELOG.md.
const Arrays kGarmentInTheAir = {{"velocity_m_s", "vertex", 3},   {"pinned", "vertex", 1},
                                 {"sigma_1", "triangle", 1},      {"sigma_2", "triangle", 1},
                                 {"stretch_warp", "triangle", 1}, {"stretch_weft", "triangle", 1},
                                 {"shear_deg", "triangle", 1},    {"rest_area_ratio", "triangle", 1},
                                 {"rest_edges_m", "triangle", 4}};
const Arrays kGarmentOnBody = {{"velocity_m_s", "vertex", 3},
                               {"pinned", "vertex", 1},
                               {"gap_m", "vertex", 1},
                               {"contact_pressure_Pa", "vertex", 1},
                               {"sigma_1", "triangle", 1},
                               {"sigma_2", "triangle", 1},
                               {"stretch_warp", "triangle", 1},
                               {"stretch_weft", "triangle", 1},
                               {"shear_deg", "triangle", 1},
                               {"over_limit", "triangle", 1},
                               {"rest_area_ratio", "triangle", 1},
                               {"rest_edges_m", "triangle", 4}};
const Arrays kRestShape = {{"rest_area_ratio", "triangle", 1}, {"rest_edges_m", "triangle", 4}};
const Arrays kMadeGarment = {{"loop", "vertex", 1},          {"seam", "vertex", 1},   {"offset_m", "vertex", 1},
                             {"body_triangle", "vertex", 1}, {"pinned", "vertex", 1}, {"paint_scale", "triangle", 1}};
const Arrays kPieces = {{"garment_vertex", "vertex", 1}, {"piece", "triangle", 1}};

std::string nameOf(Element element) {
  return element == Element::vertex ? "vertex" : "triangle";
}

Arrays sorted(Arrays arrays) {
  std::sort(arrays.begin(), arrays.end());
  return arrays;
}

template <class Source>
Arrays declared(const std::vector<OutputArray<Source>>& table) {
  Arrays arrays;
  for (const OutputArray<Source>& row : table) arrays.push_back({row.name, nameOf(row.element), row.components});
  return arrays;
}

template <class Source>
void appendRows(const std::vector<OutputArray<Source>>& table, std::string& lines) {
  for (const OutputArray<Source>& row : table)
    lines += "| `" + row.name + "` | " + nameOf(row.element) + " | " + (row.unit.empty() ? "" : row.unit + " ") + "| " +
             row.text + " |\n";
}

/// Returns the rows of the table in docs/results.md whose first line begins with `heading`.
std::string documentedRows(const std::string& heading) {
  const std::string document = contentOf(EASE_RESULTS_DOCUMENT);
  const size_t table = document.find("\n" + heading);
  REQUIRE(table != std::string::npos);
  const size_t rows = document.find("|---|---|---|---|\n", table) + 18;
  const size_t end = document.find("\n\n", rows);
  REQUIRE(rows < end);
  return document.substr(rows, end + 1 - rows);
}

/// Returns the arrays of a series, and checks that all its frames have them.
Arrays arraysOfSeries(const std::filesystem::path& pvd) {
  const auto frames = framesListed(pvd);
  REQUIRE(frames.size() > 1);
  const Arrays arrays = arraysIn(frames.front());
  for (const auto& frame : frames) CHECK(arraysIn(frame) == arrays);
  return arrays;
}

}  // namespace

TEST_CASE("docs/results.md lists the arrays as the tables say, row by row") {
  std::string run;
  appendRows(runArrays(), run);
  appendRows(pieceArrays(), run);
  CHECK(documentedRows("| array | one for each | unit | what |") == run);
  std::string made;
  appendRows(madeGarmentArrays(), made);
  CHECK(documentedRows("| array of `garment.vtp` | one for each | unit | what |") == made);
}

TEST_CASE("the tables hold the arrays that people know, and no others") {
  CHECK(sorted(declared(runArrays())) == sorted(kGarmentOnBody));
  CHECK(sorted(declared(madeGarmentArrays())) == sorted(kMadeGarment));
  CHECK(sorted(declared(pieceArrays())) == sorted(kPieces));
}

TEST_CASE("the unit of an array is the end of its name") {
  for (const OutputArray<RunSource>& row : runArrays()) {
    INFO(row.name);
    std::string ending = row.unit.empty() ? "" : "_" + row.unit;
    std::replace(ending.begin(), ending.end(), '/', '_');
    CHECK(row.name.ends_with(ending));
  }
}

TEST_CASE("cloth sheared by s has threads that are atan(s) from a right angle") {
  const Cloth cloth(makeSheet(1, 1, 1.0, 1.0), {0.0, 1.0, 0.0}, Material());
  std::vector<Stretch> stretch;
  for (const double s : {0.0, 1.0}) {
    Mat2 F;
    F << 1.0, s, 0.0, 1.0;
    stretch.push_back(principalStretch(F.transpose() * F));
  }
  const std::vector<double> none;
  const std::vector<int> no_pins;
  const GarmentFields fields{stretch, none, none, none, no_pins, {}};
  const auto row = std::find_if(runArrays().begin(), runArrays().end(),
                                [](const OutputArray<RunSource>& array) { return array.name == "shear_deg"; });
  REQUIRE(row != runArrays().end());
  const std::vector<float> values = row->compute({cloth, cloth.restAreas(), nullptr, &fields});
  CHECK(values[0] == Approx(0.0).margin(1e-3));
  CHECK(values[1] == Approx(45.0));
}

TEST_CASE("a run without a body writes the arrays that people know, but those of contact") {
  const TemporaryDirectory directory;
  writeHangingCloth(directory, 4);
  directory.write("air.toml", contentOf(directory.path / "hang.toml") + "[output]\nevery = 1\n");
  const Outcome outcome = runEase(directory, "run air.toml -o air");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(arraysOfSeries(directory.path / "air/garment.pvd") == kGarmentInTheAir);
  CHECK(arraysOfSeries(directory.path / "air/rest.pvd") == kRestShape);
  CHECK(arraysIn(directory.path / "air/rest_shape.vtp") == kRestShape);
}

TEST_CASE("made garment, run on a body and pieces: their files hold the arrays that people know") {
  const TemporaryDirectory directory;
  directory.write(
      "tube.toml",
      "body = {builtin = 'mannequin', poses = ['t'], steps = 4}\n[garment]\nresolution = 400\n[garment.region]\n"
      "seed = [0, 1, 0.2]\n[[garment.boundary]]\nname = 'top'\nplane = {point = [0, 1.2, 0], normal = [0, 1, 0]}\n"
      "[[garment.boundary]]\nname = 'hem'\nplane = {point = [0, 0.9, 0], normal = [0, 1, 0]}\n"
      "[[garment.seam]]\nname = 'left'\nfrom = 'hem'\nto = 'top'\npoints = [[0.15, 1.05, 0]]\n"
      "[solver]\nsteps_per_pose = 1\n[adaption]\n[output]\nevery = 1\n");
  Outcome outcome = runEase(directory, "garment tube.toml --pieces -o tube");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(arraysIn(directory.path / "tube/garment.vtp") == kMadeGarment);
  CHECK(arraysIn(directory.path / "tube/pieces.vtp") == kPieces);

  outcome = runEase(directory, "run tube.toml -o tube");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(arraysOfSeries(directory.path / "tube/garment.pvd") == kGarmentOnBody);
  CHECK(arraysOfSeries(directory.path / "tube/rest.pvd") == kRestShape);
  CHECK(arraysOfSeries(directory.path / "tube/body.pvd").empty());
  CHECK(arraysIn(directory.path / "tube/rest_shape.vtp") == kRestShape);
  CHECK(arraysIn(directory.path / "tube/rest_pieces.vtp") == kPieces);
}
