# SPDX-License-Identifier: GPL-3.0-or-later
# Configures, builds and runs an example as its reader does, in FOLDER, which keeps the package in FOLDER/prefix:
#   cmake -D EXAMPLE=find_package -D FOLDER=... -D BUILD=build tree to install from -P check.cmake
#   cmake -D EXAMPLE=fetch_content -D FOLDER=... -P check.cmake       with shared libraries
set(root ${CMAKE_CURRENT_LIST_DIR}/../..)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${FOLDER}/prefix)
if(EXAMPLE STREQUAL find_package)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix)
  foreach(path bin/circle-voronoi share/man/man1/circle-voronoi.1 share/bash-completion/completions/circle-voronoi)
    if(NOT EXISTS ${FOLDER}/prefix/${path})
      message(FATAL_ERROR "${path} is not installed.")
    endif()
  endforeach()
  set(options -D CMAKE_PREFIX_PATH=${FOLDER}/prefix)
else()
  # It builds the whole library once more: without what a debugger reads, in less time.
  set(options -D FETCHCONTENT_SOURCE_DIR_CIRCLE_VORONOI=${root} -D BUILD_SHARED_LIBS=ON -D CIRCLE_VORONOI_INSTALL=ON
    -D CMAKE_CXX_FLAGS_DEBUG=)
endif()

run(${CMAKE_COMMAND} -S ${root}/examples/${EXAMPLE} -B ${FOLDER}/build -G Ninja -D CMAKE_BUILD_TYPE=Debug ${options})
run(${CMAKE_COMMAND} --build ${FOLDER}/build)

if(EXAMPLE STREQUAL find_package)
  expect_to_begin(${root}/examples/find_package/clearest_path.txt
    ${FOLDER}/build/clearest_path ${root}/tests/fixtures/spruces.csv 28 19 30 21)
  expect_failure(1 "Cannot read missing\\.csv\\." ${FOLDER}/build/clearest_path missing.csv 28 19 30 21)
  expect_failure(1 "Cannot read ${root}\\." ${FOLDER}/build/clearest_path ${root} 28 19 30 21)
  expect_failure(2 "Not a number: 1x" ${FOLDER}/build/clearest_path ${root}/tests/fixtures/spruces.csv 28 1x 30 21)
  file(WRITE ${FOLDER}/none.csv "x,y,r\n")
  expect_failure(2 "There are no trees\\." ${FOLDER}/build/clearest_path ${FOLDER}/none.csv 28 19 30 21)
  expect_to_begin(${root}/examples/find_package/bouncing_discs.txt ${FOLDER}/build/bouncing_discs 30)
  expect("\nthe edits of a frame take [0-9.]+ ms, [0-9.]+ ms " ${FOLDER}/build/bouncing_discs 30)
  expect_failure(2 "Usage: bouncing_discs \\[FRAMES\\]" ${FOLDER}/build/bouncing_discs 0)
else()
  expect_to_begin(${root}/examples/fetch_content/packing_density.txt
    ${FOLDER}/build/packing_density ${root}/tests/fixtures/bronzefilter.csv)
  expect("\n677,[0-9.]+,0\\.[0-9]+\n$" ${FOLDER}/build/packing_density ${root}/tests/fixtures/bronzefilter.csv)
  expect_failure(1 "Cannot read missing\\.csv\\." ${FOLDER}/build/packing_density missing.csv)
  file(GLOB_RECURSE strangers ${FOLDER}/build/*circle_voronoi_tests* ${FOLDER}/build/*circle_voronoi_cli*)
  if(strangers)
    message(FATAL_ERROR "As a subproject the library brings its tests or its program along: ${strangers}")
  endif()
  run(${CMAKE_COMMAND} --install ${FOLDER}/build --prefix ${FOLDER}/prefix)
endif()
