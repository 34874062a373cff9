# find_package(ease [COMPONENTS COMPONENT...]): defines a target ease::COMPONENT for each component and those it needs.
#
#   solver      time steps of a cloth            Eigen, TBB, CHOLMOD
#   io          mesh files                       VTK
#   collision   the moving body and contact      OpenVDB
#   adaption    fitting the rest shape           OpenVDB
#   garment     tools that make a garment        OpenVDB, CGAL
#   viz         VTK series and pictures          VTK, EGL
#
# Without COMPONENTS, all that are installed.
set(ease_known solver io collision adaption garment viz)
set(ease_needs_collision solver)
set(ease_needs_io solver)
set(ease_needs_viz solver)
set(ease_needs_adaption solver collision)
set(ease_needs_garment solver collision)

set(ease_requested ${ease_FIND_COMPONENTS})
if(NOT ease_requested)
  foreach(component IN LISTS ease_known)
    if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/ease_${component}.cmake)
      list(APPEND ease_requested ${component})
    endif()
  endforeach()
endif()
set(ease_chosen "")
foreach(component IN LISTS ease_requested)
  if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/ease_${component}.cmake)
    list(APPEND ease_chosen ${ease_needs_${component}} ${component})
  elseif(ease_FIND_REQUIRED_${component})
    set(ease_FOUND FALSE)
    set(ease_NOT_FOUND_MESSAGE "ease has no component '${component}'; it may be one of: ${ease_known}")
    return()
  endif()
endforeach()
list(REMOVE_DUPLICATES ease_chosen)

set(ease_module_path ${CMAKE_MODULE_PATH})
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/EaseDependencies.cmake)
ease_find_dependencies(${ease_chosen})
set(CMAKE_MODULE_PATH ${ease_module_path})

foreach(component IN LISTS ease_chosen)
  include(${CMAKE_CURRENT_LIST_DIR}/ease_${component}.cmake)
  set(ease_${component}_FOUND TRUE)
endforeach()
