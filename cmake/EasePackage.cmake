# The Debian package of the program (script/package): its man page, completion and scenes go with it, the libraries for
# programmers do not.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ease)
set(CPACK_PACKAGE_VENDOR "Ease")
set(CPACK_PACKAGE_CONTACT "The Ease project <ease@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ease)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Ease simulates a garment on a body that moves between scanned poses \
and lets the garment out where the motion would stretch it too far.")
include(CPack)
