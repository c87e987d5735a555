# `cmake --build build --target manual` makes the manual from docs/ as a web site in build/manual,
# by Sphinx with MyST and Breathe, and Doxygen for the API. Warnings are errors. Nothing is
# downloaded.
find_program(ASPERITY_SPHINX NAMES sphinx-build PATHS /usr/bin NO_DEFAULT_PATH)
find_program(ASPERITY_SPHINX NAMES sphinx-build)
find_program(ASPERITY_DOXYGEN NAMES doxygen)
set(ASPERITY_MANUAL_LACKS "")
if(NOT ASPERITY_SPHINX)
  list(APPEND ASPERITY_MANUAL_LACKS sphinx-build)
endif()
if(NOT ASPERITY_DOXYGEN)
  list(APPEND ASPERITY_MANUAL_LACKS doxygen)
endif()
if(ASPERITY_PYTHON)
  asperity_missing_python_modules("${ASPERITY_PYTHON}" missing myst_parser breathe furo)
  if(missing)
    list(APPEND ASPERITY_MANUAL_LACKS ${missing})
  endif()
endif()
string(REPLACE ";" ", " ASPERITY_MANUAL_LACKS "${ASPERITY_MANUAL_LACKS}")
if(ASPERITY_MANUAL_LACKS)
  set(lack "The manual cannot be built: ${ASPERITY_MANUAL_LACKS} not found. On Debian: apt-get \
install python3-sphinx python3-myst-parser python3-breathe furo doxygen")
  message(STATUS "${lack}")
  # The target says so, too: else `make: no rule` is all that a user sees.
  add_custom_target(manual
    COMMAND "${CMAKE_COMMAND}" -E echo "${lack}"
    COMMAND "${CMAKE_COMMAND}" -E echo
      "Then let CMake look for them: ${CMAKE_COMMAND} ${PROJECT_BINARY_DIR}"
    COMMAND "${CMAKE_COMMAND}" -E false VERBATIM)
  return()
endif()

set(site "${PROJECT_BINARY_DIR}/manual")
set(work "${PROJECT_BINARY_DIR}/manual_work")
configure_file("${PROJECT_SOURCE_DIR}/docs/Doxyfile.in" "${work}/Doxyfile" @ONLY)
# The pages of the API are added to a copy of docs/.
add_custom_target(manual
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${work}/pages" "${work}/xml" "${work}/doctrees"
    "${site}"
  COMMAND "${CMAKE_COMMAND}" -E copy_directory "${PROJECT_SOURCE_DIR}/docs" "${work}/pages"
  COMMAND "${ASPERITY_DOXYGEN}" "${work}/Doxyfile"
  COMMAND "${ASPERITY_PYTHON}" -B docs/api_pages.py packages "${work}/xml"
    "${work}/pages/reference/api"
  COMMAND "${CMAKE_COMMAND}" -E env "ASPERITY_VERSION=${PROJECT_VERSION}"
    "ASPERITY_DOXYGEN_XML=${work}/xml"
    "${ASPERITY_SPHINX}" -q -W --keep-going -b html -d "${work}/doctrees" "${work}/pages" "${site}"
  WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
  COMMENT "The manual: ${site}/index.html" VERBATIM)
