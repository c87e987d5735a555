#pragma once

#include "support/AccessNotes.hpp"

#include <cstddef>
#include <vector>

// Finds where the host reads or writes large views outside kernels, in a build whose kernels use
// the host's own memory: on a device such a view would cross. While a trap lives, the pages of
// these views are protected. A fault within a kernel opens the view until the kernel has ended; one
// outside is noted first. So it sees libraries, too, as they are. For Linux, and for one thread
// outside kernels.
// Not seen: an access to what of a view is less than a page at its ends; a kernel of the host's own
// execution space, which looks like any other; a second access to a view before the next kernel; an
// access to a new view before the first kernel after it; a copy to a view of the host that is not
// named a mirror; what stands in the regions of standsForKernel; and a system call with a view.
namespace asperity::test
{
// Notes all views from now on. To be called once, after Kokkos has begun, before views are made.
void watchViews();

// The least size of views that a trap can guard: there is a whole page in them wherever they begin.
std::size_t leastGuarded();

class HostTrap
{
public:
  HostTrap(); // guards all views of more than leastGuarded() bytes
  ~HostTrap();
  HostTrap(HostTrap const&) = delete;
  HostTrap& operator=(HostTrap const&) = delete;

  std::vector<HostAccess> accesses() const; // so far
};
} // namespace asperity::test
