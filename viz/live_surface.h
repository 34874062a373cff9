// A mesh in a picture, with smooth shading; its points, normals and colours may change from picture to picture.  The
// actor draws what was set last and may outlive its LiveSurface.
#pragma once

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "solver/mesh/triangle_mesh.h"
#include "viz/color_scale.h"

namespace ease {

class LiveSurface {
 public:
  /// `color`: of triangles that have no colours of their own.
  explicit LiveSurface(const Rgb& color);

  /// Shows this mesh; nothing where it has no triangles.
  void set(const TriangleMesh& mesh);
  /// Moves its vertices, m.
  void move(const Positions& x);
  /// Colours for every triangle; another number of them: none.
  void color(const std::vector<Rgb>& colors);

  vtkNew<vtkActor> actor;
  long changes = 0;  // of triangles, positions and colours so far

 private:
  void turnNormals(const Positions& x);

  Triangles triangles_;
  Positions shown_, sums_;
  std::vector<Rgb> colors_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkPolyData> data_;
};

}  // namespace ease
