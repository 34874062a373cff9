#include "tests/apps/result_check.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "apps/resume.h"
#include "solver/base/whole_file.h"
#include "solver/io/mesh_io.h"

namespace ease {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw std::runtime_error(fmt::format("{}: {}", file.string(), what));
}

class Errors : public vtkCommand {
 public:
  static Errors* New() { return new Errors; }
  void Execute(vtkObject*, unsigned long, void*) override { raised = true; }
  bool raised = false;
};

vtkSmartPointer<vtkPolyData> readFrame(const fs::path& file) {
  const vtkNew<Errors> errors;
  const vtkNew<vtkXMLPolyDataReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, errors);
  reader->SetReaderErrorObserver(errors);
  reader->SetParserErrorObserver(errors);
  if (!reader->CanReadFile(file.c_str())) fail(file, "VTK cannot read it");
  reader->SetFileName(file.c_str());
  reader->Update();
  if (errors->raised || reader->GetErrorCode() != 0) fail(file, "VTK reads it with errors");
  vtkPolyData& mesh = *reader->GetOutput();
  if (mesh.GetNumberOfPolys() == 0) fail(file, "has no triangles");
  for (int a = 0; a < mesh.GetPointData()->GetNumberOfArrays(); ++a)
    if (mesh.GetPointData()->GetArray(a)->GetNumberOfTuples() != mesh.GetNumberOfPoints()) fail(file, "short array");
  for (int a = 0; a < mesh.GetCellData()->GetNumberOfArrays(); ++a)
    if (mesh.GetCellData()->GetArray(a)->GetNumberOfTuples() != mesh.GetNumberOfCells()) fail(file, "short array");
  return &mesh;
}

/// Checks that the list of a series names every frame in its folder; with `killed`, one frame may be missing in it.
void checkSeries(const fs::path& pvd, bool killed) {
  const std::vector<fs::path> listed = framesListed(pvd);
  long there = 0;
  for (const auto& entry : fs::directory_iterator(pvd.parent_path() / pvd.stem()))
    there += entry.path().extension() == ".vtp" ? 1 : 0;
  if (there > std::ssize(listed) + (killed ? 1 : 0))
    fail(pvd, fmt::format("names {} frames of {}", listed.size(), there));
}

void checkFile(const fs::path& file, bool killed) {
  const std::string name = file.filename().string();
  const bool temporary = file.extension() == temporaryName("") || name.front() == '.';
  if (temporary && !killed) fail(file, "is a temporary file");
  if (temporary) return;
  const std::string kind = file.extension().string();
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string bytes = content.str();
  if (kind == ".vtp") readFrame(file);
  if (kind == ".pvd") checkSeries(file, killed);
  if (kind == ".obj") readMesh(file);
  if (kind == ".bin") readCheckpoint(file);
  if (kind == ".json" && !nlohmann::json::accept(bytes)) fail(file, "is no JSON");
  if (kind == ".png" && bytes.find("IEND", bytes.size() - 8) == std::string::npos) fail(file, "is cut short");
}

}  // namespace

std::vector<fs::path> framesListed(const fs::path& pvd) {
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(pvd.c_str()));
  vtkXMLDataElement* list = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!list) fail(pvd, "is no list of frames");
  std::vector<fs::path> files;
  double last = -1.0;
  for (int k = 0; k < list->GetNumberOfNestedElements(); ++k) {
    vtkXMLDataElement& entry = *list->GetNestedElement(k);
    double time = 0.0;
    if (!entry.GetAttribute("file") || entry.GetScalarAttribute("timestep", time) != 1) fail(pvd, "has a bare entry");
    if (time <= last) fail(pvd, "has times that do not ascend");
    last = time;
    files.push_back(pvd.parent_path() / entry.GetAttribute("file"));
    if (!fs::exists(files.back())) fail(files.back(), "is named in the list and is not there");
  }
  return files;
}

std::vector<WrittenArray> arraysIn(const fs::path& vtp) {
  const auto mesh = readFrame(vtp);
  std::vector<WrittenArray> arrays;
  const auto append = [&](vtkDataSetAttributes& attributes, const char* element) {
    for (int a = 0; a < attributes.GetNumberOfArrays(); ++a)
      arrays.push_back({attributes.GetArrayName(a), element, attributes.GetAbstractArray(a)->GetNumberOfComponents()});
  };
  append(*mesh->GetPointData(), "vertex");
  append(*mesh->GetCellData(), "triangle");
  return arrays;
}

std::string faultIn(const fs::path& directory, bool killed) {
  try {
    if (!fs::exists(directory)) return {};
    for (const auto& entry : fs::recursive_directory_iterator(directory))
      if (entry.is_regular_file()) checkFile(entry.path(), killed);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace ease
