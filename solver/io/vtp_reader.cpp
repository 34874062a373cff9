#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <exception>

#include "solver/base/error.h"
#include "solver/io/mesh_readers.h"
#include "solver/io/vtk_silence.h"

namespace ease {
namespace {

void addPolygons(vtkCellArray& polygons, const std::string& name, RawMesh& mesh) {
  std::vector<long long> corners;
  for (vtkIdType cell = 0; cell < polygons.GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    polygons.GetCellAtId(cell, count, ids);
    if (count < 3) throw InputError(fmt::format("{}: polygon {} has {} vertices", name, cell, count));
    corners.assign(ids, ids + count);
    mesh.addPolygon(corners);
  }
}

}  // namespace

RawMesh readVtp(std::string_view bytes, const std::string& name) {
  checkVtpCounts(bytes, name);
  const Silence silence;
  const vtkNew<vtkXMLPolyDataReader> reader;
  try {
    reader->ReadFromInputStringOn();
    reader->SetInputString(std::string(bytes));
    reader->Update();
  } catch (const std::exception&) {  // out of memory: its own message does not name the file
    throw InputError(fmt::format("{}: damaged: VTK found impossible counts in it", name));
  }
  if (silence.keeper->hasError()) {
    throw InputError(fmt::format("{}: not a VTP file, or damaged: {}", name, silence.keeper->firstSentence()));
  }
  vtkPolyData& data = *reader->GetOutput();
  RawMesh mesh;
  mesh.points.resize(data.GetNumberOfPoints());
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) data.GetPoint(i, mesh.points[i].data());
  addPolygons(*data.GetPolys(), name, mesh);
  for (vtkIdType strip = 0; strip < data.GetNumberOfStrips(); ++strip) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    data.GetStrips()->GetCellAtId(strip, count, ids);
    mesh.addStrip(std::vector<long long>(ids, ids + count));
  }
  return mesh;
}

}  // namespace ease
