#include "scenario/setup/FrictionSetup.hpp"

#include "friction/Registry.hpp"
#include "scenario/setup/LawSetup.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <algorithm>

namespace asperity::scenario
{
namespace
{
const std::string path = "Asperity / Friction";
} // namespace

friction::NodeView toDevice(std::vector<double> const& values, std::string const& label)
{
  friction::NodeView view(label, values.size());
  auto const host = Kokkos::create_mirror_view(view);
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

RCP<const ParameterList> frictionParameters()
{
  Declare declare;
  declareLaws(declare);
  declare
    .field("Cohesion", 0., "Pa", Range::atLeast(0),
           "Shear stress that the fault bears without normal stress.")
    .field("Normal Stress", optional, "Pa", Range::any(),
           "Normal stress, positive in compression; left out, it is that of the static solution "
           "under gravity. What becomes negative after the start counts as zero.")
    .real("Normal Stress Factor", 1., "-", Range::atLeast(0), "Multiplies the normal stress.")
    .field("Shear Traction", 0., "Pa", Range::any(),
           "Shear traction on the fault besides that of the deformation, along the tangent of its "
           "frame, +x on a fault below the body; in three dimensions along the slip direction.")
    .realArray("Slip Direction", std::vector<double>{1., 0., 0.}, "-", Range::any(),
               "Three dimensions: where the shear traction points, projected onto the fault; of "
               "any length.");
  return declare.list();
}

template <int Dim>
dynamics::Fault makeFault(ParameterList const& list, Mesh<Dim> const& mesh,
                          fem::BoundaryNodes<Dim> const& boundary, fem::DofMap const& dofs,
                          fem::Constraints<Dim> const& constraints, double slip_factor)
{
  dynamics::Fault fault;
  fault.num_tangents = Dim - 1;
  fault.slip_factor = slip_factor;
  fault.communicator = dofs.communicator();
  for (std::size_t i = 0; i < boundary.nodes.size(); ++i) {
    const int node = boundary.nodes[i];
    fault.dofs.emplace_back();
    fault.fixed.emplace_back();
    for (int component :
         fem::tangentialComponents(constraints.frames(), node, boundary.normals[i])) {
      const int dof = dofs.dof(node, component);
      fault.dofs.back().push_back(dof);
      fault.fixed.back().push_back(constraints.fixed()[dof] ? 1 : 0);
    }
  }
  double mine = 0;
  for (double weight : boundary.weights) {
    mine += weight;
  }
  Teuchos::reduceAll(*fault.communicator, Teuchos::REDUCE_SUM, mine,
                     Teuchos::outArg(fault.total_weight));
  fault.data.weight = toDevice(boundary.weights, "asperity::scenario::weight");
  fault.data.cohesion = toDevice(nodalValues(list, "Cohesion", path, mesh, boundary.nodes),
                                 "asperity::scenario::cohesion");
  fault.data.slip_factor = toDevice(std::vector<double>(boundary.nodes.size(), slip_factor),
                                    "asperity::scenario::slipFactor");
  fault.data.sigma_n =
    friction::NodeView("asperity::scenario::normalStress", boundary.nodes.size());

  fault.data.parameters = frictionLawValues(list, mesh, boundary.nodes);
  fault.state = friction::makeStateKernels(list.get<std::string>("State Evolution"),
                                           stateLawValues(list, mesh, boundary.nodes));
  return fault;
}

template dynamics::Fault makeFault(ParameterList const&, Mesh<2> const&,
                                   fem::BoundaryNodes<2> const&, fem::DofMap const&,
                                   fem::Constraints<2> const&, double);
template dynamics::Fault makeFault(ParameterList const&, Mesh<3> const&,
                                   fem::BoundaryNodes<3> const&, fem::DofMap const&,
                                   fem::Constraints<3> const&, double);
} // namespace asperity::scenario
