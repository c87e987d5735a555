# ASPERITY_SANITIZER: address, undefined, or both as "address,undefined". All code of Asperity is
# compiled with it, and tests set the environment variables asperity_sanitizer_environment. A
# finding ends a program with status 86, which has no other meaning.
set(ASPERITY_SANITIZER "" CACHE STRING
  "Sanitizers to compile with: address, undefined or address,undefined; empty for none")
set_property(CACHE ASPERITY_SANITIZER PROPERTY STRINGS "" address undefined address,undefined)
if(NOT ASPERITY_SANITIZER MATCHES "^(|address|undefined|address,undefined)$")
  message(FATAL_ERROR "ASPERITY_SANITIZER is '${ASPERITY_SANITIZER}'; it may be address, undefined "
    "or address,undefined, or empty for none.")
endif()

# asperity_sanitize_program(<target>): keeps libraries loaded, so that findings have their names.
function(asperity_sanitize_program target)
  if(ASPERITY_SANITIZER MATCHES "address")
    target_link_libraries(${target} PRIVATE asperity_keep_libraries)
  endif()
endfunction()

set(asperity_sanitizer_flags "")
set(asperity_sanitizer_environment "")
if(NOT ASPERITY_SANITIZER)
  return()
endif()

set(asperity_sanitizer_flags "-fsanitize=${ASPERITY_SANITIZER}")
if(ASPERITY_SANITIZER MATCHES "undefined")
  # Conversions of floating-point numbers to integers that cannot hold them. `undefined` does not
  # include them.
  string(APPEND asperity_sanitizer_flags ",float-cast-overflow")
endif()
add_compile_options(${asperity_sanitizer_flags} -fno-omit-frame-pointer
  -fno-optimize-sibling-calls)

# verify_asan_link_order: off, since tests preload a library, which comes before the sanitizer's.
# detect_stack_use_after_return: finds also uses of variables of functions that have returned.
set(asperity_asan exitcode=86 verify_asan_link_order=0 detect_stack_use_after_return=1
  check_initialization_order=1)
set(asperity_lsan exitcode=86 print_suppressions=0
  "suppressions='${PROJECT_SOURCE_DIR}/cmake/sanitizers/leaks.supp'")
# Suppressions work only where a program may continue after a finding; halt_on_error then ends it.
set(asperity_ubsan exitcode=86 halt_on_error=1 print_stacktrace=1
  "suppressions='${PROJECT_SOURCE_DIR}/cmake/sanitizers/undefined.supp'")
set(asperity_sanitizer_environment "ASPERITY_SANITIZER=${ASPERITY_SANITIZER}")
foreach(name IN ITEMS asan lsan ubsan)
  string(REPLACE ";" ":" options "${asperity_${name}}")
  string(TOUPPER "${name}" name)
  list(APPEND asperity_sanitizer_environment "${name}_OPTIONS=${options}")
endforeach()

if(ASPERITY_SANITIZER MATCHES "address")
  add_library(asperity_keep_libraries OBJECT
    "${PROJECT_SOURCE_DIR}/cmake/sanitizers/KeepLibraries.cpp")
  target_link_options(asperity_keep_libraries INTERFACE
    "LINKER:--export-dynamic-symbol=dlclose")
endif()
