#pragma once

#include <Kokkos_Core.hpp>

namespace asperity::test
{
// Kokkos calls begin(name, device, id) before each kernel and end(id) after it, both on the host.
template <class Begin, class End>
void callAroundKernels(Begin begin, End end)
{
  namespace tools = Kokkos::Tools::Experimental;
  tools::set_begin_parallel_for_callback(begin);
  tools::set_end_parallel_for_callback(end);
  tools::set_begin_parallel_reduce_callback(begin);
  tools::set_end_parallel_reduce_callback(end);
  tools::set_begin_parallel_scan_callback(begin);
  tools::set_end_parallel_scan_callback(end);
}
} // namespace asperity::test
