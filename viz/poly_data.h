// Conversion of triangle meshes to VTK's data structures; only for the source files of this folder.
#pragma once

#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Converts triangles to VTK cells with 32-bit indices.
vtkSmartPointer<vtkCellArray> toCells(const Triangles& triangles);

/// Makes a VTK mesh from points, in single precision, or in double where coordinates are beyond 10 m, and `cells`,
/// which are shared and not copied.
vtkSmartPointer<vtkPolyData> toPolyData(const Positions& positions, vtkCellArray* cells);

/// Makes a VTK line through points, back to the first one if it is closed.
vtkSmartPointer<vtkPolyData> toPolyLine(const std::vector<Vec3>& points, bool is_closed);

}  // namespace ease
