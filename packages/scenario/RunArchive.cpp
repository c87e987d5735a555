#include "scenario/RunArchive.hpp"

#include "base/Errors.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
using Values = std::vector<double>;

Values valuesOf(Vector const& x)
{
  auto const view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  return Values(view.data(), view.data() + view.extent(0));
}

Values valuesOf(friction::NodeView const& x)
{
  auto const view = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), x);
  return Values(view.data(), view.data() + view.extent(0));
}

Values const& sized(io::Archive const& archive, std::string const& path, std::size_t size)
{
  auto const& values = archive.get<Values>(path);
  ASPERITY_REQUIRE(values.size() == size, "The checkpoint holds "
                                            << values.size() << " values of '" << path
                                            << "', the problem has " << size
                                            << ". It belongs to another mesh.");
  return values;
}

void load(io::Archive const& archive, std::string const& path, Vector& x)
{
  auto const view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
  auto const& values = sized(archive, path, view.extent(0));
  std::copy(values.begin(), values.end(), view.data());
}

void load(io::Archive const& archive, std::string const& path, friction::NodeView const& x)
{
  auto const host = Kokkos::create_mirror_view(x);
  auto const& values = sized(archive, path, host.extent(0));
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(x, host);
}
} // namespace

void save(io::Archive& archive, std::string const& path, dynamics::State const& state)
{
  archive.set(path + "/time", state.time);
  archive.set(path + "/u", valuesOf(*state.u));
  archive.set(path + "/v", valuesOf(*state.v));
  archive.set(path + "/a", valuesOf(*state.a));
  archive.set(path + "/jerk", valuesOf(*state.jerk));
  archive.set(path + "/alpha", valuesOf(state.alpha));
  archive.set(path + "/sigma_n", valuesOf(state.sigma_n));
  archive.set(path + "/alpha_of_rate", valuesOf(state.alpha_of_rate));
}

dynamics::State loadState(io::Archive const& archive, std::string const& path,
                          dynamics::State const& like)
{
  auto state = like.clone();
  state.time = archive.getInteger(path + "/time");
  load(archive, path + "/u", *state.u);
  load(archive, path + "/v", *state.v);
  load(archive, path + "/a", *state.a);
  load(archive, path + "/jerk", *state.jerk);
  load(archive, path + "/alpha", state.alpha);
  load(archive, path + "/sigma_n", state.sigma_n);
  load(archive, path + "/alpha_of_rate", state.alpha_of_rate);
  return state;
}

void save(io::Archive& archive, std::string const& path, dynamics::ControlMemory const& memory)
{
  archive.set(path + "/level", memory.level);
  archive.set(path + "/level_after", memory.level_after);
  archive.set(path + "/num_steps", memory.num_steps);
  archive.set(path + "/level_before", memory.level_before);
  archive.set(path + "/error", memory.error);
  archive.set(path + "/previous_error", memory.previous_error);
  if (memory.trial) {
    archive.set(path + "/trial/iterations", memory.trial->iterations);
    save(archive, path + "/trial/state", memory.trial->state);
  }
  if (memory.before) {
    save(archive, path + "/before", *memory.before);
  }
}

dynamics::ControlMemory loadControl(io::Archive const& archive, std::string const& path,
                                    dynamics::State const& like)
{
  dynamics::ControlMemory memory;
  memory.level = static_cast<int>(archive.getInteger(path + "/level"));
  memory.level_after = static_cast<int>(archive.getInteger(path + "/level_after"));
  memory.num_steps = archive.getInteger(path + "/num_steps");
  memory.level_before = static_cast<int>(archive.getInteger(path + "/level_before"));
  memory.error = archive.getDouble(path + "/error");
  memory.previous_error = archive.getDouble(path + "/previous_error");
  if (archive.has(path + "/trial/iterations")) {
    memory.trial =
      dynamics::Trial{loadState(archive, path + "/trial/state", like),
                      static_cast<int>(archive.getInteger(path + "/trial/iterations"))};
  }
  if (archive.has(path + "/before/time")) {
    memory.before = loadState(archive, path + "/before", like);
  }
  return memory;
}

void save(io::Archive& archive, std::string const& path, dynamics::SolveCount const& count)
{
  for (auto const& [name, member] : dynamics::SolveCount::members()) {
    archive.set(path + "/" + name, count.*member);
  }
}

dynamics::SolveCount loadCount(io::Archive const& archive, std::string const& path)
{
  dynamics::SolveCount count;
  for (auto const& [name, member] : dynamics::SolveCount::members()) {
    count.*member = archive.getInteger(path + "/" + name);
  }
  return count;
}

void save(io::Archive& archive, std::string const& path, dynamics::Energy const& energy)
{
  for (auto const& [name, member] : dynamics::Energy::members()) {
    archive.set(path + "/" + name, energy.*member);
  }
}

dynamics::Energy loadEnergy(io::Archive const& archive, std::string const& path)
{
  dynamics::Energy energy;
  for (auto const& [name, member] : dynamics::Energy::members()) {
    energy.*member = archive.getDouble(path + "/" + name);
  }
  return energy;
}
} // namespace asperity::scenario
