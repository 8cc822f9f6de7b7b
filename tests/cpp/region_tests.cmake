# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of regions and fitted areas are a program of their own: most of its time to build goes into Boost.Geometry, their oracle.
add_executable(circle_voronoi_region_tests
  certified_clip_test.cpp
  clip_families.cpp
  clipped_diagram_test.cpp
  clipped_polygons_test.cpp
  dissolve_test.cpp
  distance_clip_test.cpp
  exact_bounds_test.cpp
  fit_areas_test.cpp
  fit_limits_test.cpp
  fit_periodic_test.cpp
  independent_clip.cpp
  laws_test.cpp
  meetings_test.cpp
  recompute_test.cpp
  region_shapes.cpp
  region_test.cpp
  shifted_signs_test.cpp
  treemap_test.cpp)
target_link_libraries(circle_voronoi_region_tests PRIVATE
  circle_voronoi_trials circle_voronoi::fit nlohmann_json::nlohmann_json GTest::gtest_main)
gtest_discover_tests(circle_voronoi_region_tests ${discovery} NO_PRETTY_VALUES)
if(CIRCLE_VORONOI_UNITY_BUILD)
  set_target_properties(circle_voronoi_region_tests PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
endif()
# Boost.Geometry leaves a box uninitialized that it does not read, which GCC cannot tell.
set_source_files_properties(clipped_polygons_test.cpp PROPERTIES
  SKIP_UNITY_BUILD_INCLUSION ON
  COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
set_source_files_properties(distance_clip_test.cpp independent_clip.cpp laws_test.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
# Clips for GEOS (tests/long/geos.test.mjs).
add_executable(circle_voronoi_print_clips print_clips.cpp clip_families.cpp)
target_link_libraries(circle_voronoi_print_clips PRIVATE circle_voronoi_trials nlohmann_json::nlohmann_json)
