# SPDX-License-Identifier: GPL-3.0-or-later
# For scripts that build and run programs.

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Runs a program; its output must match the pattern.
function(expect pattern)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "Expected ${pattern}, not\n${output}")
  endif()
endfunction()

# Runs a program; its output must begin with what stands in the file.
function(expect_to_begin file)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${file} expected)
  string(FIND "${output}" "${expected}" place)
  if(NOT place EQUAL 0)
    message(FATAL_ERROR "Expected ${expected}, not\n${output}")
  endif()
endfunction()

# Runs a program that must fail with an error that matches the pattern.
function(expect_error pattern)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE errors)
  list(JOIN ARGN " " command)
  if(status EQUAL 0)
    message(FATAL_ERROR "Should have failed with ${pattern}: ${command}")
  endif()
  if(NOT errors MATCHES "${pattern}")
    message(FATAL_ERROR "Failed without ${pattern}: ${command}\n${errors}")
  endif()
endfunction()

# Runs a program that must end with the status given and say why in one line, and nothing else.
function(expect_failure status pattern)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE error RESULT_VARIABLE result)
  if(NOT result STREQUAL status OR NOT output STREQUAL "" OR NOT error MATCHES "^${pattern}\n$")
    message(FATAL_ERROR "Expected status ${status} and ${pattern}, not ${result} and\n${output}${error}")
  endif()
endfunction()
