#include "scenario/setup/fault/PlateRate.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "scenario/setup/ConditionTypes.hpp"
#include "scenario/setup/NodalField.hpp"

#include <cmath>

namespace asperity::scenario
{
PlateRate plateRateOf(BoundaryCondition const& condition, int components)
{
  PlateRate result;
  result.name = condition.name;
  const bool has_direction = isGiven(condition.list, "Direction");
  if (!isGiven(condition.list, "Plate Rate")) {
    ASPERITY_REQUIRE(!has_direction, joinPath(condition.name, "Direction")
                                       << " has no effect without a Plate Rate. Remove it.");
    return result;
  }
  result.rate =
    std::make_shared<Field>(steadyField(condition.list, "Plate Rate", condition.name, {}));
  ASPERITY_REQUIRE(!result.rate->isDataset(),
                   joinPath(condition.name, "Plate Rate")
                     << " is a dataset. Give a number or an expression in x, y and z.");
  if (components < 3) {
    ASPERITY_REQUIRE(!has_direction, joinPath(condition.name, "Direction")
                                       << " has no effect: in two dimensions plates move along "
                                          "the fault's tangent. Remove it.");
    return result;
  }
  result.direction = {1., 0., 0.};
  if (has_direction) {
    auto const given = condition.list.get<Teuchos::Array<double>>("Direction").toVector();
    ASPERITY_REQUIRE(given.size() == 3 && std::hypot(given[0], given[1], given[2]) > 0,
                     joinPath(condition.name, "Direction")
                       << " needs three numbers, not all zero: where the plate rate points.");
    result.direction = given;
  }
  return result;
}

template <int Dim>
std::vector<double> nodalPlateRate(PlateRate const& plate, Mesh<Dim> const& mesh,
                                   fem::FaultSurface const& surface, fem::NodalFrames const& frames)
{
  std::vector<double> result;
  onEveryRank(*surface.communicator(), [&] {
    for (int i = 0; i < surface.numNodes(); ++i) {
      const double rate = (*plate.rate)(inSpace<Dim>(mesh.vertices[surface.vertex(i)]), 0, 0);
      if (plate.direction.empty()) {
        result.push_back(rate);
        continue;
      }
      for (double along : directionAlongFault(plate.direction, frames, surface[i],
                                              joinPath(plate.name, "Direction"))) {
        result.push_back(rate * along);
      }
    }
  });
  return result;
}

std::vector<double> directionAlongFault(std::vector<double> const& towards,
                                        fem::NodalFrames const& frames, fem::FaultNode const& node,
                                        std::string const& entry)
{
  const int vertex = node.copies.front();
  std::vector<double> result;
  double square = 0;
  for (int dof : node.dofs) {
    const int tangent = dof - vertex * frames.components();
    double along = 0;
    for (int c = 0; c < frames.components(); ++c) {
      along += frames.entry(vertex, tangent, c) * towards[c];
    }
    result.push_back(along);
    square += along * along;
  }
  const double length = std::hypot(towards[0], towards[1], towards[2]);
  ASPERITY_REQUIRE(std::sqrt(square) > 1e-6 * length,
                   entry << " is at right angles to the fault somewhere. Choose one along it.");
  for (double& x : result) {
    x /= std::sqrt(square);
  }
  return result;
}

template std::vector<double> nodalPlateRate(PlateRate const&, Mesh<2> const&,
                                            fem::FaultSurface const&, fem::NodalFrames const&);
template std::vector<double> nodalPlateRate(PlateRate const&, Mesh<3> const&,
                                            fem::FaultSurface const&, fem::NodalFrames const&);
} // namespace asperity::scenario
