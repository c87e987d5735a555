# One function per kind of thing that is built.

# asperity_add_package(<name> [PACKAGES <package>...] [LIBRARIES <target>...])
#
# A shared library asperity_<name> of all packages/<name>/**/*.cpp. Shared, because a static library
# drops the objects that only register a plugin. PACKAGES is what the package may include.
function(asperity_add_package name)
  cmake_parse_arguments(PACKAGE "" "" "PACKAGES;LIBRARIES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/packages/${name}/*.cpp")
  set(target asperity_${name})
  if(sources)
    add_library(${target} SHARED ${sources})
    set(scope PUBLIC)
    asperity_compile_options(${target})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} "${PROJECT_SOURCE_DIR}/packages")
  target_compile_features(${target} ${scope} cxx_std_17)
  list(TRANSFORM PACKAGE_PACKAGES PREPEND asperity_ OUTPUT_VARIABLE packages)
  target_link_libraries(${target} ${scope} ${packages} ${PACKAGE_LIBRARIES})
endfunction()

function(asperity_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra)
  if(ASPERITY_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# asperity_add_driver(<name> SOURCES <file>... PACKAGES <package>... [LIBRARIES <target>...])
function(asperity_add_driver name)
  cmake_parse_arguments(DRIVER "" "" "SOURCES;PACKAGES;LIBRARIES" ${ARGN})
  add_executable(${name} ${DRIVER_SOURCES})
  asperity_compile_options(${name})
  list(TRANSFORM DRIVER_PACKAGES PREPEND asperity_ OUTPUT_VARIABLE packages)
  target_link_libraries(${name} PRIVATE ${packages} ${DRIVER_LIBRARIES})
endfunction()
