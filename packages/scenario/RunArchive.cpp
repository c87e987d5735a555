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

// Name and member of everything in the plain structs, so that both directions agree.
constexpr std::pair<char const*, std::int64_t dynamics::SolveCount::*> count_members[] = {
  {"coupled_steps", &dynamics::SolveCount::coupled_steps},
  {"rate_problems", &dynamics::SolveCount::rate_problems},
  {"tnnmg_iterations", &dynamics::SolveCount::tnnmg_iterations},
  {"corrections", &dynamics::SolveCount::corrections},
  {"correction_iterations", &dynamics::SolveCount::correction_iterations},
  {"v_cycles", &dynamics::SolveCount::v_cycles},
  {"rises", &dynamics::SolveCount::rises},
  {"failures", &dynamics::SolveCount::failures}};

constexpr std::pair<char const*, double dynamics::Energy::*> energy_members[] = {
  {"kinetic", &dynamics::Energy::kinetic},
  {"elastic", &dynamics::Energy::elastic},
  {"load_work", &dynamics::Energy::load_work},
  {"boundary_work", &dynamics::Energy::boundary_work},
  {"friction_work", &dynamics::Energy::friction_work},
  {"viscous_work", &dynamics::Energy::viscous_work},
  {"defect", &dynamics::Energy::defect}};
} // namespace

void save(io::Archive& archive, std::string const& path, dynamics::State const& state)
{
  archive.set(path + "/time", state.time);
  archive.set(path + "/u", valuesOf(*state.u));
  archive.set(path + "/v", valuesOf(*state.v));
  archive.set(path + "/a", valuesOf(*state.a));
  archive.set(path + "/alpha", valuesOf(state.alpha));
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
  load(archive, path + "/alpha", state.alpha);
  load(archive, path + "/alpha_of_rate", state.alpha_of_rate);
  return state;
}

void save(io::Archive& archive, std::string const& path, dynamics::ControlMemory const& memory)
{
  archive.set(path + "/level", memory.level);
  archive.set(path + "/num_steps", memory.num_steps);
  if (memory.trial) {
    archive.set(path + "/trial/iterations", memory.trial->iterations);
    save(archive, path + "/trial/state", memory.trial->state);
  }
}

dynamics::ControlMemory loadControl(io::Archive const& archive, std::string const& path,
                                    dynamics::State const& like)
{
  dynamics::ControlMemory memory;
  memory.level = static_cast<int>(archive.getInteger(path + "/level"));
  memory.num_steps = archive.getInteger(path + "/num_steps");
  if (archive.has(path + "/trial/iterations")) {
    memory.trial =
      dynamics::Trial{loadState(archive, path + "/trial/state", like),
                      static_cast<int>(archive.getInteger(path + "/trial/iterations"))};
  }
  return memory;
}

void save(io::Archive& archive, std::string const& path, dynamics::SolveCount const& count)
{
  for (auto const& [name, member] : count_members) {
    archive.set(path + "/" + name, count.*member);
  }
}

dynamics::SolveCount loadCount(io::Archive const& archive, std::string const& path)
{
  dynamics::SolveCount count;
  for (auto const& [name, member] : count_members) {
    count.*member = archive.getInteger(path + "/" + name);
  }
  return count;
}

void save(io::Archive& archive, std::string const& path, dynamics::Energy const& energy)
{
  for (auto const& [name, member] : energy_members) {
    archive.set(path + "/" + name, energy.*member);
  }
}

dynamics::Energy loadEnergy(io::Archive const& archive, std::string const& path)
{
  dynamics::Energy energy;
  for (auto const& [name, member] : energy_members) {
    energy.*member = archive.getDouble(path + "/" + name);
  }
  return energy;
}
} // namespace asperity::scenario
