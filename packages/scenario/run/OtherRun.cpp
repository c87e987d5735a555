#include "scenario/run/OtherRun.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/program/CommandLine.hpp"
#include "catalogue/receivers/PointLocation.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "io/checkpoint/Checkpoint.hpp"
#include "io/parallel/Gather.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/Fingerprint.hpp"
#include "scenario/OutputFields.hpp"
#include "scenario/RunArchive.hpp"
#include "scenario/setup/MeshSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <algorithm>
#include <vector>

namespace asperity::scenario
{
namespace
{
using Values = std::vector<double>;
using Domains = std::map<std::string, io::OutputDomain>;

void requireSame(std::string const& what, std::string const& here, std::string const& there,
                 std::string const& run)
{
  ASPERITY_REQUIRE(here == there, what << " is '" << here << "', but '" << there
                                       << "' in the run of --restart-from " << run
                                       << ". A state goes from one to the other only between "
                                          "problems of the same kind.");
}

// Values at the nodes of a domain of the other run, at the nodes of the new run's domain.
class Interpolation
{
public:
  Interpolation(io::OutputDomain const& from, io::OutputDomain const& to, std::string const& run)
      : from_(from)
      , to_(to)
      , run_(run)
  {
  }

  // Fields of (num_owned, components) each, in the order of the nodes of the domains. All at once,
  // since it takes longest to find the points.
  std::vector<Values> operator()(std::vector<Values> const& fields, int components) const
  {
    constexpr std::size_t points_at_once = 4096; // bounds what ranks know of each other's points
    const int rank = to_.comm->getRank(), num_ranks = to_.comm->getSize();
    std::vector<Values> result(fields.size());
    for (int of = 0; of < num_ranks; ++of) {
      const auto size = maxOverRanks(rank == of ? GlobalOrdinal(to_.numOwned()) : 0, *to_.comm);
      for (std::size_t first = 0; first < static_cast<std::size_t>(size); first += points_at_once) {
        const auto last = std::min(first + points_at_once, static_cast<std::size_t>(size));
        const auto located = find(rank == of ? pointsOf(first, last) : Values());
        const catalogue::Sampling sampling(from_, located);
        for (std::size_t i = 0; i < fields.size(); ++i) {
          auto const values = sampling(fields[i], components);
          if (rank == of) {
            result[i].insert(result[i].end(), values.begin(), values.end());
          }
        }
      }
    }
    return result;
  }

private:
  Values pointsOf(std::size_t first, std::size_t last) const
  {
    const auto d = static_cast<std::ptrdiff_t>(to_.dimension);
    return {to_.coordinates.begin() + static_cast<std::ptrdiff_t>(first) * d,
            to_.coordinates.begin() + static_cast<std::ptrdiff_t>(last) * d};
  }

  // points: of one rank.
  std::vector<catalogue::LocatedPoint> find(Values const& points) const
  {
    constexpr double tolerance = 0.1; // of an element: chords of a curved boundary lie so far apart
    auto const all = io::gatherToAll(points, *to_.comm);
    auto const located = catalogue::locate(from_, all);
    for (std::size_t i = 0; i < located.size(); ++i) {
      ASPERITY_REQUIRE(located[i].distance <= tolerance * located[i].element_size,
                       "The point " << text(&all[i * to_.dimension]) << " of the " << to_.name
                                    << " is " << formatShort(located[i].distance)
                                    << " m outside that of the run of --restart-from " << run_
                                    << ", which has no values there. Give both the same extent.");
    }
    return located;
  }

  std::string text(double const* point) const
  {
    std::string words = "(";
    for (int d = 0; d < to_.dimension; ++d) {
      words += (d > 0 ? ", " : "") + formatShort(point[d]);
    }
    return words + ")";
  }

