#include "viz/poly_data.h"

#include <vtkFloatArray.h>
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
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(positions.rows());
  for (Eigen::Index i = 0; i < positions.size(); ++i) {
    coordinates->SetValue(i, static_cast<float>(positions.data()[i]));
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

}  // namespace ease
