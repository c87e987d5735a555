#include "scenario/setup/rock/StressMisfit.hpp"

#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/FirstRank.hpp"
#include "base/parallel/Gather.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "parameters/ParameterValue.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"
#include "scenario/setup/rock/StressAtStart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace asperity::scenario
{
namespace
{
constexpr int in_matrix[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}; // the number of a component

// What acts across the fault at a node, or on it: along its tangents, and across.
struct Tractions
{
  std::vector<double> shear;
  double normal = 0; // positive in compression
};

std::string text(Tractions const& tractions)
{
  return "a shear traction of " +
         (tractions.shear.size() == 1 ? formatShort(tractions.shear[0])
                                      : formatPoint(tractions.shear)) +
         " Pa and a normal stress of " + formatShort(tractions.normal) + " Pa";
}

// The tractions -sigma n of the stress (6 components); n points away from the body.
Tractions tractionsOf(std::array<double, 6> const& stress, fem::FaultNode const& node)
{
  std::array<double, 3> traction{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      traction[i] -= stress[in_matrix[i][j]] * node.normal[j];
    }
  }
  Tractions result;
  for (auto const& tangent : node.tangents) {
    result.shear.push_back(mesh::dot<3>(traction, tangent));
  }
  result.normal = mesh::dot<3>(traction, node.normal);
  return result;
}

double size(std::vector<double> const& v)
{
  return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.));
}

// The difference, as a part of the larger one [-], and in Pa.
struct Misfit
{
  double part = 0, size = 0;
};

Misfit misfit(Tractions const& rock, Tractions const& fault, bool with_normal)
{
  const auto relative = [](double difference, double a, double b) {
    const double larger = std::max(a, b);
    return Misfit{larger > 0 ? difference / larger : 0, difference};
  };
  auto difference = rock.shear;
  for (std::size_t k = 0; k < difference.size(); ++k) {
    difference[k] -= fault.shear[k];
  }
  constexpr double of_normal = 0.01; // less shear than this part of the normal stress is none
  auto const along = relative(size(difference), std::max(size(rock.shear), size(fault.shear)),
                              of_normal * std::abs(fault.normal));
  auto const across = with_normal ? relative(std::abs(rock.normal - fault.normal),
                                             std::abs(rock.normal), std::abs(fault.normal))
                                  : Misfit();
  return {std::max(along.part, across.part), std::max(along.size, across.size)};
}

// (num local vertices) whether a cell that takes the stress has it.
template <int Dim>
std::vector<bool> verticesOfYieldingRock(Mesh<Dim> const& mesh, fem::YieldingRock const& rock)
{
  std::vector<bool> result(mesh.vertices.size(), false);
  for (auto const& part : rock.parts) {
    for (const int cell : part.cells) {
      for (const int vertex : mesh.cells[cell]) {
        result[vertex] = true;
      }
    }
  }
  return result;
}

// The stresses of the deck at the nodes of the fault.
struct StressesOfDeck
{
  StressAtStart::Components rock;
  std::vector<double> shear;  // (num_nodes, T), on the fault
  std::vector<double> normal; // (num_nodes), on the fault; 0 if the deck leaves it out
  bool with_normal = false;   // whether rock and fault both have a normal stress
};

// The differences at the nodes of this rank.
struct Differences
{
  std::array<double, 2> measure{}; // where rock and fault differ, and where they are compared
  double largest = 0;              // [Pa]
  std::string worst;               // where that is, and both tractions there
};

Differences differencesOf(StressesOfDeck const& stresses, std::vector<bool> const& touches_rock,
                          FieldNodes const& nodes, fem::FaultSurface const& surface)
{
  constexpr double largest_part = 0.01;
  const std::size_t num_tangents = surface.numTangents();
  Differences result;
  for (int i = 0; i < surface.numNodes(); ++i) {
    auto const& node = surface[i];
    if (!surface.slides(i) || std::none_of(node.copies.begin(), node.copies.end(),
                                           [&](int vertex) { return touches_rock[vertex]; })) {
      continue;
    }
    std::array<double, 6> here{};
    std::transform(stresses.rock.begin(), stresses.rock.end(), here.begin(),
                   [i](auto const& component) { return component[i]; });
    auto const of_rock = tractionsOf(here, node);
    auto const first = stresses.shear.begin() + static_cast<std::ptrdiff_t>(i * num_tangents);
    const Tractions of_fault{{first, first + static_cast<std::ptrdiff_t>(num_tangents)},
                             stresses.normal[i]};
    auto const found = misfit(of_rock, of_fault, stresses.with_normal);
    result.measure[0] += found.part > largest_part ? node.weight : 0;
    result.measure[1] += node.weight;
    if (found.part > largest_part && found.size > result.largest) {
      result.largest = found.size;
      result.worst = "at " + nodes.text(i) + " m, where the rock has " + text(of_rock) +
                     ", and the fault " + text(of_fault);
    }
  }
  return result;
}

// The text of the first rank on which the difference is the largest of all. Collective.
std::string worstOf(Differences const& mine, Communicator const& communicator)
{
  const double most = maxOverRanks(mine.largest, communicator);
  auto const first = firstRankWhere(most > 0 && mine.largest == most, communicator);
  auto const letters = gatherToAll(first == communicator.getRank()
                                     ? std::vector<char>(mine.worst.begin(), mine.worst.end())
                                     : std::vector<char>(),
                                   communicator);
  return {letters.begin(), letters.end()};
}
} // namespace

template <int Dim>
std::optional<Warning>
warnOfStressAtStart(ParameterList const& bulk, ParameterList const& friction, int components,
                    Mesh<Dim> const& mesh, fem::YieldingRock const& rock, FieldNodes const& nodes,
                    fem::FaultSurface const& surface, std::vector<double> const& shear_traction)
{
  auto const& list = bulk.sublist(StressAtStart::list_name);
  if (!hasGivenEntry(list)) {
    return std::nullopt;
  }
  auto const& communicator = *surface.communicator();
  StressesOfDeck stresses;
  stresses.shear = shear_traction;
  stresses.normal.assign(surface.numNodes(), 0.);
  // An antiplane model takes the mean of the diagonal alone, which need not be the normal stress.
  stresses.with_normal = isGiven(friction, friction_entries::normal_stress) && components > 1 &&
                         StressAtStart::givesMean(list);
  onEveryRank(communicator, [&] {
    stresses.rock = StressAtStart::atNodes(list, nodes);
    if (isGiven(friction, friction_entries::normal_stress)) {
      stresses.normal =
        NodalField(friction, friction_entries::normal_stress, friction_path, nodes).at(0);
    }
  });
  auto const mine = differencesOf(stresses, verticesOfYieldingRock(mesh, rock), nodes, surface);
  auto const measure = sumOverRanks(mine.measure, communicator);
  if (!(2 * measure[0] > measure[1])) {
    return std::nullopt;
  }
  return Warning{"stress at the start",
                 "Bulk / Initial Stress does not fit the stress on the fault: over " +
                   formatShort(std::round(1000 * measure[0] / measure[1]) / 10) +
                   " % of it, -sigma n of the rock (n points out of the plus side) differs by more "
                   "than 1 % from Friction / Shear Traction or Normal Stress, most " +
                   worstOf(mine, communicator) +
                   ". The rock then yields under another stress than the fault bears. Check signs "
                   "and units of both; tension is positive in Initial Stress."};
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::optional<Warning> warnOfStressAtStart(                                             \
    ParameterList const&, ParameterList const&, int, Mesh<Dim> const&, fem::YieldingRock const&,   \
    FieldNodes const&, fem::FaultSurface const&, std::vector<double> const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
