# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of the certificate and what it rests on, and of the promise that every result is certified.
add_executable(circle_voronoi_proof_tests
  apollonius.cpp
  arithmetic_test.cpp
  automatic_test.cpp
  callbacks_test.cpp
  certificate_mutation_test.cpp
  certificate_test.cpp
  construct_test.cpp
  delaunay_test.cpp
  dual_edits.cpp
  editor_test.cpp
  estimate_test.cpp
  exact_test.cpp
  final_cells_test.cpp
  flip_test.cpp
  growth_test.cpp
  hide_test.cpp
  in_circle_test.cpp
  insert_test.cpp
  integer_test.cpp
  io_read_diagram_test.cpp
  judge_step_test.cpp
  judge_test.cpp
  metamorphic_test.cpp
  order_test.cpp
  portable_test.cpp
  predicates_test.cpp
  repair_test.cpp
  settle_ties_test.cpp
  small_duals.cpp
  step_test.cpp
  threads_test.cpp
  topology_test.cpp
  validate_test.cpp
  vertex_test.cpp
  weights_test.cpp)
target_link_libraries(circle_voronoi_proof_tests PRIVATE
  circle_voronoi_trials circle_voronoi::fit nlohmann_json::nlohmann_json GTest::gtest_main)
# Their names for exact numbers mean different types.
set_source_files_properties(estimate_test.cpp exact_test.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
gtest_discover_tests(circle_voronoi_proof_tests ${discovery} NO_PRETTY_VALUES)

# Its allocations fail, so it is a program of its own.
add_executable(circle_voronoi_allocation_tests allocation_test.cpp)
target_link_libraries(circle_voronoi_allocation_tests PRIVATE
  circle_voronoi::circle_voronoi circle_voronoi::families circle_voronoi::io circle_voronoi_options circle_voronoi_internals
  GTest::gtest_main Threads::Threads circle_voronoi::fit)
gtest_discover_tests(circle_voronoi_allocation_tests ${discovery})

# The same trials for as long as one likes.
if(CIRCLE_VORONOI_BUILD_CLI)
  add_subdirectory(${PROJECT_SOURCE_DIR}/tests/soak ${PROJECT_BINARY_DIR}/tests/soak)
endif()
