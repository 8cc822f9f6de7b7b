# SPDX-License-Identifier: GPL-3.0-or-later
# The growth tests count steps, not seconds (steps.h): the compiler adds a call to each basic block of the library.
# Sanitizers replace the same functions of the C library.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize|--coverage")
  return()
endif()
set(layers base numbers diagram sites judge dual touching_disc construct edit sphere metrics geometry regions fit families io)
add_executable(circle_voronoi_growth_tests
  growth.cpp
  growth_clip_test.cpp
  growth_compute_test.cpp
  growth_files_test.cpp
  growth_region_queries_test.cpp
  growth_regions_test.cpp
  growth_edit_test.cpp
  growth_query_test.cpp
  region_shapes.cpp
  report.cpp
  steps.cpp)
set_source_files_properties(steps.cpp PROPERTIES
  COMPILE_OPTIONS "-O2;-fno-builtin;-fno-tree-loop-distribute-patterns")
foreach(layer IN LISTS layers)
  set(counted circle_voronoi_${layer}_counted)
  get_target_property(sources circle_voronoi_${layer}_layer SOURCES)
  list(TRANSFORM sources PREPEND ${PROJECT_SOURCE_DIR}/cpp/src/)
  add_library(${counted} OBJECT ${sources})
  target_compile_options(${counted} PRIVATE -fsanitize-coverage=trace-pc)
  target_link_libraries(${counted} PRIVATE circle_voronoi_${layer}_layer)
  set_target_properties(${counted} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  target_sources(circle_voronoi_growth_tests PRIVATE $<TARGET_OBJECTS:${counted}>)
endforeach()
target_link_libraries(circle_voronoi_fit_counted PRIVATE Eigen3::Eigen)
target_compile_definitions(circle_voronoi_fit_counted PRIVATE Eigen=circle_voronoi_eigen)
target_include_directories(circle_voronoi_growth_tests PRIVATE ${PROJECT_SOURCE_DIR}/cpp/include)
target_link_libraries(circle_voronoi_growth_tests PRIVATE
  circle_voronoi_options circle_voronoi_internals GTest::gtest_main Threads::Threads)
gtest_discover_tests(circle_voronoi_growth_tests ${discovery} NO_PRETTY_VALUES)
