# SPDX-License-Identifier: GPL-3.0-or-later
# What find_package(circle_voronoi) finds. Nothing else is needed to use it: the headers the library is built from
# appear in no public header.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/circle_voronoi)

install(TARGETS circle_voronoi circle_voronoi_families circle_voronoi_fit circle_voronoi_io EXPORT circle_voronoi_targets)
install(DIRECTORY include/circle_voronoi include/circle_voronoi_families DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT circle_voronoi_targets
  FILE circle_voronoi-config.cmake
  NAMESPACE circle_voronoi::
  DESTINATION ${package_dir})

write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/circle_voronoi-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/circle_voronoi-config-version.cmake DESTINATION ${package_dir})

if(CIRCLE_VORONOI_BUILD_CLI)
  install(TARGETS circle_voronoi_cli)
  install(FILES cli/circle-voronoi.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  # Where bash-completion looks for the completion of a program, by its name.
  install(FILES cli/circle-voronoi.bash
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME circle-voronoi)
endif()
