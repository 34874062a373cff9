# ease_library(COMPONENT SOURCE...): the static library ease_COMPONENT, which other projects link as ease::COMPONENT.
#
# Others include its headers as <ease/FOLDER/...>, in the build tree too: there `include/ease` holds links to the
# folders of the source tree.
include(GNUInstallDirs)
set(EASE_BUILD_HEADERS ${PROJECT_BINARY_DIR}/include)
foreach(folder IN ITEMS solver collision adaption garment viz)
  file(MAKE_DIRECTORY ${EASE_BUILD_HEADERS}/ease)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${EASE_BUILD_HEADERS}/ease/${folder} SYMBOLIC)
endforeach()

function(ease_library component)
  add_library(ease_${component} STATIC ${ARGN})
  add_library(ease::${component} ALIAS ease_${component})
  set_target_properties(ease_${component} PROPERTIES EXPORT_NAME ${component})
  target_compile_features(ease_${component} PUBLIC cxx_std_20)
  target_include_directories(ease_${component}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    INTERFACE $<BUILD_INTERFACE:${EASE_BUILD_HEADERS}>)
  # Eigen's types are laid out alike and its memory is allocated alike whatever the instruction set, so that a program
  # compiled with other flags can link the library.  By default both depend on the length of vectors: arrays that the
  # library allocates for AVX-512 could then not be freed by a program for SSE.
  target_compile_definitions(ease_${component} PUBLIC EIGEN_MAX_ALIGN_BYTES=64 EIGEN_MAX_STATIC_ALIGN_BYTES=16)
  ease_precompile(ease_${component})
endfunction()

# ease_precompile(TARGET HEADER...): what most sources of a target include is read once, which mostly saves two of the
# three to ten seconds of processor time that a source takes.  Every source includes what it uses all the same: the
# presets debug, asan and tsan build without, by CMAKE_DISABLE_PRECOMPILE_HEADERS.
function(ease_precompile target)
  target_precompile_headers(${target} PRIVATE <Eigen/Geometry> <Eigen/SparseCore> <algorithm> <array> <cmath>
    <filesystem> <fstream> <functional> <map> <memory> <optional> <span> <string> <vector> ${ARGN})
endfunction()
