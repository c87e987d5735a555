#include "scenario/run/OtherRun.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/Views.hpp"
#include "catalogue/receivers/Interpolation.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/Fingerprint.hpp"
#include "scenario/deck/CommandLine.hpp"
#include "scenario/fields/Domains.hpp"
#include "scenario/run/CarriedRock.hpp"
#include "scenario/run/Checkpoints.hpp"
#include "scenario/run/Evolution.hpp"
#include "scenario/run/WholeBodyArchive.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"
#include "scenario/setup/mesh/MeshSetup.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace asperity::scenario
{
namespace
{
using Values = std::vector<double>;

void requireSame(std::string const& what, std::string const& here, std::string const& there,
                 std::string const& run)
{
  ASPERITY_REQUIRE(here == there, what << " is '" << here << "', but '" << there
                                       << "' in the run of --restart-from " << run
                                       << ". A state goes from one to the other only if they "
                                          "are the same.");
}

// For each node of the output domain `fault`: its index among the nodes of friction.
template <int Dim>
std::vector<std::size_t> nodesOfFriction(Problem<Dim> const& problem,
                                         io::OutputDomain const& domain)
{
  auto const of_friction = problem.surface().vertices();
  std::map<int, std::size_t> places;
  for (std::size_t i = 0; i < of_friction.size(); ++i) {
    places[of_friction[i]] = i;
  }
  std::vector<std::size_t> order;
  for (const int vertex : domain.vertices) {
    order.push_back(places.at(vertex));
  }
  return order;
}

// For each vertex a point near it, inside a cell that has the vertex, which is on the side of a
// fault.
template <int Dim>
Values pointsInCells(Mesh<Dim> const& mesh, std::vector<int> const& vertices)
{
  constexpr double step = 1e-3; // of the way to the centroid
  std::vector<Point<Dim>> near = mesh.vertices;
  for (auto const& cell : mesh.cells) {
    auto const centre = mesh::centroid(mesh::corners(mesh, cell));
    for (const int vertex : cell) {
      for (int d = 0; d < Dim; ++d) {
        auto const& x = mesh.vertices[vertex];
        near[vertex][d] = x[d] + step * (centre[d] - x[d]);
      }
    }
  }
  Values points;
  for (const int vertex : vertices) {
    points.insert(points.end(), near[vertex].begin(), near[vertex].end());
  }
  return points;
}

// The unknowns at the owned nodes that give these vectors at these vertices, all that cells have.
template <int Dim>
Values unknowns(Problem<Dim> const& problem, std::vector<int> const& vertices,
                Values const& along_axes)
{
  const auto components = static_cast<std::size_t>(problem.components());
  Values vectors(problem.mesh().num_owned * components, 0);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    std::copy_n(&along_axes[i * components], components, &vectors[vertices[i] * components]);
  }
  return fem::unknownsOf(problem.discretisation.frames(), std::move(vectors));
}

Values reordered(Values const& values, std::vector<std::size_t> const& order)
{
  Values result;
  for (const std::size_t i : order) {
    result.push_back(values[i]);
  }
  return result;
}

// x + factor y
Values sum(Values x, double factor, Values const& y)
{
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] += factor * y[i];
  }
  return x;
}

// A branch of the state relaxes with its time in the whole body.
std::string timesOf(std::vector<fem::MaxwellBranch> const& branches)
{
  std::string text;
  for (auto const& branch : branches) {
    text += (text.empty() ? "" : ", ") + formatNumber(branch.time);
  }
  return text.empty() ? "none" : text;
}

template <int Dim>
void requireSameKind(Problem<Dim> const& here, Problem<Dim> const& there, std::string const& run)
{
  auto const& laws = here.settings.friction.laws;
  auto const& other_laws = there.settings.friction.laws;
  requireSame("Asperity / Friction / Law", laws.friction, other_laws.friction, run);
  requireSame("Asperity / Friction / State Evolution", laws.state, other_laws.state, run);
  requireSame("Asperity / Bulk / Model", here.settings.bulk.model(), there.settings.bulk.model(),
              run);
  requireSame("The relaxation times of the rock in s (Asperity / Bulk)",
              timesOf(here.discretisation.rock.branches),
              timesOf(there.discretisation.rock.branches), run);
  requireSame("The internal variables of the rock (Asperity / Bulk / Law)",
              internalVariables(here.model.body), internalVariables(there.model.body), run);
  const auto kindOf = [](Problem<Dim> const& problem) {
    return problem.discretisation.boundary.faults.empty()
             ? "no fault"
             : faultKindOf(problem.surface().otherSide());
  };
  requireSame("The kind of the fault (Asperity / Boundary Conditions)", kindOf(here), kindOf(there),
              run);
}

template <int Dim>
Archive checkpointOf(std::filesystem::path const& file, Problem<Dim> const& problem,
                     Domains const& domains, ParameterList const& deck)
{
  return io::readCheckpoint(file, fingerprint(deck, problem.mesh(), *problem.communicator),
                            *problem.communicator, nodeSets(problem, domains));
}

RCP<ParameterList> deckOf(std::filesystem::path const& folder)
{
  CommandLine line;
  line.deck = (folder / "parameters.xml").string();
  std::error_code ignored;
  ASPERITY_REQUIRE(std::filesystem::is_regular_file(line.deck, ignored),
                   "--restart-from: there is no " << line.deck
                                                  << ". Give the directory of a run, which has "
                                                     "parameters.xml and checkpoint.h5.");
  return readCompleteDeck(line);
}

