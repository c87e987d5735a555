#pragma once

#include "fem/inelastic/InelasticCells.hpp"
#include "scenario/setup/NodalField.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

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

  // The components XX, XY, XZ, YY, YZ and ZZ of the list at nodes, (num_nodes) each [Pa].
  using Components = std::array<std::vector<double>, 6>;
  static Components atNodes(ParameterList const& list, FieldNodes const& nodes);
  // Whether the list gives a component of the mean.
  static bool givesMean(ParameterList const& list);

private:
  std::vector<std::optional<CellField>> fields_; // of the components that are given
};
} // namespace asperity::scenario
