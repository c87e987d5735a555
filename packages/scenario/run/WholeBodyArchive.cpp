#include "scenario/run/WholeBodyArchive.hpp"

#include "base/Errors.hpp"
#include "base/Views.hpp"
#include "fem/inelastic/InelasticCells.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
using Values = std::vector<double>;

char const* nodesOf(RCP<Vector> const&) { return nodes_of_body; }
char const* nodesOf(NodeView const&) { return nodes_of_friction; }
char const* nodesOf(fem::TensorView const&) { return yielding_cells; }

Values const& sized(Archive const& archive, std::string const& path, std::size_t size)
{
  auto const& values = archive.get<Values>(path);
  ASPERITY_REQUIRE(values.size() == size, "The checkpoint holds "
                                            << values.size() << " values of '" << path
                                            << "', the problem has " << size
                                            << ". It belongs to another mesh.");
  return values;
}

// How many of a field's values this rank writes: not those of cells that other ranks own.
std::size_t numOwnValues(RCP<Vector> const& field, dynamics::Body const&)
{
  return dynamics::valuesOf(field).size();
}
std::size_t numOwnValues(NodeView const& field, dynamics::Body const&) { return field.size(); }
std::size_t numOwnValues(fem::TensorView const& field, dynamics::Body const& body)
{
  return body.cells->sharing().numOwned() * field.extent(1);
}

void saveState(Archive& archive, std::string const& path, dynamics::State const& state,
               dynamics::Body const& body)
{
  archive.set(path + "/time", state.time);
  dynamics::State::visitFields(
    [&](dynamics::FieldInfo const& info, auto const& field) {
      auto const view = toHost(dynamics::valuesOf(field));
      archive.setAtNodes(path + "/" + info.name,
                         Values(view.data(), view.data() + numOwnValues(field, body)),
                         nodesOf(field));
    },
    state);
}

dynamics::State loadState(Archive const& archive, std::string const& path,
                          dynamics::Model const& model)
{
  auto state = model.initial.sameShape();
  state.time = archive.getInteger(path + "/time");
  dynamics::State::visitFields(
    [&](dynamics::FieldInfo const& info, auto const& field) {
      auto const view = dynamics::overwritten(field);
      auto const host = Kokkos::create_mirror_view(view);
      auto const& values = sized(archive, path + "/" + info.name, numOwnValues(field, model.body));
      std::copy(values.begin(), values.end(), host.data());
      Kokkos::deep_copy(view, host);
    },
    state);
  dynamics::State::visitCells(
    [&](dynamics::FieldInfo const&, auto const& field) {
      model.body.cells->sharing().exchange(field);
    },
    state);
  return state;
}
} // namespace

void WholeBodyArchive::save(Archive& archive, std::string const& path,
                            dynamics::State const& state) const
{
  if (condensation_ == nullptr) {
    saveState(archive, path, state, whole_.body);
    return;
  }
  saveState(archive, path, condensation_->expand(state), whole_.body);
  archive.set(path + "/amplitudes", condensation_->amplitudes(state));
}

dynamics::State WholeBodyArchive::load(Archive const& archive, std::string const& path) const
{
  auto state = loadState(archive, path, whole_);
  const auto time = clock_.fromLevel(state.time, stored_level_.value_or(clock_.finestLevel()));
  ASPERITY_REQUIRE(time, "The checkpoint is of a time between two steps of the smallest size. "
                         "Choose a smaller 'Time Stepping / Smallest Step', or begin a new run "
                         "from its state with --restart-from.");
  state.time = *time;
  if (condensation_ == nullptr) {
    return state;
  }
  const auto name = path + "/amplitudes";
  auto const amplitudes = archive.has(name)
                            ? sized(archive, name, condensation_->numAmplitudes())
                            : condensation_->amplitudesAt(clock_.seconds(state.time));
  return condensation_->gather(state, amplitudes);
}
} // namespace asperity::scenario