using dynamics::FieldInfo;
using dynamics::State;

// Sets the fields of the body in the archive.
template <int Dim>
void carryBody(Problem<Dim> const& other, State const& state, io::OutputDomain const& from,
               Problem<Dim> const& problem, io::OutputDomain const& to,
               std::filesystem::path const& run, Archive& archive)
{
  std::vector<Values> there;
  State::visitBody(
    [&](FieldInfo const& info, RCP<Vector> const& field, RCP<Vector> const& start) {
      Vector carried(*field, Teuchos::Copy);
      if (info.counts_from_start) {
        carried.update(-1, *start, 1);
      }
      there.push_back(fem::alongAxes(other.discretisation.frames(), *other.discretisation.dofs,
                                     carried, from.vertices));
    },
    state, other.model.initial);
  const catalogue::Interpolation in_body(
    from, to.coordinates,
    problem.mesh().faults.empty() ? to.coordinates : pointsInCells(problem.mesh(), to.vertices),
    run.string());
  auto const here = in_body(there, problem.components());
  auto carried = here.begin();
  State::visitBody(
    [&](FieldInfo const& info, RCP<Vector> const& start) {
      auto const values = unknowns(problem, to.vertices, *carried++);
      archive.set("state/" + info.name, info.counts_from_start
                                          ? sum(values, 1, toVector(dynamics::valuesOf(start)))
                                          : values);
    },
    problem.model.initial);
}

// Sets the fields of the fault in the archive.
template <int Dim>
void carryFault(Problem<Dim> const& other, State const& state, io::OutputDomain const& from,
                Problem<Dim> const& problem, io::OutputDomain const& to,
                std::filesystem::path const& run, Archive& archive)
{
  auto const order_there = nodesOfFriction(other, from), order = nodesOfFriction(problem, to);
  const catalogue::Interpolation along_fault(from, to.coordinates, run.string());
  const auto namesOf = [](State const& run_state) {
    std::vector<std::string> names;
    for (auto const& field : run_state.added) {
      names.push_back(field.info->name);
    }
    return names;
  };
  ASPERITY_REQUIRE(namesOf(state) == namesOf(problem.model.initial),
                   "--restart-from: the processes on the fault of "
                     << run.string() << " are not those of the deck. Enable the same ones.");
  State::visitFault(
    [&](FieldInfo const& info, NodeView const& field, NodeView const& start,
        NodeView const& start_here) {
      auto const there =
        info.counts_from_start ? sum(toVector(field), -1, toVector(start)) : toVector(field);
      auto const values = along_fault({reordered(there, order_there)}, 1).front();
      Values here(order.size());
      for (std::size_t node = 0; node < values.size(); ++node) {
        here[order[node]] = values[node];
      }
      archive.set("state/" + info.name,
                  info.counts_from_start ? sum(toVector(start_here), 1, here) : here);
    },
    state, other.model.initial, problem.model.initial);
}
} // namespace

template <int Dim>
Archive stateOfOtherRun(std::filesystem::path const& run, Problem<Dim> const& problem,
                        Domains const& domains, dynamics::DyadicTime const& clock, double end)
{
  std::error_code ignored;
  ASPERITY_REQUIRE(std::filesystem::exists(run, ignored),
                   "--restart-from: there is no " << run.string()
                                                  << ". Give the directory of a run, which has "
                                                     "parameters.xml and checkpoint.h5.");
  const bool is_folder = std::filesystem::is_directory(run, ignored);
  const auto folder = is_folder ? run : run.parent_path();
  auto const other_deck = deckOf(folder.empty() ? "." : folder);
  requireSame(
    "The number of dimensions of the mesh", std::to_string(Dim),
    std::to_string(meshDimension(other_deck->sublist(deck_lists::mesh), *problem.communicator)),
    run.string());
  auto const other = makeProblem<Dim>(*other_deck, problem.communicator);
  requireSameKind(problem, other, run.string());
  auto const other_domains = makeDomains(other);
  auto const other_clock = clockOf(other);
  auto const checkpoint =
    checkpointOf(is_folder ? run / "checkpoint.h5" : run, other, other_domains, *other_deck);
  auto const state = WholeBodyArchive(other.model, nullptr, other_clock).load(checkpoint, "state");
  const double time = other_clock.seconds(state.time);
  ASPERITY_REQUIRE(time < end, "Asperity / Time Stepping / Final Time = "
                                 << end << " s is not after the state of --restart-from "
                                 << run.string() << ", which is that at t = " << time
                                 << " s. Choose a later one.");

  Archive archive;
  archive.insert("warnings", checkpoint.child("warnings"));
  archive.set("state/time", clock.reaching(time));
  carryBody(other, state, other_domains.at("volume"), problem, domains.at("volume"), run, archive);
  if (problem.model.body.cells) {
    carryRock(other, state, other_domains.at("volume"), problem, run, archive);
  }
  if (domains.count("fault") > 0) {
    carryFault(other, state, other_domains.at("fault"), problem, domains.at("fault"), run, archive);
  } else { // the state has these fields, without values
    State::visitFault(
      [&](FieldInfo const& info, NodeView const&) { archive.set("state/" + info.name, Values()); },
      problem.model.initial);
  }
  return archive;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template Archive stateOfOtherRun(std::filesystem::path const&, Problem<Dim> const&,              \
                                   Domains const&, dynamics::DyadicTime const&, double);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
