#include "scenario/RunArchive.hpp"

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

Values const& sized(io::Archive const& archive, std::string const& path, std::size_t size)
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

void saveState(io::Archive& archive, std::string const& path, dynamics::State const& state,
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

dynamics::State loadState(io::Archive const& archive, std::string const& path,
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

void StateFormat::save(io::Archive& archive, std::string const& path,
                       dynamics::State const& state) const
{
  if (condensation_ == nullptr) {
    saveState(archive, path, state, whole_.body);
    return;
  }
  saveState(archive, path, condensation_->expand(state), whole_.body);
  archive.set(path + "/amplitudes", condensation_->amplitudes(state));
}

dynamics::State StateFormat::load(io::Archive const& archive, std::string const& path) const
{
  auto state = loadState(archive, path, whole_);
  if (archive.has("finest_level")) {
    const auto level = static_cast<int>(archive.getInteger("finest_level"));
    const auto time = clock_.fromLevel(state.time, level);
    ASPERITY_REQUIRE(time, "The checkpoint is of a time between two steps of the smallest size. "
                           "Choose a smaller 'Time Stepping / Smallest Step', or begin a new run "
                           "from its state with --restart-from.");
    state.time = *time;
  }
  if (condensation_ == nullptr) {
    return state;
  }
  const auto name = path + "/amplitudes";
  auto const amplitudes = archive.has(name)
                            ? sized(archive, name, 4)
                            : condensation_->amplitudesAt(clock_.seconds(state.time));
  return condensation_->gather(state, amplitudes);
}

void StateFormat::save(io::Archive& archive, std::string const& path,
                       dynamics::ControlMemory const& memory) const
{
  archive.set(path + "/level", memory.level);
  archive.set(path + "/level_after", memory.level_after);
  archive.set(path + "/num_steps", memory.num_steps);
  archive.set(path + "/level_before", memory.level_before);
  archive.set(path + "/error", memory.error);
  archive.set(path + "/previous_error", memory.previous_error);
  archive.set(path + "/largest_displacement", memory.largest_displacement);
  archive.set(path + "/largest_velocity", memory.largest_velocity);
  if (memory.trial) {
    archive.set(path + "/trial/iterations", memory.trial->iterations);
    save(archive, path + "/trial/state", memory.trial->state);
  }
  if (memory.before) {
    save(archive, path + "/before", *memory.before);
  }
}

dynamics::ControlMemory StateFormat::loadControl(io::Archive const& archive,
                                                 std::string const& path) const
{
  dynamics::ControlMemory memory;
  memory.level = static_cast<int>(archive.getInteger(path + "/level"));
  memory.level_after = static_cast<int>(archive.getInteger(path + "/level_after"));
  memory.num_steps = archive.getInteger(path + "/num_steps");
  memory.level_before = static_cast<int>(archive.getInteger(path + "/level_before"));
  memory.error = archive.getDouble(path + "/error");
  memory.previous_error = archive.getDouble(path + "/previous_error");
  if (archive.has(path + "/largest_displacement")) {
    memory.largest_displacement = archive.getDouble(path + "/largest_displacement");
    memory.largest_velocity = archive.getDouble(path + "/largest_velocity");
  }
  if (archive.has(path + "/trial/iterations")) {
    memory.trial =
      dynamics::Trial{load(archive, path + "/trial/state"),
                      static_cast<int>(archive.getInteger(path + "/trial/iterations"))};
  }
  if (archive.has(path + "/before/time")) {
    memory.before = load(archive, path + "/before");
  }
  return memory;
}
} // namespace asperity::scenario
