#pragma once

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
} // namespace asperity::scenario
