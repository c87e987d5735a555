#include "scenario/FaultLoads.hpp"

#include "friction/Registry.hpp"
#include "scenario/FrictionSetup.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>

namespace asperity::scenario
{
namespace
{
const std::string path = "Asperity / Friction";

// One value for each fault node, times the node's share of the fault.
void addTraction(std::vector<double> const& traction, fem::BoundaryNodes<2> const& nodes,
                 std::vector<int> const& dofs, Vector& load)
{
  auto const values = load.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    values(dofs[i], 0) += nodes.weights[i] * traction[i];
  }
}

void fill(std::vector<double> const& values, double factor, friction::NodeView const& view)
{
  auto const host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < values.size(); ++i) {
    host(i) = factor * std::max(values[i], 0.);
  }
  Kokkos::deep_copy(view, host);
}

std::vector<double> givenStress(NodalField const& field, Mesh<2> const& mesh,
                                std::vector<int> const& nodes)
{
  auto const values = field.at(0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto const& x = mesh.vertices[nodes[i]];
    ASPERITY_REQUIRE(values[i] >= 0, joinPath(path, "Normal Stress")
                                       << " = " << values[i] << " at x = (" << x[0] << ", " << x[1]
                                       << "), t = 0, is outside [0, inf). Check the sign: "
                                          "compression is positive.");
  }
  return values;
}
} // namespace

NodalField shearTraction(ParameterList const& friction, Mesh<2> const& mesh,
                         std::vector<int> const& nodes)
{
  return NodalField(friction, "Shear Traction", path, mesh, nodes);
}

std::function<void(double, Vector&)> loadWithTraction(ParameterList const& friction,
                                                      Mesh<2> const& mesh,
                                                      fem::BoundaryNodes<2> const& nodes,
                                                      dynamics::Fault const& fault,
                                                      RCP<const Vector> const& constant)
{
  auto const traction = shearTraction(friction, mesh, nodes.nodes);
  std::vector<int> dofs;
  for (auto const& of_node : fault.dofs) {
    dofs.push_back(of_node[0]);
  }
  if (!traction.dependsOnTime()) {
    auto const load = rcp(new Vector(*constant, Teuchos::Copy));
    addTraction(traction.at(0), nodes, dofs, *load);
    return [load](double, Vector& l) { Tpetra::deep_copy(l, *load); };
  }
  return [traction, nodes, dofs, constant](double t, Vector& l) {
    Tpetra::deep_copy(l, *constant);
    addTraction(traction.at(t), nodes, dofs, l);
  };
}

void setNormalStress(dynamics::Fault& fault, ParameterList const& friction, Mesh<2> const& mesh,
                     std::vector<int> const& nodes, NormalStress& stress)
{
  const double factor = friction.get<double>("Normal Stress Factor");
  fault.normal_stress = friction::NodeView("asperity::scenario::normalStress", nodes.size());
  fault.data.sigma_n = fault.normal_stress;
  if (isGiven(friction, "Normal Stress")) {
    const NodalField given(friction, "Normal Stress", path, mesh, nodes);
    stress.values = givenStress(given, mesh, nodes);
    if (given.dependsOnTime()) {
      fault.normal_stress_at = [given, factor](double t, friction::NodeView const& view) {
        fill(given.at(t), factor, view);
      };
    }
  }
  const auto num_tensile = std::count_if(stress.values.begin(), stress.values.end(),
                                         [](double value) { return value < 0; });
  stress.num_tensile = fault.sumOverRanks(static_cast<int>(num_tensile));
  fill(stress.values, factor, fault.normal_stress);
  fault.friction = friction::makeFrictionKernels(friction.get<std::string>("Law"), fault.data);
}
} // namespace asperity::scenario
