// host-access NUM_STEPS DECK.xml [--set "Path/To/Parameter=value"]...
//
// Makes the first accepted steps of a deck in space and prints, as JSON, for each rank what the
// host does with large views in the later half of them (support/HostTrap.hpp): `steps`; and what is
// found of three uses of a vector that are known: `known`.
#include "base/parallel/Gather.hpp"
#include "base/program/MpiScope.hpp"
#include "portability/Renamed.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/run/Evolution.hpp"
#include "support/HostTrap.hpp"

#include <Kokkos_Core.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace asperity::test
{
namespace
{
using Accesses = std::vector<HostAccess>;

std::string quoted(std::string text)
{
  std::replace(text.begin(), text.end(), '"', '\'');
  std::replace(text.begin(), text.end(), '\\', '/');
  return '"' + text + '"';
}

template <class Item, class Write>
std::string list(std::vector<Item> const& items, Write const& write)
{
  std::string text = "[";
  for (auto const& item : items) {
    text += (text.size() > 1 ? ", " : "") + write(item);
  }
  return text + ']';
}

std::string json(Accesses const& accesses)
{
  return list(accesses, [](HostAccess const& access) {
    std::ostringstream text;
    text << "{\"view\": " << quoted(access.view) << ", \"bytes\": " << access.bytes
         << ", \"is_copy\": " << (access.is_copy ? "true" : "false")
         << ", \"count\": " << access.count << ", \"work\": " << quoted(access.work)
         << ", \"stack\": " << list(access.stack, quoted) << '}';
    return text.str();
  });
}

// A step as asperity makes it, without outputs.
void makeStep(scenario::Evolution<3>& evolution)
{
  evolution.advance();
  evolution.updateTotals();
  evolution.watch();
}

// A kernel uses a vector, the host reads an entry, and all of it is copied to the host.
Accesses useKnownly(RCP<const Map> const& map)
{
  Vector x(map);
  const HostTrap trap;
  {
    auto const values = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
    Kokkos::parallel_for(
      "asperity::test::use", RangePolicy(0, values.extent_int(0)),
      KOKKOS_LAMBDA(int i) { values(i, 0) = i; });
  }
  {
    auto const values = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    [[maybe_unused]] const volatile double entry = values(values.extent(0) / 2, 0);
  }
  std::vector<double> copy(numLocalElements(*map));
  const Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> to(copy.data(),
                                                                             copy.size());
  Kokkos::deep_copy(
    to, Kokkos::subview(x.getLocalViewDevice(Tpetra::Access::ReadOnly), Kokkos::ALL, 0));
  return trap.accesses();
}

std::string run(int num_steps, ParameterList const& deck,
                RCP<const Communicator> const& communicator)
{
  // 1. Steps before the trap, which set up what later ones share.
  watchViews();
  auto const problem = scenario::makeProblem<3>(deck, communicator);
  scenario::Evolution<3> evolution(problem, deck, {});
  for (int i = 0; i < num_steps - num_steps / 2; ++i) {
    makeStep(evolution);
  }
  // 2. The others in the trap.
  Accesses found;
  {
    const HostTrap trap;
    for (int i = 0; i < num_steps / 2; ++i) {
      makeStep(evolution);
    }
    found = trap.accesses();
  }
  // 3. What it finds where it is known.
  auto const map = evolution.view().state->u->getMap();
  std::ostringstream text;
  text << "{\"guarded\": " << leastGuarded() << ", \"vector\": " << 8 * numLocalElements(*map)
       << ", \"steps\": " << json(found) << ", \"known\": " << json(useKnownly(map)) << '}';
  return text.str();
}
} // namespace
} // namespace asperity::test

int main(int argc, char** argv)
{
  using namespace asperity;
  setenv("TPETRA_USE_KOKKOS_PROFILING", "1", 1); // before Tpetra is used
  MpiScope parallel(argc, argv);
  auto const& communicator = parallel.communicator();
  return runGuarded(*communicator, [&] {
    if (!kernels_run_on_host) {
      std::cout << "[]\n"; // the host cannot use the memory of kernels anyway
      return int(exit_done);
    }
    const int num_steps = std::stoi(argv[1]);
    auto const deck = scenario::readCompleteDeck(parseCommandLine(argc - 1, argv + 1));
    auto const mine = test::run(num_steps, *deck, communicator);
    std::vector<char> text(mine.begin(), mine.end());
    text.push_back(communicator->getRank() + 1 < communicator->getSize() ? ',' : '\n');
    auto const all = gatherToAll(text, *communicator);
    if (communicator->getRank() == 0) {
      std::cout << '[' << std::string(all.begin(), all.end()) << "]\n";
    }
    return int(exit_done);
  });
}
