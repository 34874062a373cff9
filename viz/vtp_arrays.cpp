#include "viz/vtp_arrays.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "solver/base/error.h"
#include "solver/io/vtk_silence.h"

namespace ease {

VtpMesh readVtpArrays(const std::filesystem::path& file, const std::vector<std::string>& names) {
  if (!std::filesystem::is_regular_file(file)) throw InputError(fmt::format("{}: no such file", file.string()));
  const Silence silence;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  if (silence.keeper->hasError() || !data || data->GetNumberOfPoints() == 0 || data->GetNumberOfPolys() == 0)
    throw InputError(fmt::format("{}: cannot be read: expected a mesh that Ease wrote", file.string()));
  VtpMesh result;
  result.mesh.positions.resize(data->GetNumberOfPoints(), 3);
  for (vtkIdType v = 0; v < data->GetNumberOfPoints(); ++v) data->GetPoint(v, result.mesh.positions.row(v).data());
  vtkCellArray* polygons = data->GetPolys();
  result.mesh.triangles.resize(polygons->GetNumberOfCells(), 3);
  for (vtkIdType t = 0; t < polygons->GetNumberOfCells(); ++t) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    polygons->GetCellAtId(t, count, corners);
    if (count != 3) throw InputError(fmt::format("{}: a polygon has {} corners: expected 3", file.string(), count));
    for (int k = 0; k < 3; ++k) result.mesh.triangles(t, k) = static_cast<int>(corners[k]);
  }
  for (const std::string& name : names) {
    vtkDataArray* array = data->GetCellData()->GetArray(name.c_str());
    if (!array) throw InputError(fmt::format("{}: has no array '{}'", file.string(), name));
    NamedArray values{name, array->GetNumberOfComponents(), {}};
    for (vtkIdType t = 0; t < array->GetNumberOfTuples(); ++t)
      for (int k = 0; k < values.components; ++k)
        values.values.push_back(static_cast<float>(array->GetComponent(t, k)));
    result.triangle_arrays.push_back(std::move(values));
  }
  return result;
}

}  // namespace ease
