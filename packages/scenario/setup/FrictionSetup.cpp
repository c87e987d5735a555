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
           "The fault bears this shear stress even without normal stress.")
    .field("Normal Stress", optional, "Pa", Range::any(),
           "The fault is under this normal stress, positive in compression. If it is left out, it "
           "follows from the static solution under gravity. Values that become negative after the "
           "start count as zero.")
    .real("Normal Stress Factor", 1., "-", Range::atLeast(0),
          "This factor multiplies the normal stress.")
    .field("Shear Traction", 0., "Pa", Range::any(),
           "This shear traction acts on the fault in addition to that of the deformation. It "
           "points along the tangent of the fault's frame, which is +x on a fault below the body, "
           "and in three dimensions along the slip direction.")
    .realArray("Slip Direction", std::vector<double>{1., 0., 0.}, "-", Range::any(),
               "In three dimensions the shear traction points along this vector, projected onto "
               "the fault. The length of the vector has no effect.");
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
