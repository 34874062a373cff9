#include "viz/live_surface.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "viz/poly_data.h"

namespace ease {

LiveSurface::LiveSurface(const Rgb& color) {
  normals_->SetNumberOfComponents(3);
  mapper_->SetColorModeToDirectScalars();
  mapper_->SetScalarModeToUseCellData();
  actor->SetMapper(mapper_);
  actor->GetProperty()->SetInterpolationToPhong();
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.65);
  actor->GetProperty()->SetEdgeColor(0.25, 0.3, 0.35);
  actor->GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  actor->SetVisibility(false);
}

void LiveSurface::set(const TriangleMesh& mesh) {
  triangles_ = mesh.triangles;
  data_ = toPolyData(mesh.positions, toCells(mesh.triangles));
  data_->GetPointData()->SetNormals(normals_);
  mapper_->SetInputData(data_);
  shown_.resize(0, 3);
  colors_.clear();
  ++changes;
  move(mesh.positions);
  actor->SetVisibility(triangles_.rows() > 0);
}

void LiveSurface::move(const Positions& x) {
  if (!data_ || x.rows() != data_->GetNumberOfPoints()) return;
  if (shown_.rows() == x.rows() && shown_ == x) return;  // a body that stands still costs nothing
  shown_ = x;
  ++changes;
  vtkPoints* points = data_->GetPoints();  // in double precision where they are far from the origin
  if (auto* single = vtkFloatArray::SafeDownCast(points->GetData())) {
    std::copy_n(x.data(), x.size(), single->GetPointer(0));
  } else {
    for (Eigen::Index v = 0; v < x.rows(); ++v) points->SetPoint(v, x.row(v).data());
  }
  points->GetData()->Modified();
  points->Modified();
  turnNormals(x);
  data_->Modified();
}

void LiveSurface::color(const std::vector<Rgb>& colors) {
  if (!data_ || colors == colors_) return;
  colors_ = colors;
  ++changes;
  if (static_cast<Eigen::Index>(colors.size()) != triangles_.rows()) {
    data_->GetCellData()->SetScalars(nullptr);
    mapper_->ScalarVisibilityOff();
    return;
  }
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfComponents(3);
  values->SetNumberOfTuples(static_cast<vtkIdType>(colors.size()));
  std::copy_n(colors.front().data(), 3 * colors.size(), values->GetPointer(0));
  data_->GetCellData()->SetScalars(values);
  mapper_->ScalarVisibilityOn();
}

/// Vertex normals, weighted by the areas of the triangles around.
void LiveSurface::turnNormals(const Positions& x) {
  sums_.setZero(x.rows(), 3);
  for (Eigen::Index t = 0; t < triangles_.rows(); ++t) {
    const auto corners = triangles_.row(t);
    const Vec3 normal = doubleAreaNormal(x.row(corners[0]), x.row(corners[1]), x.row(corners[2]));
    for (int k = 0; k < 3; ++k) sums_.row(corners[k]) += normal;
  }
  normals_->SetNumberOfTuples(x.rows());
  float* out = normals_->GetPointer(0);
  for (Eigen::Index v = 0; v < x.rows(); ++v) {
    const Vec3 normal = sums_.row(v).normalized();
    for (int k = 0; k < 3; ++k) *out++ = static_cast<float>(normal[k]);
  }
  normals_->Modified();
}

}  // namespace ease
