#include "scenario/setup/conditions/PlateRate.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"

#include <cmath>

namespace asperity::scenario
{
PlateRate plateRateOf(BoundaryCondition const& condition, int components)
{
  PlateRate result;
  result.name = condition.name;
  result.boundary = condition.boundary;
  auto const& direction = condition.direction;
  if (!isGiven(condition.list, condition_entries::plate_rate)) {
    ASPERITY_REQUIRE(!direction || condition.givesSlipRate(),
                     joinPath(condition.name, condition_entries::direction)
                       << " has no effect without a Plate Rate or a Slip Rate. Remove it.");
    return result;
  }
  result.rate = std::make_shared<Field>(
    steadyField(condition.list, condition_entries::plate_rate, condition.name, {}));
  ASPERITY_REQUIRE(!result.rate->isDataset(),
                   joinPath(condition.name, condition_entries::plate_rate)
                     << " is a dataset. Give a number or an expression in x, y and z.");
  if (components < 3) {
    ASPERITY_REQUIRE(!direction, joinPath(condition.name, condition_entries::direction)
                                   << " has no effect: in two dimensions plates move along "
                                      "the fault's tangent. Remove it.");
    return result;
  }
  result.direction = {1., 0., 0.};
  if (direction) {
    auto const& given = *direction;
    ASPERITY_REQUIRE(given.size() == 3 && std::hypot(given[0], given[1], given[2]) > 0,
                     joinPath(condition.name, condition_entries::direction)
                       << " needs three numbers, not all zero: where the plate rate points.");
    result.direction = given;
  }
  return result;
}

namespace
{
// (T) at one node.
template <int Dim>
std::vector<double> rateAt(PlateRate const& plate, Mesh<Dim> const& mesh,
                           fem::FaultSurface const& surface, int node,
                           fem::NodalFrames const& frames)
{
  const double rate = (*plate.rate)(inSpace<Dim>(mesh.vertices[surface.vertex(node)]), 0, 0);
  if (plate.direction.empty()) {
    return {rate};
  }
  auto along = directionAlongFault(plate.direction, frames, surface, node,
                                   joinPath(plate.name, condition_entries::direction));
  for (double& component : along) {
    component *= rate;
  }
  return along;
}
} // namespace

template <int Dim>
std::vector<double> nodalPlateRates(std::vector<PlateRate> const& plates, Mesh<Dim> const& mesh,
                                    fem::FaultSurface const& surface,
                                    fem::NodalFrames const& frames)
{
  std::vector<PlateRate const*> at_vertex(mesh.vertices.size(), nullptr);
  for (auto const& plate : plates) {
    for (auto const& facet : mesh.boundaries.at(plate.boundary)) {
      for (int vertex : facet) {
        at_vertex[vertex] = at_vertex[vertex] == nullptr ? &plate : at_vertex[vertex];
      }
    }
  }
  std::vector<double> result;
  onEveryRank(*surface.communicator(), [&] {
    for (int node = 0; node < surface.numNodes(); ++node) {
      auto const* plate = at_vertex[surface.vertex(node)];
      auto const rate = plate == nullptr ? std::vector<double>(surface.numTangents(), 0.)
                                         : rateAt(*plate, mesh, surface, node, frames);
      result.insert(result.end(), rate.begin(), rate.end());
    }
  });
  return result;
}

std::vector<double> directionAlongFault(std::vector<double> const& towards,
                                        fem::NodalFrames const& frames,
                                        fem::FaultSurface const& surface, int node,
                                        std::string const& entry)
{
  const int vertex = surface.vertex(node);
  std::vector<double> result;
  double square = 0;
  for (int dof : surface[node].dofs) {
    const int tangent = dof - vertex * frames.components();
    double along = 0;
    for (int c = 0; c < frames.components(); ++c) {
      along += frames.entry(vertex, tangent, c) * towards[c];
    }
    result.push_back(along);
    square += along * along;
  }
  if (std::sqrt(square) <= 1e-6 * std::hypot(towards[0], towards[1], towards[2])) {
    ASPERITY_REQUIRE(!surface.counts(node),
                     entry << " is at right angles to the fault somewhere. Choose one along it.");
    return std::vector<double>(result.size(), 0.);
  }
  for (double& x : result) {
    x /= std::sqrt(square);
  }
  return result;
}

template std::vector<double> nodalPlateRates(std::vector<PlateRate> const&, Mesh<2> const&,
                                             fem::FaultSurface const&, fem::NodalFrames const&);
template std::vector<double> nodalPlateRates(std::vector<PlateRate> const&, Mesh<3> const&,
                                             fem::FaultSurface const&, fem::NodalFrames const&);
} // namespace asperity::scenario
