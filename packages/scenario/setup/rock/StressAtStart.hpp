#pragma once

#include "base/Warning.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "scenario/setup/NodalField.hpp"

#include <optional>

namespace asperity::scenario
{
// The deck's list `Bulk / Initial Stress`: the stress at the start, by components.
class StressAtStart
{
public:
  static constexpr char const* list_name = "Initial Stress";
  static RCP<const ParameterList> validParameters();

  StressAtStart(ParameterList const& list, std::vector<std::string> const& region_names);

  // As CellField::read.
  template <int Dim>
  void read(Mesh<Dim> const& mesh)
  {
    for (auto& field : fields_) {
      if (field) {
        field->read(mesh);
      }
    }
  }

  // Appends the stress of a cell to those of the rock. components: of the displacement; antiplane,
  // only the mean has diagonal entries.
  void append(CellPlace const& place, int components, fem::YieldingRock& rock) const;

private:
  std::vector<std::optional<CellField>> fields_; // of the components that are given
};

// A warning where the traction -sigma n of the rock beside the fault, by the deck's
// `Initial Stress`, differs by more than 1 % from the deck's `Shear Traction`(num_nodes, T) [Pa] or
// `Normal Stress` over more than half of where the fault slides beside rock that takes that stress;
// an overstressed patch is smaller. Both are evaluated at the nodes, so that they agree to rounding
// however coarse the mesh is. The normal stress counts if both lists give it, and not antiplane.
// bulk, friction: the lists of the deck. components: of the displacement. nodes: those of the
// surface. Collective.
template <int Dim>
std::optional<Warning>
warnOfStressAtStart(ParameterList const& bulk, ParameterList const& friction, int components,
                    Mesh<Dim> const& mesh, fem::YieldingRock const& rock, FieldNodes const& nodes,
                    fem::FaultSurface const& surface, std::vector<double> const& shear_traction);
} // namespace asperity::scenario
