# Runs COMMAND (a list) and expects exit STATUS, MESSAGE on stderr exactly TIMES times, and an end
# within 30 s.
math(EXPR seconds "30 * $ENV{ASPERITY_TEST_TIME_FACTOR}")
execute_process(COMMAND ${COMMAND} TIMEOUT ${seconds}
  RESULT_VARIABLE status ERROR_VARIABLE errors OUTPUT_VARIABLE output)
if(NOT "${status}" MATCHES "^${STATUS}$")
  message(FATAL_ERROR "exit status '${status}' instead of '${STATUS}'\n${errors}")
endif()
string(REGEX MATCHALL "${MESSAGE}" found "${errors}")
list(LENGTH found times)
if(NOT times EQUAL TIMES)
  message(FATAL_ERROR "'${MESSAGE}' is there ${times} times instead of ${TIMES}\n${errors}")
endif()
if(QUIET AND NOT "${errors}" MATCHES "^asperity: ${MESSAGE}\n$")
  message(FATAL_ERROR "stderr says more than the message:\n${errors}")
endif()
