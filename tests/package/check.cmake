# SPDX-License-Identifier: GPL-3.0-or-later
# Configures, builds and runs an example as its reader does, in FOLDER:
#   cmake -D EXAMPLE=find_package -D FOLDER=... -D BUILD=build tree to install from -P check.cmake
#   cmake -D EXAMPLE=fetch_content -D FOLDER=... -P check.cmake
set(root ${CMAKE_CURRENT_LIST_DIR}/../..)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Runs a program of the example; its output must match the pattern.
function(expect pattern)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "Expected ${pattern}, not\n${output}")
  endif()
endfunction()

# Runs a program of the example that must say why it fails, in one line.
function(expect_failure status pattern)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE error RESULT_VARIABLE result)
  if(NOT result STREQUAL status OR NOT output STREQUAL "" OR NOT error MATCHES "^${pattern}\n$")
    message(FATAL_ERROR "Expected status ${status} and ${pattern}, not ${result} and\n${output}${error}")
  endif()
endfunction()

if(EXAMPLE STREQUAL find_package)
  file(REMOVE_RECURSE ${FOLDER})
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix)
  foreach(path bin/circle-voronoi share/man/man1/circle-voronoi.1 share/bash-completion/completions/circle-voronoi)
    if(NOT EXISTS ${FOLDER}/prefix/${path})
      message(FATAL_ERROR "${path} is not installed.")
    endif()
  endforeach()
  set(where CMAKE_PREFIX_PATH=${FOLDER}/prefix)
else()
  set(where FETCHCONTENT_SOURCE_DIR_CIRCLE_VORONOI=${root})
endif()

run(${CMAKE_COMMAND} -S ${root}/examples/${EXAMPLE} -B ${FOLDER}/build -G Ninja -D CMAKE_BUILD_TYPE=Debug -D ${where})
run(${CMAKE_COMMAND} --build ${FOLDER}/build)

if(EXAMPLE STREQUAL find_package)
  expect("A disc of diameter 4\\.05019 gets through, between these trees:\n63 55\n"
    ${FOLDER}/build/clearest_path ${root}/tests/fixtures/spruces.csv 28 19 30 21)
  expect_failure(1 "Cannot read missing\\.csv\\." ${FOLDER}/build/clearest_path missing.csv 28 19 30 21)
  expect_failure(1 "Cannot read ${root}\\." ${FOLDER}/build/clearest_path ${root} 28 19 30 21)
  expect_failure(2 "Not a number: 1x" ${FOLDER}/build/clearest_path ${root}/tests/fixtures/spruces.csv 28 1x 30 21)
  file(WRITE ${FOLDER}/none.csv "x,y,r\n")
  expect_failure(2 "There are no trees\\." ${FOLDER}/build/clearest_path ${FOLDER}/none.csv 28 19 30 21)
else()
  expect("circle,area,density\n0,[0-9.]+,0\\.[0-9]+\n.*\n677,"
    ${FOLDER}/build/packing_density ${root}/tests/fixtures/bronzefilter.csv)
  expect_failure(1 "Cannot read missing\\.csv\\." ${FOLDER}/build/packing_density missing.csv)
  file(GLOB_RECURSE strangers ${FOLDER}/build/*circle_voronoi_tests* ${FOLDER}/build/*circle_voronoi_cli*)
  if(strangers)
    message(FATAL_ERROR "As a subproject the library brings its tests or its program along: ${strangers}")
  endif()
endif()
