#pragma once

#include "AroundKernels.hpp" // programs that take this have no path to support

#include <Kokkos_Core.hpp>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

// A device's memory without a device: memory of the host under a type of its own. Kernels run on
// the host's core and may use it; the host outside a kernel may not and aborts when it tries, so
// that mirrors are copies, as on a device. Programs that define ASPERITY_MEMORY_SPACE as
// asperity::test::SeparateMemory have it in place of the execution space's own memory. For Kokkos 3
// with its execution space Serial, whose ways of checking accesses the specialisations change.
namespace asperity::test
{
struct SeparateMemoryName
{
  static constexpr char const* get_name() { return "Separate"; }
};
using SeparateMemory = Kokkos::Experimental::LogicalMemorySpace<
  Kokkos::HostSpace, Kokkos::Serial, SeparateMemoryName,
  Kokkos::Experimental::LogicalSpaceSharesAccess::no_shared_access>;

// How many kernels run now, one inside the other; needs watchKernels().
inline int& kernelsInFlight()
{
  static int count = 0;
  return count;
}

// The bytes of each copy between this memory and the host's, since the list was last cleared.
inline std::vector<std::size_t>& copies()
{
  static std::vector<std::size_t> bytes;
  return bytes;
}

struct CopyBytes
{
  CopyBytes(void* to, void const* from, std::size_t bytes) { std::memcpy(to, from, bytes); }
  CopyBytes(Kokkos::Serial const&, void* to, void const* from, std::size_t bytes)
      : CopyBytes(to, from, bytes)
  {
  }
};

// To be called once, after Kokkos has begun and before the memory is used.
inline void watchKernels()
{
  namespace tools = Kokkos::Tools::Experimental;
  callAroundKernels([](char const*, std::uint32_t, std::uint64_t*) { ++kernelsInFlight(); },
                    [](std::uint64_t) { --kernelsInFlight(); });
  tools::set_begin_deep_copy_callback([](Kokkos::Profiling::SpaceHandle to, char const*,
                                         void const*, Kokkos::Profiling::SpaceHandle from,
                                         char const* label, void const*, std::uint64_t size) {
    const std::string host = Kokkos::HostSpace::name(), separate = SeparateMemoryName::get_name();
    const bool crosses =
      (to.name == host && from.name == separate) || (to.name == separate && from.name == host);
    const bool is_fill = std::string(label) == "Scalar"; // Kokkos's name for a number's place
    if (crosses && !is_fill) {
      copies().push_back(size);
    }
  });
}
} // namespace asperity::test

namespace Kokkos
{
namespace Impl
{
template <>
struct MemorySpaceAccess<HostSpace, asperity::test::SeparateMemory>
{
  enum
  {
    assignable = false,
    accessible = false, // a mirror on the host is a copy
    deepcopy = true
  };
};
template <>
struct MemorySpaceAccess<asperity::test::SeparateMemory, HostSpace>
{
  enum
  {
    assignable = false,
    accessible = false,
    deepcopy = true
  };
};

// Those of Kokkos 3.4 do not take constant sources.
template <>
struct DeepCopy<HostSpace, asperity::test::SeparateMemory, Serial> : asperity::test::CopyBytes
{
  using CopyBytes::CopyBytes;
};
template <>
struct DeepCopy<asperity::test::SeparateMemory, HostSpace, Serial> : asperity::test::CopyBytes
{
  using CopyBytes::CopyBytes;
};
template <>
struct DeepCopy<asperity::test::SeparateMemory, asperity::test::SeparateMemory, Serial>
    : asperity::test::CopyBytes
{
  using CopyBytes::CopyBytes;
};

template <>
struct verify_space<HostSpace, asperity::test::SeparateMemory, false>
{
  static void check()
  {
    if (asperity::test::kernelsInFlight() == 0) {
      abort("the host reads or writes a device's memory outside a kernel");
    }
  }
};
} // namespace Impl

template <>
struct SpaceAccessibility<Serial, asperity::test::SeparateMemory>
{
  enum
  {
    assignable = false,
    accessible = true,
    deepcopy = true
  };
  using space = Device<Serial, asperity::test::SeparateMemory>;
};
} // namespace Kokkos
