#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace asperity::tnnmg::detail
{
// While it lives, results below 1e-38 are zero on this thread. Ahead of a wave a solution decays by
// orders of magnitude from cell to cell, and many processors need a hundred times longer for
// numbers that small. Nothing depends on it but time; other processors go without.
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
} // namespace asperity::tnnmg::detail
