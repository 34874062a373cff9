# What `cmake --install` puts where:
#
#   lib/libease_COMPONENT.a, include/ease/FOLDER/...h, lib/cmake/ease/       the libraries, with find_package(ease)
#   bin/ease, its man page, the completion of its command line, scenes, batch, licence   the program
#   bin/ease-studio, its man page, its entry in the menu of programs, where Qt is found   the editor
#
# Install component `library`, `program` or `studio` selects one of them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(EASE_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ease)
set(ease_folders "")
foreach(component IN LISTS EASE_COMPONENTS)
  install(TARGETS ease_${component} EXPORT ease_${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
  install(EXPORT ease_${component} FILE ease_${component}.cmake NAMESPACE ease::
    DESTINATION ${EASE_CONFIG_DIR} COMPONENT library)
  if(NOT component STREQUAL io)  # solver/io is in the solver's folder
    list(APPEND ease_folders ${component})
  endif()
endforeach()

set(ease_folders_left_out "")
if(NOT io IN_LIST EASE_COMPONENTS)
  set(ease_folders_left_out solver/io)
endif()
install(CODE "
  set(EASE_SOURCE_DIR \"${PROJECT_SOURCE_DIR}\")
  set(EASE_STAGING_DIR \"${PROJECT_BINARY_DIR}/installed_headers\")
  set(EASE_FOLDERS ${ease_folders})
  set(EASE_FOLDERS_LEFT_OUT ${ease_folders_left_out})
  set(EASE_DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/ease\")
  include(\"${PROJECT_SOURCE_DIR}/cmake/install_headers.cmake\")" COMPONENT library)

write_basic_package_version_file(${PROJECT_BINARY_DIR}/easeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  cmake/easeConfig.cmake cmake/EaseDependencies.cmake cmake/FindCHOLMOD.cmake
  ${PROJECT_BINARY_DIR}/easeConfigVersion.cmake
  DESTINATION ${EASE_CONFIG_DIR} COMPONENT library)

if(EASE_BUILD_APPS)
  install(TARGETS ease RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  configure_file(apps/ease.1.in ${PROJECT_BINARY_DIR}/ease.1 @ONLY)
  find_program(GZIP_PROGRAM gzip REQUIRED)
  execute_process(COMMAND ${GZIP_PROGRAM} -9nkf ${PROJECT_BINARY_DIR}/ease.1 COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${PROJECT_BINARY_DIR}/ease.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/ease COMPONENT program)
  install(FILES completions/ease.bash RENAME ease
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
  install(DIRECTORY scenes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ease/scenes COMPONENT program
    FILES_MATCHING PATTERN "*.toml")
  install(DIRECTORY batch/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ease/batch COMPONENT program
    USE_SOURCE_PERMISSIONS PATTERN "__pycache__" EXCLUDE)
  if(TARGET ease-studio)
    install(TARGETS ease-studio RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT studio)
    configure_file(apps/studio/ease-studio.1.in ${PROJECT_BINARY_DIR}/ease-studio.1 @ONLY)
    execute_process(COMMAND ${GZIP_PROGRAM} -9nkf ${PROJECT_BINARY_DIR}/ease-studio.1 COMMAND_ERROR_IS_FATAL ANY)
    install(FILES ${PROJECT_BINARY_DIR}/ease-studio.1.gz
      DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT studio)
    install(FILES apps/studio/ease-studio.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT studio)
    install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/ease-studio COMPONENT studio)
  endif()
  include(EasePackage)
endif()
