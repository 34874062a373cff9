#include "viz/vtp.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "viz/poly_data.h"

namespace ease {

namespace {

void checkLength(const std::filesystem::path& file, const NamedArray& array, Eigen::Index tuples) {
  const auto expected = static_cast<std::size_t>(tuples) * array.components;
  if (array.components > 0 && array.values.size() == expected) return;
  throw ComputationError(fmt::format("cannot write {}: array {} has {} values, expected {} x {}", file.string(),
                                     array.name, array.values.size(), tuples, array.components));
}

void checkFits(const std::filesystem::path& file, const Triangles& triangles, const Frame& frame) {
  const auto isVertex = [&](int v) { return v >= 0 && v < frame.positions.rows(); };
  if (!std::all_of(triangles.data(), triangles.data() + triangles.size(), isVertex)) {
    throw ComputationError(fmt::format("cannot write {}: a triangle has a vertex outside 0..{}", file.string(),
                                       frame.positions.rows() - 1));
  }
  for (const NamedArray& array : frame.vertex_arrays) checkLength(file, array, frame.positions.rows());
  for (const NamedArray& array : frame.triangle_arrays) checkLength(file, array, triangles.rows());
}

void addArray(vtkDataSetAttributes* attributes, const NamedArray& array) {
  vtkNew<vtkFloatArray> values;
  values->SetName(array.name.c_str());
  values->SetNumberOfComponents(array.components);
  values->SetNumberOfTuples(static_cast<vtkIdType>(array.values.size()) / array.components);
  std::copy(array.values.begin(), array.values.end(), values->GetPointer(0));
  attributes->AddArray(values);
}

/// Records VTK's first error message, which VTK would otherwise print on the terminal.
class FirstError : public vtkCommand {
 public:
  static FirstError* New() { return new FirstError; }
  void Execute(vtkObject*, unsigned long, void* text) override {
    if (!raised && text) message = static_cast<const char*>(text);
    raised = true;
  }
  bool raised = false;
  std::string message = "VTK could not encode the mesh";
};

}  // namespace

void writeVtp(const std::filesystem::path& file, const Triangles& triangles, const Frame& frame) {
  checkFits(file, triangles, frame);
  const auto mesh = toPolyData(frame.positions, toCells(triangles));
  for (const NamedArray& array : frame.vertex_arrays) addArray(mesh->GetPointData(), array);
  for (const NamedArray& array : frame.triangle_arrays) addArray(mesh->GetCellData(), array);

  // VTK encodes the mesh in memory and writeWholeFile() writes it, because VTK's own file output does not report a
  // truncated file as an error.
  vtkNew<FirstError> error;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, error);
  writer->SetInputData(mesh);
  writer->SetDataModeToBinary();
  writer->SetHeaderTypeToUInt64();
  writer->SetCompressorTypeToLZ4();
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1 || error->raised) {
    throw ComputationError(fmt::format("cannot write {}: {}", file.string(), error->message));
  }
  writeWholeFile(file, writer->GetOutputString());
}

}  // namespace ease
