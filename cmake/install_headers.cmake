# Installs the headers below EASE_DESTINATION.  In the source tree headers include each other from its root
# ("solver/..."); the installed ones as <ease/solver/...>, so that a folder `solver` of another project cannot come in
# between.
string(REPLACE ";" "|" ease_folder_pattern "${EASE_FOLDERS}")
file(REMOVE_RECURSE ${EASE_STAGING_DIR})
foreach(folder IN LISTS EASE_FOLDERS)
  file(GLOB_RECURSE headers RELATIVE ${EASE_SOURCE_DIR} ${EASE_SOURCE_DIR}/${folder}/*.h)
  foreach(left_out IN LISTS EASE_FOLDERS_LEFT_OUT)
    list(FILTER headers EXCLUDE REGEX "^${left_out}/")
  endforeach()
  foreach(header IN LISTS headers)
    file(READ ${EASE_SOURCE_DIR}/${header} text)
    string(REGEX REPLACE "#include \"((${ease_folder_pattern})/[^\"]+)\"" "#include <ease/\\1>" text "${text}")
    file(WRITE ${EASE_STAGING_DIR}/${header} "${text}")
  endforeach()
endforeach()
file(INSTALL ${EASE_STAGING_DIR}/ DESTINATION ${EASE_DESTINATION})
