# ASPERITY_PYTHON: the Python 3 of the programs in python/ and of the tests written in Python. It
# should have h5py, numpy and matplotlib. The system's own Python is tried first, because Debian's
# packages belong to it and another `python3` on PATH does not find them. A value given by the user
# is kept.

# Stores in the variable named by `result` those of the given modules that `python` lacks, or
# "python" if it does not run.
function(asperity_missing_python_modules python result)
  execute_process(
    COMMAND "${python}" -c
      "import importlib.util as u, sys; print(*(m for m in sys.argv[1:] if not u.find_spec(m)))"
      ${ARGN}
    OUTPUT_VARIABLE missing RESULT_VARIABLE status ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    set(missing "python")
  endif()
  set(${result} "${missing}" PARENT_SCOPE)
endfunction()

# Finds the first python3 that lacks no module, or else the first that runs.
function(asperity_find_python result)
  set(candidates /usr/bin/python3)
  string(REPLACE ":" ";" folders "$ENV{PATH}")
  list(TRANSFORM folders APPEND "/python3")
  list(APPEND candidates ${folders})
  list(REMOVE_DUPLICATES candidates)
  set(first_that_runs "")
  foreach(candidate IN LISTS candidates)
    if(EXISTS "${candidate}")
      asperity_missing_python_modules("${candidate}" missing h5py numpy matplotlib)
      if(NOT missing)
        set(${result} "${candidate}" PARENT_SCOPE)
        return()
      elseif(NOT missing STREQUAL "python" AND NOT first_that_runs)
        set(first_that_runs "${candidate}")
      endif()
    endif()
  endforeach()
  set(${result} "${first_that_runs}" PARENT_SCOPE)
endfunction()

if(NOT ASPERITY_PYTHON)
  asperity_find_python(found)
  set(ASPERITY_PYTHON "${found}" CACHE FILEPATH "Python 3 with h5py, numpy and matplotlib" FORCE)
endif()

if(NOT ASPERITY_PYTHON)
  message(WARNING "No Python 3 was found; asperity-plot needs one. Set ASPERITY_PYTHON, or "
    "on Debian: apt-get install python3 python3-h5py python3-numpy python3-matplotlib")
else()
  asperity_missing_python_modules("${ASPERITY_PYTHON}" missing h5py numpy matplotlib)
  if(missing)
    message(WARNING "${ASPERITY_PYTHON} lacks: ${missing}. asperity-plot and some tests will fail. "
      "Set ASPERITY_PYTHON to another one, or on Debian: "
      "apt-get install python3-h5py python3-numpy python3-matplotlib")
  else()
    message(STATUS "Python for figures and tests: ${ASPERITY_PYTHON}")
  endif()
endif()
