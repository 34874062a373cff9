// Our meshes as VTK's; for the sources of this folder only.
#pragma once

#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

/// Triangles as VTK cells with 32-bit indices.
vtkSmartPointer<vtkCellArray> toCells(const Triangles& triangles);

/// Points in single precision, and `cells`, shared and not copied.
vtkSmartPointer<vtkPolyData> toPolyData(const Positions& positions, vtkCellArray* cells);

}  // namespace ease
