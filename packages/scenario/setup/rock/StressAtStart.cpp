#include "scenario/setup/rock/StressAtStart.hpp"

#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Gather.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "parameters/ParameterValue.hpp"
#include "scenario/setup/DeckPaths.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity::scenario
{
namespace
{
constexpr std::array<char const*, 6> component_names = {"XX", "XY", "XZ", "YY", "YZ", "ZZ"};
constexpr std::array<int, 3> diagonal = {0, 3, 5};
constexpr int in_matrix[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

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
} // namespace

RCP<const ParameterList> StressAtStart::validParameters()
{
  Declare declare;
  for (char const* name : component_names) {
    declare.field(name, optional, "Pa", Range::any(),
                  "The stress at the start has this component, which is 0 if it is left out.");
  }
  return declare.list();
}

StressAtStart::StressAtStart(ParameterList const& list,
                             std::vector<std::string> const& region_names)
{
  for (char const* name : component_names) {
    fields_.push_back(isGiven(list, name)
                        ? std::optional<CellField>(
                            steadyField(list, name, joinPath(bulk_path, list_name), region_names))
                        : std::nullopt);
  }
}

void StressAtStart::append(CellPlace const& place, int components, fem::YieldingRock& rock) const
{
  std::array<double, 6> value{};
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    value[k] = fields_[k] ? (*fields_[k])(place) : 0;
  }
  auto const [xx, xy, xz, yy, yz, zz] = value;
  const std::vector<double> tensor = components == 1 ? std::vector<double>{xz, yz}
                                     : components == 2
                                       ? std::vector<double>{xx, xy, yy, zz}
                                       : std::vector<double>(value.begin(), value.end());
  rock.initial_stress.insert(rock.initial_stress.end(), tensor.begin(), tensor.end());
  rock.initial_mean.push_back((xx + yy + zz) / 3);
}

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
  // An antiplane model takes the mean of the diagonal alone, which need not be the normal stress.
  const bool with_normal = isGiven(friction, "Normal Stress") && components > 1 &&
                           std::any_of(diagonal.begin(), diagonal.end(), [&list](int k) {
                             return isGiven(list, component_names[k]);
                           });
  auto const& communicator = *surface.communicator();
  std::array<std::vector<double>, 6> stress;
  std::vector<double> normal(surface.numNodes(), 0.);
  onEveryRank(communicator, [&] {
    for (std::size_t k = 0; k < stress.size(); ++k) {
      stress[k] = isGiven(list, component_names[k])
                    ? nodalValues(list, component_names[k],
                                  joinPath(bulk_path, StressAtStart::list_name), nodes)
                    : normal;
    }
    if (isGiven(friction, "Normal Stress")) {
      normal = NodalField(friction, "Normal Stress", friction_path, nodes).at(0);
    }
  });
  auto const touches_rock = verticesOfYieldingRock(mesh, rock);
  const std::size_t num_tangents = surface.numTangents();
  std::array<double, 2> measure{}; // where they differ, and all of it
  double largest = 0;
  std::string worst;
  for (int i = 0; i < surface.numNodes(); ++i) {
    auto const& node = surface[i];
    if (!surface.slides(i) || std::none_of(node.copies.begin(), node.copies.end(),
                                           [&](int vertex) { return touches_rock[vertex]; })) {
      continue;
    }
    std::array<double, 6> here{};
    std::transform(stress.begin(), stress.end(), here.begin(),
                   [i](auto const& component) { return component[i]; });
    auto const of_rock = tractionsOf(here, node);
    auto const first = shear_traction.begin() + static_cast<std::ptrdiff_t>(i * num_tangents);
    const Tractions of_fault{{first, first + static_cast<std::ptrdiff_t>(num_tangents)}, normal[i]};
    auto const found = misfit(of_rock, of_fault, with_normal);
    constexpr double largest_part = 0.01;
    measure[0] += found.part > largest_part ? node.weight : 0;
    measure[1] += node.weight;
    if (found.part > largest_part && found.size > largest) {
      largest = found.size;
      worst = "at " + nodes.text(i) + " m, where the rock has " + text(of_rock) +
              ", and the fault " + text(of_fault);
    }
  }
  measure = sumOverRanks(measure, communicator);
  if (!(2 * measure[0] > measure[1])) {
    return std::nullopt;
  }
  const double most = maxOverRanks(largest, communicator);
  const bool is_here = most > 0 && largest == most;
  const int rank = communicator.getRank();
  const int worst_rank = minOverRanks(is_here ? rank : communicator.getSize(), communicator);
  auto const worst_text = gatherToAll(
    rank == worst_rank ? std::vector<char>(worst.begin(), worst.end()) : std::vector<char>(),
    communicator);
  return Warning{"stress at the start",
                 "Bulk / Initial Stress does not fit the stress on the fault: over " +
                   formatShort(std::round(1000 * measure[0] / measure[1]) / 10) +
                   " % of it, -sigma n of the rock (n points out of the plus side) differs by more "
                   "than 1 % from Friction / Shear Traction or Normal Stress, most " +
                   std::string(worst_text.begin(), worst_text.end()) +
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
