# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of regions are a program of their own: most of its time to build goes into Boost.Geometry, their oracle.
add_executable(circle_voronoi_region_tests
  clipped_diagram_test.cpp
  region_shapes.cpp
  region_test.cpp)
target_link_libraries(circle_voronoi_region_tests PRIVATE circle_voronoi_trials GTest::gtest_main)
gtest_discover_tests(circle_voronoi_region_tests DISCOVERY_MODE PRE_TEST NO_PRETTY_VALUES)
