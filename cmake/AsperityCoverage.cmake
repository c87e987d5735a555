# ASPERITY_COVERAGE: all code of Asperity is compiled with gcov's counters, which
# tests/coverage/by_package.py reads after the tests.
option(ASPERITY_COVERAGE "Count with gcov which lines the tests run" OFF)
if(ASPERITY_COVERAGE)
  # Ranks of one run write to the same files; gcov locks them, but within a rank threads would race.
  add_compile_options(--coverage -fprofile-abs-path -fprofile-update=prefer-atomic)
  add_link_options(--coverage)
endif()
