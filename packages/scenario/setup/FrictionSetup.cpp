#include "scenario/setup/FrictionSetup.hpp"

#include "scenario/setup/LawSetup.hpp"

namespace asperity::scenario
{
namespace
{
const std::string path = "Asperity / Friction";
} // namespace

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
                          std::shared_ptr<const fem::FaultSurface> const& surface,
                          dynamics::NormalStress const& normal_stress)
{
  auto const nodes = surface->vertices();
  return {
    surface,
    {list.get<std::string>("Law"), frictionLawValues(list, mesh, nodes),
     toDevice(nodalValues(list, "Cohesion", path, mesh, nodes), "asperity::scenario::cohesion"),
     list.get<std::string>("State Evolution"), stateLawValues(list, mesh, nodes)},
    normal_stress};
}

template dynamics::Fault makeFault(ParameterList const&, Mesh<2> const&,
                                   std::shared_ptr<const fem::FaultSurface> const&,
                                   dynamics::NormalStress const&);
template dynamics::Fault makeFault(ParameterList const&, Mesh<3> const&,
                                   std::shared_ptr<const fem::FaultSurface> const&,
                                   dynamics::NormalStress const&);
} // namespace asperity::scenario
