#include "support/HostTrap.hpp"

#include "support/AroundKernels.hpp"

#include <Kokkos_Core.hpp>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <iterator>
#include <map>
#include <string>
#include <string_view>

// Kokkos's tools and signals call functions, so that there is one trap, of this file.
namespace asperity::test
{
namespace
{
using Address = std::uintptr_t;

struct LiveView
{
  std::string label;
  std::size_t bytes = 0;
  Address end = 0;                  // of its memory
  Address first = 0, last = 0;      // the whole pages in it
  bool is_guarded = false;          // while a trap lives
  std::atomic<bool> is_open = true; // threads of a kernel open it
};

std::map<Address, LiveView> views; // by the beginning of their memory
AccessNotes notes;
bool is_armed = false;
int in_flight = 0;         // kernels and copies, one inside the other
std::vector<bool> regions; // those in progress: whether they stand for a kernel
struct sigaction action_before;

// Work that is a kernel on a device, and here one only in this sense.
bool standsForKernel(std::string_view region)
{
  // BLAS takes the place of KokkosBlas's kernels, as cuBLAS does.
  return (region.substr(0, 12) == "KokkosBlas::" && region.find("[TPL_BLAS") != region.npos) ||
         // With Serial KokkosSparse::spmv is a plain loop.
         region == "Tpetra::CrsMatrix::localApply" ||
         // With Serial Tpetra::Details::Blas::fill is memset.
         region == "Tpetra::MultiVector::putScalar" ||
         // Where kernels run on the host, chunks of rows are plain loops (multigrid::Schedule).
         region == "asperity::multigrid::chunks";
}

Address pageSize()
{
  static const auto size = static_cast<Address>(sysconf(_SC_PAGESIZE));
  return size;
}

void open(LiveView& view, bool is_open)
{
  view.is_open = is_open;
  mprotect(reinterpret_cast<void*>(view.first), view.last - view.first,
           is_open ? PROT_READ | PROT_WRITE : PROT_NONE);
}

std::map<Address, LiveView>::iterator viewAt(void const* memory)
{
  const auto address = reinterpret_cast<Address>(memory);
  const auto next = views.upper_bound(address);
  const bool is_inside = next != views.begin() && address < std::prev(next)->second.end;
  return is_inside ? std::prev(next) : views.end();
}

void onFault(int, siginfo_t* fault, void*)
{
  const auto found = viewAt(fault->si_addr);
  if (!is_armed || found == views.end() || !found->second.is_guarded) {
    sigaction(SIGSEGV, &action_before, nullptr); // for the same fault, which comes again
    return;
  }
  if (in_flight == 0) {
    notes.add(found->second.label.c_str(), found->second.bytes, false, 2);
  }
  open(found->second, true);
}

void closeAll()
{
  for (auto& [address, view] : views) {
    if (view.is_guarded && view.is_open) {
      open(view, false);
    }
  }
}

void begin() { ++in_flight; }
void end()
{
  --in_flight;
  if (is_armed && in_flight == 0) {
    closeAll();
  }
}

// Open until a kernel has ended: Kokkos initialises it first.
void addView(Kokkos::Tools::SpaceHandle, char const* label, void const* memory, std::uint64_t bytes)
{
  constexpr Address header = 128; // Kokkos's, which the host may read
  const auto address = reinterpret_cast<Address>(memory);
  auto& view = views[address];
  view.label = label;
  view.bytes = bytes;
  view.end = address + bytes;
  view.first = (address + header + pageSize() - 1) / pageSize() * pageSize();
  view.last = view.end / pageSize() * pageSize();
  view.is_guarded = is_armed && bytes > leastGuarded();
}

void removeView(Kokkos::Tools::SpaceHandle, char const*, void const* memory, std::uint64_t)
{
  const auto found = views.find(reinterpret_cast<Address>(memory));
  if (found != views.end()) {
    if (!found->second.is_open) {
      open(found->second, true);
    }
    views.erase(found);
  }
}

// A mirror that is a copy, or memory that is none of Kokkos's. A mirror that is the view itself is
// found by its pages.
bool isOfHost(void const* memory)
{
  const auto found = viewAt(memory);
  return found == views.end() || found->second.label.find("_mirror") != std::string::npos;
}

void beginCopy(Kokkos::Tools::SpaceHandle, char const* to_label, void const* to,
               Kokkos::Tools::SpaceHandle, char const* from_label, void const* from,
               std::uint64_t bytes)
{
  const std::string_view label = from_label;
  const bool is_number = label == "Scalar" || label == "(none)"; // that fills a view
  if (is_armed && in_flight == 0 && !is_number && bytes > leastGuarded() &&
      isOfHost(to) != isOfHost(from)) {
    notes.add(isOfHost(to) ? from_label : to_label, bytes, true, 1);
  }
  begin();
}

void pushRegion(char const* name)
{
  regions.push_back(standsForKernel(name));
  if (regions.back()) {
    begin();
  }
}

void popRegion()
{
  if (regions.empty()) { // it began before the watch
    return;
  }
  if (regions.back()) {
    end();
  }
  regions.pop_back();
}
} // namespace

void watchViews()
{
  namespace tools = Kokkos::Tools::Experimental;
  callAroundKernels([](char const*, std::uint32_t, std::uint64_t*) { begin(); },
                    [](std::uint64_t) { end(); });
  tools::set_begin_deep_copy_callback(beginCopy);
  tools::set_end_deep_copy_callback(end);
  tools::set_push_region_callback(pushRegion);
  tools::set_pop_region_callback(popRegion);
  tools::set_allocate_data_callback(addView);
  tools::set_deallocate_data_callback(removeView);
}

std::size_t leastGuarded() { return 2 * pageSize() + 256; } // with Kokkos's header

HostTrap::HostTrap()
{
  notes.clear();
  for (auto& [address, view] : views) {
    view.is_guarded = view.bytes > leastGuarded();
  }
  struct sigaction action = {};
  action.sa_sigaction = onFault;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSEGV, &action, &action_before);
  is_armed = true;
  closeAll();
}

HostTrap::~HostTrap()
{
  is_armed = false;
  for (auto& [address, view] : views) {
    if (!view.is_open) {
      open(view, true);
    }
    view.is_guarded = false;
  }
  sigaction(SIGSEGV, &action_before, nullptr);
}

std::vector<HostAccess> HostTrap::accesses() const { return notes.all(); }
} // namespace asperity::test
