# The kernels of a step are loops of 20 to 30 bytes. Where such a loop crosses a line of the
# instruction cache, a product with a sparse matrix takes a tenth longer; and where a loop lies
# changes with each edit of its library. With this option times of different versions compare.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-falign-loops=32 ASPERITY_HAS_ALIGNED_LOOPS)
if(ASPERITY_HAS_ALIGNED_LOOPS)
  add_compile_options("$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<CONFIG:Debug>>>:-falign-loops=32>")
endif()
