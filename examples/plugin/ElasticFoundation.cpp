#include "fem/NodalDamping.hpp"
#include "scenario/setup/conditions/BoundaryKind.hpp"
#include "scenario/setup/conditions/ConditionEntries.hpp"

#include <array>
#include <memory>

using namespace asperity;
using namespace asperity::scenario;

namespace
{
// Springs hold the boundary (Winkler's foundation): the traction is -k_n u_n across it and -k_t u_t
// along it, where u is the displacement.
struct ElasticFoundation
{
  static constexpr char const* meaning =
    "springs hold the boundary: a traction against its displacement.";
  static constexpr auto decides_on = DecidesOn::traction;

  static void declare(Declare& declare)
  {
    declare
      .field("Normal Stiffness", optional, "Pa/m", Range::atLeast(0),
             "Elastic Foundation: the traction across the boundary per displacement across it; 0 "
             "if it is left out.")
      .withoutDatasets()
      .field("Shear Stiffness", optional, "Pa/m", Range::atLeast(0),
             "Elastic Foundation: the same along the boundary.")
      .withoutDatasets();
  }

  template <int Dim>
  static void add(BoundaryCondition const& condition, ConditionContext const&,
                  BoundaryConditions<Dim>& result)
  {
    auto const across = fieldIfGiven(condition, "Normal Stiffness");
    auto const along = fieldIfGiven(condition, "Shear Stiffness");
    result.resistances.push_back(
      {condition.boundary, fem::BoundaryResistance::Against::displacement,
       [across, along](std::array<double, 3> const& x, fem::Material const&) {
         return fem::BoundaryResistance::Value{across ? (*across)(x, 0, 0) : 0,
                                               along ? (*along)(x, 0, 0) : 0};
       }});
  }
};
} // namespace

ASPERITY_REGISTER(BoundaryKindRegistry, "Elastic Foundation", BoundaryKindOf<ElasticFoundation>)
