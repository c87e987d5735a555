#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace asperity::multigrid
{
// While it lives, results below 1e-38 are zero on this thread. Ahead of a wave a solution decays by
// orders of magnitude from cell to cell, and many processors are very slow with numbers that small.
// Only the speed depends on it; on processors without SSE it does nothing.
class FlushDenormals
{
public:
#if defined(__SSE__)
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_to_zero); }
  ~FlushDenormals() { _mm_setcsr(before_); }
  FlushDenormals(FlushDenormals const&) = delete;
  FlushDenormals& operator=(FlushDenormals const&) = delete;

private:
  static constexpr unsigned flush_to_zero = 0x8040; // results, and operands
  unsigned before_;
#endif
};
} // namespace asperity::multigrid
