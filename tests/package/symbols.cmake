# SPDX-License-Identifier: GPL-3.0-or-later
# What the libraries in the packages STATIC and SHARED show to a program that has CGAL, and that program itself, with
# either, in FOLDER:
#   cmake -D STATIC=prefix -D SHARED=prefix -D LIBDIR=lib -D CXX=... -D NM=... -D FOLDER=... -P symbols.cmake
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

# The lines of `nm` with the names that the library defines.
function(defined_names result library)
  execute_process(COMMAND ${NM} -C --defined-only ${ARGN} ${library} OUTPUT_VARIABLE names COMMAND_ERROR_IS_FATAL ANY)
  set(${result} "${names}" PARENT_SCOPE)
endfunction()

defined_names(names ${STATIC}/${LIBDIR}/libcircle_voronoi.a)
if(NOT names MATCHES " T circle_voronoi::compute\\(")
  message(FATAL_ERROR "compute is not among the names of the static library.")
endif()
if(names MATCHES "\n[^\n]*[^_a-zA-Z](CGAL|boost)::[^\n]*")
  message(FATAL_ERROR "The static library has names of CGAL or Boost:${CMAKE_MATCH_0}")
endif()

# -D: those that a program sees.
defined_names(names ${SHARED}/${LIBDIR}/libcircle_voronoi.so -D)
if(NOT names MATCHES " T circle_voronoi::compute\\(")
  message(FATAL_ERROR "The shared library does not show compute.")
endif()
if(names MATCHES "\n[^\n]*[^_a-zA-Z](CGAL::|boost::|circle_voronoi::(hide|construct|flip|judge)\\()[^\n]*")
  message(FATAL_ERROR "The shared library shows what is not for others:${CMAKE_MATCH_0}")
endif()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/beside_cgal -B ${FOLDER} -G Ninja -D CMAKE_PREFIX_PATH=${STATIC})
run(${CMAKE_COMMAND} --build ${FOLDER})
run(${FOLDER}/beside_cgal)

# The same object with the shared library, for compiling it takes long.
run(${CXX} ${FOLDER}/CMakeFiles/beside_cgal.dir/beside_cgal.cpp.o -o ${FOLDER}/beside_cgal_shared
  ${SHARED}/${LIBDIR}/libcircle_voronoi.so -Wl,-rpath,${SHARED}/${LIBDIR} -lmpfr -lgmp)
run(${FOLDER}/beside_cgal_shared)
