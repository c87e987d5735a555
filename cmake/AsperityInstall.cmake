# `cmake --install` puts libraries, headers, programs, examples and decks into the folders of the
# GNU standard. There find_package(Asperity) gives a target for each package, as Asperity::friction.
# Installed files find each other by relative paths, so that the installation may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(ASPERITY_INSTALL_HEADERS "${CMAKE_INSTALL_INCLUDEDIR}/asperity")
set(ASPERITY_INSTALL_CMAKE "${CMAKE_INSTALL_LIBDIR}/cmake/Asperity")
set(ASPERITY_INSTALL_SHARE "${CMAKE_INSTALL_DATADIR}/asperity")
set(ASPERITY_INSTALL_DOC "${CMAKE_INSTALL_DATAROOTDIR}/doc/asperity")

function(asperity_install_package name)
  if(NOT ASPERITY_ENABLE_INSTALL)
    return()
  endif()
  set_target_properties(asperity_${name} PROPERTIES
    INSTALL_RPATH "$ORIGIN" INSTALL_RPATH_USE_LINK_PATH ON)
  install(TARGETS asperity_${name} EXPORT AsperityPackages
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
      COMPONENT programs NAMELINK_COMPONENT headers
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT headers)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/packages/${name}"
    DESTINATION "${ASPERITY_INSTALL_HEADERS}" COMPONENT headers FILES_MATCHING PATTERN "*.hpp")
endfunction()

# A driver that is left out of the build is not installed.
function(asperity_install_driver name)
  if(NOT ASPERITY_ENABLE_INSTALL OR NOT TARGET ${name})
    return()
  endif()
  file(RELATIVE_PATH to_libraries "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
  set_target_properties(${name} PROPERTIES
    INSTALL_RPATH "$ORIGIN/${to_libraries}" INSTALL_RPATH_USE_LINK_PATH ON)
  set(component programs)
  if(name STREQUAL asperity-mesh) # which links Gmsh's library, under another licence
    set(component mesh_tool)
  endif()
  install(TARGETS ${name} EXPORT AsperityPackages
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT ${component})
endfunction()

# To be called after all packages and drivers.
function(asperity_install_config)
  if(NOT ASPERITY_ENABLE_INSTALL)
    return()
  endif()
  install(EXPORT AsperityPackages NAMESPACE Asperity:: DESTINATION "${ASPERITY_INSTALL_CMAKE}"
    COMPONENT headers)
  configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/AsperityConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/AsperityConfig.cmake"
    INSTALL_DESTINATION "${ASPERITY_INSTALL_CMAKE}"
    NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file("${PROJECT_BINARY_DIR}/AsperityConfigVersion.cmake"
    COMPATIBILITY SameMinorVersion)
  install(FILES
    "${PROJECT_BINARY_DIR}/AsperityConfig.cmake"
    "${PROJECT_BINARY_DIR}/AsperityConfigVersion.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/AsperityDependencies.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/AsperityKokkos.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/AsperityPrivateDependencies.cmake"
    DESTINATION "${ASPERITY_INSTALL_CMAKE}" COMPONENT headers)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/xml/" DESTINATION "${ASPERITY_INSTALL_SHARE}/decks"
    COMPONENT programs FILES_MATCHING PATTERN "*.xml" PATTERN "*.geo")
  # The studies of the examples use the paths of decks in the source tree, xml/*.xml.
  install(CODE "file(CREATE_LINK decks \
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${ASPERITY_INSTALL_SHARE}/xml\" SYMBOLIC)"
    COMPONENT programs)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples" DESTINATION "${ASPERITY_INSTALL_SHARE}"
    COMPONENT programs)
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${ASPERITY_INSTALL_DOC}"
    COMPONENT programs)
  foreach(page IN ITEMS README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md SECURITY.md)
    install(FILES "${PROJECT_SOURCE_DIR}/${page}" DESTINATION "${ASPERITY_INSTALL_DOC}"
      COMPONENT documents)
  endforeach()
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs" DESTINATION "${ASPERITY_INSTALL_DOC}"
    COMPONENT documents FILES_MATCHING PATTERN "*.md" PATTERN "*.png")
  # The documents refer to these pages.
  file(GLOB pages RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS
    "${PROJECT_SOURCE_DIR}/packages/*/README.md" "${PROJECT_SOURCE_DIR}/python/*/README.md")
  foreach(page IN LISTS pages)
    get_filename_component(folder "${page}" DIRECTORY)
    install(FILES "${PROJECT_SOURCE_DIR}/${page}" DESTINATION "${ASPERITY_INSTALL_DOC}/${folder}"
      COMPONENT documents)
  endforeach()
endfunction()