  io::OutputDomain const& from_;
  io::OutputDomain const& to_;
  std::string run_;
};

// The places, among the nodes of friction, of the nodes of the fault as a domain.
template <int Dim>
std::vector<std::size_t> nodesOfFriction(Problem<Dim> const& problem,
                                         io::OutputDomain const& domain)
{
  auto const of_friction = problem.surface->vertices();
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

template <int Dim>
Values inFrames(Problem<Dim> const& problem, Values along_axes)
{
  auto const& frames = problem.constraints->frames();
  Values result(along_axes.size());
  for (int node = 0; node < problem.mesh.num_owned; ++node) {
    const auto first = static_cast<std::size_t>(node) * problem.components;
    frames.toFrame(node, &along_axes[first], &result[first]);
  }
  return result;
}

Values onHost(friction::NodeView const& x)
{
  auto const view = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), x);
  return Values(view.data(), view.data() + view.extent(0));
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

template <int Dim>
void requireSameKind(Problem<Dim> const& here, ParameterList const& deck, Problem<Dim> const& there,
                     ParameterList const& other, std::string const& run)
{
  for (std::string const name : {"Law", "State Evolution"}) {
    requireSame("Asperity / Friction / " + name, deck.sublist("Friction").get<std::string>(name),
                other.sublist("Friction").get<std::string>(name), run);
  }
  requireSame("Asperity / Bulk / Model", deck.sublist("Bulk").get<std::string>("Model"),
              other.sublist("Bulk").get<std::string>("Model"), run);
  const auto kind = [](Problem<Dim> const& of) {
    auto const& side = of.surface->otherSide();
    return side.is_inside     ? "Two-Sided Fault"
           : side.is_mirrored ? "Antisymmetric Fault"
                              : "Bilateral Contact";
  };
  requireSame("The kind of the fault (Asperity / Boundary Conditions)", kind(here), kind(there),
              run);
  ASPERITY_REQUIRE(!here.surface->otherSide().is_inside,
                   "--restart-from cannot interpolate across a Two-Sided Fault yet. Continue the "
                   "run itself with --restart.");
}

template <int Dim>
dynamics::State loaded(std::filesystem::path const& checkpoint, Problem<Dim> const& problem,
                       Domains const& domains, ParameterList const& deck,
                       dynamics::DyadicTime const& clock)
{
  auto const archive =
    io::readCheckpoint(checkpoint, fingerprint(deck, problem.mesh, *problem.communicator),
                       *problem.communicator, nodeSets(problem, domains));
  return StateFormat(problem.initial, nullptr, clock).load(archive, "state");
}

RCP<ParameterList> deckOf(std::filesystem::path const& folder)
{
  CommandLine line;
  line.deck = (folder / "parameters.xml").string();
  ASPERITY_REQUIRE(std::filesystem::is_regular_file(line.deck),
                   "--restart-from: there is no " << line.deck
                                                  << ". Give the directory of a run, which has "
                                                     "parameters.xml and checkpoint.h5.");
  return readCompleteDeck(line);
}
} // namespace

template <int Dim>
io::NodeSets nodeSets(Problem<Dim> const& problem, Domains const& domains)
{
  auto const& ids = problem.mesh.global_ids;
  io::NodeSets sets;
  sets[nodes_of_body].assign(ids.begin(), ids.begin() + problem.mesh.num_owned);
  for (const int vertex : problem.surface->vertices()) {
    sets[nodes_of_friction].push_back(ids[vertex]);
  }
  for (auto const& [name, domain] : domains) {
    sets[name].assign(domain.node_numbers.begin(), domain.node_numbers.end());
  }
  return sets;
}

template <int Dim>
io::Archive stateOfOtherRun(std::filesystem::path const& run, Problem<Dim> const& problem,
                            Domains const& domains, ParameterList const& deck,
                            dynamics::DyadicTime const& clock, double end)
{
  const bool is_folder = std::filesystem::is_directory(run);
  const auto folder = is_folder ? run : run.parent_path();
  auto const other_deck = deckOf(folder.empty() ? "." : folder);
  requireSame("The number of dimensions of the mesh", std::to_string(Dim),
              std::to_string(meshDimension(other_deck->sublist("Mesh"), *problem.communicator)),
              run.string());
  auto const other = makeProblem<Dim>(*other_deck, problem.communicator);
  requireSameKind(problem, deck, other, *other_deck, run.string());
  auto const other_domains = makeDomains(other);
  auto const other_clock = makeClock(other_deck->sublist("Time Stepping"));
  auto const state =
    loaded(is_folder ? run / "checkpoint.h5" : run, other, other_domains, *other_deck, other_clock);
  const double time = other_clock.seconds(state.time);
  ASPERITY_REQUIRE(time < end, "Asperity / Time Stepping / Final Time = "
                                 << end << " s is not after the state of --restart-from "
                                 << run.string() << ", which is that at t = " << time
                                 << " s. Choose a later one.");

  io::Archive archive;
  archive.set("state/time", clock.reaching(time));
  std::vector<Values> motions;
  state.u->update(-1, *other.initial.u, 1); // displacement since the start
  for (auto const& motion : {state.u, state.v, state.a, state.jerk}) {
    motions.push_back(fem::alongAxes(other.constraints->frames(), *other.body.dofs, *motion));
  }
  motions = Interpolation(other_domains.at("volume"), domains.at("volume"),
                          run.string())(motions, problem.components);
  char const* const of_body[] = {"state/u", "state/v", "state/a", "state/jerk"};
  for (std::size_t i = 0; i < motions.size(); ++i) {
    auto values = inFrames(problem, motions[i]);
    if (i == 0) {
      auto const start = problem.initial.u->getLocalViewHost(Tpetra::Access::ReadOnly);
      for (std::size_t dof = 0; dof < values.size(); ++dof) {
        values[dof] += start(dof, 0);
      }
    }
    archive.set(of_body[i], values);
  }

  auto const from = nodesOfFriction(other, other_domains.at("fault"));
  auto const to = nodesOfFriction(problem, domains.at("fault"));
  const Interpolation along_fault(other_domains.at("fault"), domains.at("fault"), run.string());
  const auto carried = [&](Values const& there) {
    auto const values = along_fault({reordered(there, from)}, 1).front();
    Values result(to.size());
    for (std::size_t node = 0; node < to.size(); ++node) {
      result[to[node]] = values[node];
    }
    return result;
  };
  auto const change = carried(sum(onHost(state.sigma_n), -1, onHost(other.initial.sigma_n)));
  archive.set("state/sigma_n", sum(onHost(problem.initial.sigma_n), 1, change));
  archive.set("state/alpha", carried(onHost(state.alpha)));
  archive.set("state/alpha_of_rate", carried(onHost(state.alpha_of_rate)));
  return archive;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template io::NodeSets nodeSets(Problem<Dim> const&, Domains const&);                             \
  template io::Archive stateOfOtherRun(std::filesystem::path const&, Problem<Dim> const&,          \
                                       Domains const&, ParameterList const&,                       \
                                       dynamics::DyadicTime const&, double);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
