#include "viz/poly_data.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>

namespace ease {

vtkSmartPointer<vtkCellArray> toCells(const Triangles& triangles) {
  vtkNew<vtkTypeInt32Array> vertices;
  vertices->SetNumberOfValues(triangles.size());
  for (Eigen::Index i = 0; i < triangles.size(); ++i) vertices->SetValue(i, triangles.data()[i]);
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(triangles.rows() + 1);
  for (Eigen::Index t = 0; t <= triangles.rows(); ++t) offsets->SetValue(t, static_cast<vtkTypeInt32>(3 * t));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, vertices);
  return cells;
}

vtkSmartPointer<vtkPolyData> toPolyData(const Positions& positions, vtkCellArray* cells) {
  // Single precision resolves a micrometre at 10 m, and half a metre at 5,000 km.
  constexpr double kFarFromOrigin = 10.0;  // m
  const bool is_far = positions.size() > 0 && positions.cwiseAbs().maxCoeff() > kFarFromOrigin;
  vtkNew<vtkPoints> points;
  points->SetDataType(is_far ? VTK_DOUBLE : VTK_FLOAT);
  points->SetNumberOfPoints(positions.rows());
  for (Eigen::Index i = 0; i < positions.rows(); ++i) points->SetPoint(i, positions.row(i).data());
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

vtkSmartPointer<vtkPolyData> toPolyLine(const std::vector<Vec3>& points, bool is_closed) {
  vtkNew<vtkPoints> places;
  for (const Vec3& x : points) places->InsertNextPoint(x.data());
  const auto count = static_cast<vtkIdType>(points.size()), ends = count + (is_closed ? 1 : 0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(ends));
  for (vtkIdType i = 0; i < ends; ++i) cells->InsertCellPoint(i % count);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(places);
  data->SetLines(cells);
  return data;
}

}  // namespace ease
