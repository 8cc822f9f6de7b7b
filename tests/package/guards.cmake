# SPDX-License-Identifier: GPL-3.0-or-later
# Builds that would give wrong results must fail and say why; in FOLDER:
#   cmake -D STATIC=prefix -D LIBDIR=lib -D CXX=... -D FOLDER=... -P guards.cmake
set(root ${CMAKE_CURRENT_LIST_DIR}/../..)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(MAKE_DIRECTORY ${FOLDER})

set(compile ${CXX} -std=c++20 -I${root}/cpp/include -I${root}/cpp/src/base)
set(numbers ${root}/cpp/src/numbers)

# The library with flags that change arithmetic.
foreach(flag -ffast-math -Ofast -ffinite-math-only)
  expect_error("cannot be built with -ffast-math"
    ${compile} ${flag} -ffp-contract=off -fsyntax-only ${numbers}/predicates.cpp)
endforeach()
run(${compile} -ffp-contract=off -fsyntax-only ${numbers}/predicates.cpp)

# A program that is linked with -ffast-math, so that tiny numbers are taken for zero.
set(program ${CMAKE_CURRENT_LIST_DIR}/three_circles.cpp)
set(library ${STATIC}/${LIBDIR}/libcircle_voronoi.a)
run(${compile} ${program} ${library} -o ${FOLDER}/plain)
expect("^1 vertex\n$" ${FOLDER}/plain)
if(CMAKE_HOST_SYSTEM_PROCESSOR MATCHES "x86_64|amd64|AMD64")
  run(${compile} ${program} ${library} -ffast-math -o ${FOLDER}/fast_math)
  expect("^badArithmetic\n$" ${FOLDER}/fast_math)
endif()

# A program whose containers or strings are other ones than the library's.
expect_error("needs_a_library_built_with_GLIBCXX_DEBUG"
  ${compile} -D_GLIBCXX_DEBUG ${program} ${library} -o ${FOLDER}/debug)
expect_error("needs_a_library_built_without_GLIBCXX_USE_CXX11_ABI"
  ${compile} -D_GLIBCXX_USE_CXX11_ABI=0 ${program} ${library} -o ${FOLDER}/old_strings)

# A library built with them serves such a program and no other. What tells them apart stands for the whole.
set(empty ${CMAKE_CURRENT_LIST_DIR}/empty.cpp)
run(${compile} -D_GLIBCXX_DEBUG ${root}/cpp/src/base/abi.cpp ${empty} -o ${FOLDER}/debug)
run(${compile} -D_GLIBCXX_DEBUG -c ${root}/cpp/src/base/abi.cpp -o ${FOLDER}/abi.o)
expect_error("needs_a_library_built_without_GLIBCXX_DEBUG" ${compile} ${empty} ${FOLDER}/abi.o -o ${FOLDER}/debug)
