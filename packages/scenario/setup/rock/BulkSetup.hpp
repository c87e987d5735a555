#pragma once

#include "fem/OtherSide.hpp"
#include "fem/bulk/Material.hpp"
#include "parameters/Entries.hpp"
#include "scenario/setup/NodalField.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Bulk`.
RCP<const ParameterList> bulkParameters();

// Which volumetric strain gives the mean stress of a cell: that of the cell, the mean over a patch,
// or each in part.
enum class VolumetricStrain
{
  automatic,
  of_cell,
  of_patch
};

// The entries of the list that are neither fields nor parameters of laws.
struct BulkSettings
{
  int components = 2; // of the displacement: 1 antiplane, 2 in plane strain, 3 of a solid
  std::string dynamics = "Inertial";
  double gravity = 0;                                   // [m/s^2]
  std::optional<std::vector<double>> gravity_direction; // of any length; empty if it is left out
  VolumetricStrain volumetric_strain = VolumetricStrain::automatic;
  std::string law = "Kelvin-Voigt";

  static BulkSettings from(ParameterList const& list);

  std::string model() const; // the word of the entry `Model`
  // Whether the body has no mass, and its fault has radiation damping instead.
  bool isQuasiDynamic() const;
  bool hasGravity() const { return gravity > 0; }
};

// Whether a list `Bulk` that need not be complete chooses a quasi-dynamic body.
bool choosesQuasiDynamic(ParameterList const& list);

// A list of `Regions`, beside the parameters of the law.
struct LawOfRegion
{
  std::string law;
  static Entries<LawOfRegion> entries();
};

// Throws InputError unless the model fits a mesh of this dimension.
void requireDimension(BulkSettings const& bulk, int dimension);

// The radiation damping eta [Pa s/m] at the nodes of a fault, traction per slip rate; zero unless
// quasi-dynamic. The default follows from the materials at_nodes(num_nodes) and the other side.
std::vector<double> radiationDamping(BulkSettings const& bulk, ParameterList const& list,
                                     FieldNodes const& nodes, fem::OtherSide const& other_side,
                                     std::vector<fem::Material> const& at_nodes);

// The gravitational acceleration along the axes [m/s^2]; zero without gravity. down: its direction
// if the deck gives none.
template <int Dim>
std::array<double, Dim> gravity(BulkSettings const& bulk,
                                std::array<double, 3> const& down = {0, -1, 0});
} // namespace asperity::scenario
