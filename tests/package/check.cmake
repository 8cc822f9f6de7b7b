# SPDX-License-Identifier: GPL-3.0-or-later
# Configures, builds and runs the consumer:
#   cmake -D SOURCE=installed -D FOLDER=... [-D BUILD=build tree to install from] -P check.cmake

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

if(BUILD)
  file(REMOVE_RECURSE ${FOLDER})
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix)
endif()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/${SOURCE} -B ${FOLDER}/build -G Ninja
  -D CMAKE_BUILD_TYPE=Debug -D CMAKE_PREFIX_PATH=${FOLDER}/prefix)
run(${CMAKE_COMMAND} --build ${FOLDER}/build)
run(${FOLDER}/build/consumer)
