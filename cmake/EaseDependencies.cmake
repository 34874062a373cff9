# Finds the libraries that components of Ease need, both when Ease is built and when an installed Ease is used.
#
#   ease_find_dependencies(COMPONENT...)    COMPONENT: solver, io, collision, adaption, garment or viz
#
# This is a macro, so that the caller sees what find_package() sets.  TBB must be found by its own configuration before
# OpenVDB looks for it, because the module that OpenVDB brings cannot read oneTBB.
include(CMakeFindDependencyMacro)

macro(ease_find_dependencies)
  set(ease_wanted ${ARGN})
  set(ease_vtk "")
  find_dependency(Eigen3 3.4 CONFIG)
  find_dependency(TBB 2021 CONFIG)
  find_dependency(CHOLMOD)
  if(NOT "${ease_wanted}" STREQUAL "solver")
    find_dependency(fmt CONFIG)
  endif()
  if("${ease_wanted}" MATCHES "collision|adaption|garment")
    list(APPEND CMAKE_MODULE_PATH /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB)
    find_dependency(OpenVDB 10 COMPONENTS openvdb)
  endif()
  if("${ease_wanted}" MATCHES "garment")
    find_dependency(CGAL 5.5)
  endif()
  if("io" IN_LIST ease_wanted)
    list(APPEND ease_vtk CommonCore CommonDataModel IOXML)
  endif()
  if("viz" IN_LIST ease_wanted)
    list(APPEND ease_vtk
      CommonCore CommonDataModel FiltersCore IOCore IOImage IOXML
      RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2)
    find_dependency(OpenGL COMPONENTS EGL)
  endif()
  if(ease_vtk)
    list(REMOVE_DUPLICATES ease_vtk)
    find_dependency(VTK 9.1 COMPONENTS ${ease_vtk})
  endif()
endmacro()
