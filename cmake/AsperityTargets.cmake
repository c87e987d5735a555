# A function for each kind of target.

# asperity_add_package(<name> [PACKAGES <package>...] [LIBRARIES <target>...]
#                      [PRIVATE_LIBRARIES <target>...])
#
# A library Asperity::<name> of all packages/<name>/**/*.cpp, shared unless BUILD_SHARED_LIBS is
# off. PACKAGES are the packages that it may include, LIBRARIES the external libraries that its
# headers include, PRIVATE_LIBRARIES those that only its sources include.
add_custom_target(asperity_packages)
function(asperity_add_package name)
  cmake_parse_arguments(PACKAGE "" "" "PACKAGES;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/packages/${name}/*.cpp")
  set(target asperity_${name})
  add_library(${target} ${sources})
  add_library(Asperity::${name} ALIAS ${target})
  asperity_compile_options(${target})
  set_target_properties(${target} PROPERTIES DEFINE_SYMBOL "" EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  if(NOT name IN_LIST asperity_kernel_packages)
    asperity_use_precompiled_headers(${target} libraries)
  endif()
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/packages>"
    "$<INSTALL_INTERFACE:${ASPERITY_INSTALL_HEADERS}>")
  target_compile_features(${target} PUBLIC cxx_std_17)
  # PUBLIC for programs of other projects: the sanitizer has to be their first library.
  target_link_options(${target} PUBLIC ${asperity_sanitizer_flags})
  add_dependencies(asperity_packages ${target})
  asperity_link_packages(${target} PUBLIC ${PACKAGE_PACKAGES})
  target_link_libraries(${target} PUBLIC ${PACKAGE_LIBRARIES} PRIVATE ${PACKAGE_PRIVATE_LIBRARIES})
  asperity_install_package(${name})
endfunction()

# Static libraries are linked as a whole, since the linker drops objects that only register a law or
# an output.
function(asperity_link_packages target scope)
  foreach(name IN LISTS ARGN)
    if(BUILD_SHARED_LIBS)
      target_link_libraries(${target} ${scope} asperity_${name})
    else()
      target_link_libraries(${target} ${scope} "$<LINK_LIBRARY:WHOLE_ARCHIVE,Asperity::${name}>")
    endif()
  endforeach()
endfunction()

# For all targets: those that share precompiled headers need the same options.
function(asperity_compile_options target)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow)
  if(CMAKE_UNITY_BUILD) # in a unity build GCC takes a source file for a header
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
  if(ASPERITY_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# asperity_add_driver(<name> SOURCES <file>... PACKAGES <package>... [LIBRARIES <target>...])
function(asperity_add_driver name)
  cmake_parse_arguments(DRIVER "" "" "SOURCES;PACKAGES;LIBRARIES" ${ARGN})
  add_executable(${name} ${DRIVER_SOURCES})
  asperity_compile_options(${name})
  asperity_link_packages(${name} PRIVATE ${DRIVER_PACKAGES})
  target_link_libraries(${name} PRIVATE ${DRIVER_LIBRARIES})
  asperity_sanitize_program(${name})
endfunction()
