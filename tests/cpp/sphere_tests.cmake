# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of diagrams on a sphere, with numbers of 50 digits.
add_executable(circle_voronoi_sphere_tests sphere_oracle.cpp sphere_test.cpp)
target_link_libraries(circle_voronoi_sphere_tests PRIVATE circle_voronoi_trials GTest::gtest_main)
gtest_discover_tests(circle_voronoi_sphere_tests ${discovery} NO_PRETTY_VALUES)
