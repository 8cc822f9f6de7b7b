# SPDX-License-Identifier: GPL-3.0-or-later
# The files that find_package(circle_voronoi) and pkg-config find, and the program. Nothing else is needed to use the
# library: the headers it is built from appear in no public header. Three components: circle_voronoi_runtime (shared
# libraries), circle_voronoi_development, circle_voronoi_program.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/circle_voronoi)
set(development COMPONENT circle_voronoi_development)

install(TARGETS circle_voronoi circle_voronoi_families circle_voronoi_fit circle_voronoi_io EXPORT circle_voronoi_targets
  ARCHIVE ${development}
  LIBRARY COMPONENT circle_voronoi_runtime NAMELINK_COMPONENT circle_voronoi_development
  RUNTIME COMPONENT circle_voronoi_runtime)
install(DIRECTORY include/circle_voronoi include/circle_voronoi_families
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${development})
install(EXPORT circle_voronoi_targets
  FILE circle_voronoi-config.cmake
  NAMESPACE circle_voronoi::
  DESTINATION ${package_dir} ${development})

write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/circle_voronoi-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/circle_voronoi-config-version.cmake DESTINATION ${package_dir} ${development})

# pkg-config has a package for each library. Its paths begin at the place of the file, so that the installation can be moved.
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
foreach(folder LIBDIR INCLUDEDIR)
  cmake_path(IS_ABSOLUTE CMAKE_INSTALL_${folder} is_absolute)
  set(pc_${folder} ${CMAKE_INSTALL_${folder}})
  if(NOT is_absolute)
    file(RELATIVE_PATH pc_${folder} ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_FULL_${folder}})
    string(PREPEND pc_${folder} "\${pcfiledir}/")
  endif()
endforeach()
foreach(name circle_voronoi circle_voronoi_families circle_voronoi_fit circle_voronoi_io)
  set(pc_name ${name})
  set(pc_requires "circle_voronoi = ${PROJECT_VERSION}")
  set(pc_libs "-l${name}")
  if(name STREQUAL circle_voronoi)
    set(pc_requires "")
    string(STRIP "${pc_libs} ${CMAKE_THREAD_LIBS_INIT}" pc_libs)
  endif()
  configure_file(cmake/package.pc.in ${name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${pkgconfig_dir} ${development})
endforeach()

# Each component installs the license, because it may become a package of its own.
foreach(component runtime development program)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE
    DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT circle_voronoi_${component})
endforeach()

if(CIRCLE_VORONOI_BUILD_CLI)
  set(program COMPONENT circle_voronoi_program)
  install(TARGETS circle_voronoi_cli ${program})
  install(FILES cli/circle-voronoi.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 ${program})
  # Where bash-completion looks for the completion of a program, by its name.
  install(FILES cli/circle-voronoi.bash
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME circle-voronoi ${program})
endif()
