#include "scenario/setup/rock/BulkSetup.hpp"

#include "base/Errors.hpp"
#include "fem/bulk/BulkLaw.hpp"
#include "scenario/setup/DeckDirections.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/ParameterTable.hpp"
#include "scenario/setup/rock/BulkEntries.hpp"
#include "scenario/setup/rock/StressAtStart.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
namespace
{
constexpr char const* radiation_damping = "Radiation Damping";
constexpr char const* dynamics_entry = "Dynamics";
constexpr char const* quasi_dynamic = "Quasi-dynamic";

// The words of `Model` and the components of the displacement.
Entries<BulkSettings>::Words<int> models()
{
  return {{"Plane Strain", 2}, {"Antiplane", 1}, {"Solid", 3}};
}

RCP<const ParameterList> lawsOfRegions()
{
  return Declare()
    .sublist("<region>", LawOfRegion::entries().list(),
             "Names a region of the mesh and gives the law of its rock.")
    .list();
}

Entries<BulkSettings> bulkEntries()
{
  using S = BulkSettings;
  auto const of_damping =
    Declare()
      .field(
        radiation_damping, optional, "Pa s/m", Range::atLeast(0),
        "This is eta in tau = friction + eta V, where V is the slip rate. If it is left out, "
        "eta is G / (2 cs) on an antisymmetric fault and G / cs in bilateral contact; between two "
        "bodies it is Z1 Z2 / (Z1 + Z2) with their impedances Z = G / cs.")
      .list();
  Entries<S> entries;
  entries
    .choice("Model", &S::components, models(),
            "Selects the components of the displacement. Plane Strain: it lies in the plane of the "
            "mesh. Antiplane: it is perpendicular to that plane. Solid: it has all three "
            "components on a mesh in space.")
    .choiceOfLists(dynamics_entry, &S::dynamics,
                   {{"Inertial", Declare().list()}, {quasi_dynamic, of_damping}},
                   "Selects whether the body has inertia. Inertial: it has mass, and waves travel "
                   "through it. Quasi-dynamic: it has no mass, and a radiation damping takes from "
                   "the fault the energy that waves would carry away.")
    .others()
    .field(bulk_entries::density, required, "kg/m^3", Range::positive(),
           "The material has this mass density.")
    .field(bulk_entries::bulk_modulus, optional, "Pa", Range::positive(),
           "The material has this bulk modulus. Plane strain and solids need exactly two of bulk "
           "modulus, shear modulus and Poisson's ratio, or both wave speeds instead.")
    .field(
      bulk_entries::shear_modulus, optional, "Pa", Range::positive(),
      "The material has this shear modulus. Antiplane models need either this alone, or two of "
      "the three moduli, or the speed of shear waves.")
    .field(bulk_entries::poissons_ratio, optional, "-", Range::open(-1, 0.5),
           "The material has this Poisson's ratio.")
    .field(bulk_entries::p_wave_speed, optional, "m/s", Range::positive(),
           "Compressional waves travel through the material with this speed cp, so that its bulk "
           "modulus is rho (cp^2 - 4/3 cs^2); it has to be above 1.155 cs.")
    .field(bulk_entries::s_wave_speed, optional, "m/s", Range::positive(),
           "Shear waves travel through the material with this speed cs, so that its shear modulus "
           "is rho cs^2 with the density rho. Plane strain and solids need both speeds.");
  entries
    .real("Gravitational Acceleration", &S::gravity, "m/s^2", Range::atLeast(0),
          "Gravity accelerates the body by this value. An antiplane model has no gravity.")
    .realArray(gravity_direction_entry, &S::gravity_direction, optional, "-", Range::any(),
               "Gravity points in the direction of this vector in x, y and, in three dimensions, z "
               "(0 if left out). Its length has no effect. If it is left out, gravity points down: "
               "against Output / Up or, without that, against the axis that is nearest to the "
               "outward normal of the Free Surface or, in space, of what nothing holds; else along "
               "-y.")
    .choice(
      "Volumetric Strain", &S::volumetric_strain,
      {{"Auto", VolumetricStrain::automatic},
       {"Cell", VolumetricStrain::of_cell},
       {"Patch", VolumetricStrain::of_patch}},
      "Selects which volumetric strain gives the mean stress of a cell. Auto: what rock of a "
      "Poisson's ratio up to 0.3 bears follows from the strain of the cell, what nearly "
      "incompressible rock bears beyond it from the mean over a patch of cells around a vertex, so "
      "that cells do not lock. Cell: all follows from the cell. Patch: all follows from the patch, "
      "in rock of any Poisson's ratio; softer, and steps take about 3 times as long in space. It "
      "has no effect in antiplane models, and in rock that yields or has a power law.");
  addLaws(entries, bulk_entries::law, &S::law, fem::bulkLaws(),
          "Selects the law of the rock: how it creeps or flows. Kelvin-Voigt: it damps "
          "waves; without viscosity it is elastic. Maxwell: its shear stress relaxes. "
          "Burgers: it has a transient part of the strain, too. Power Law: it flows faster than "
          "in proportion to stress. Von Mises: it yields at a shear stress. Drucker-Prager: it "
          "yields at a shear stress that grows with pressure.");
  entries.others()
    .openSublist(bulk_entries::regions, lawsOfRegions(),
                 "Each entry is a region of the mesh whose rock has a law of its own, with "
                 "its parameters; the law above holds in the others.")
    .sublist(StressAtStart::list_name, StressAtStart::validParameters(),
             "Rock that yields or has a power law has this stress at the start, positive in "
             "tension, beside that of its displacement. It has to be in equilibrium by itself, "
             "with the initial tractions on the fault. An antiplane model takes XZ, YZ and "
             "the mean of XX, YY and ZZ; it has no effect on other rock.");
  return entries;
}
} // namespace

RCP<const ParameterList> bulkParameters() { return bulkEntries().list(); }

BulkSettings BulkSettings::from(ParameterList const& list)
{
  auto settings = bulkEntries().read(list, bulk_path);
  if (isLeftOut(list, gravity_direction_entry)) {
    settings.gravity_direction.reset();
  }
  return settings;
}

std::string BulkSettings::model() const
{
  auto const words = models();
  return std::find_if(words.begin(), words.end(),
                      [this](auto const& each) { return each.second == components; })
    ->first;
}

bool BulkSettings::isQuasiDynamic() const { return dynamics == quasi_dynamic; }

bool choosesQuasiDynamic(ParameterList const& list)
{
  return list.isType<std::string>(dynamics_entry) &&
         list.get<std::string>(dynamics_entry) == quasi_dynamic;
}

Entries<LawOfRegion> LawOfRegion::entries()
{
  Entries<LawOfRegion> entries;
  addLaws(entries, bulk_entries::law, &LawOfRegion::law, required, fem::bulkLaws(),
          "Selects the law of the rock in the region.");
  return entries;
}

void requireDimension(BulkSettings const& bulk, int dimension)
{
  ASPERITY_REQUIRE((bulk.components == 3) == (dimension == 3),
                   bulk_path << " / Model = " << bulk.model() << ", but the mesh has " << dimension
                             << " dimensions. Choose "
                             << (dimension == 3 ? "Solid." : "Plane Strain or Antiplane."));
}

std::vector<double> radiationDamping(BulkSettings const& bulk, ParameterList const& list,
                                     FieldNodes const& nodes, fem::OtherSide const& other_side,
                                     std::vector<fem::Material> const& at_nodes)
{
  if (!bulk.isQuasiDynamic()) {
    return std::vector<double>(at_nodes.size(), 0.);
  }
  auto const& chosen = list.sublist(quasi_dynamic);
  if (isGiven(chosen, radiation_damping)) {
    return nodalValues(chosen, radiation_damping, joinPath(bulk_path, quasi_dynamic), nodes);
  }
  std::vector<double> eta;
  eta.reserve(at_nodes.size());
  for (auto const& material : at_nodes) {
    // G / cs = rho cs, shared by the sides that radiate
    eta.push_back(material.shearImpedance() / other_side.deforming_sides);
  }
  return eta;
}

template <int Dim>
std::array<double, Dim> gravity(BulkSettings const& bulk, std::array<double, 3> const& down)
{
  const double acceleration = bulk.gravity;
  std::array<double, Dim> result{};
  if (acceleration == 0) {
    return result;
  }
  ASPERITY_REQUIRE(bulk.components > 1, bulk_path
                                          << " / Gravitational Acceleration = " << acceleration
                                          << " does nothing to an antiplane model. Leave it out.");
  const Teuchos::Array<double> direction =
    bulk.gravity_direction.value_or(std::vector<double>(down.begin(), down.begin() + Dim));
  double square = 0;
  for (double component : direction) {
    square += component * component;
  }
  ASPERITY_REQUIRE(square > 0 && direction.size() >= 2 && direction.size() <= Dim,
                   joinPath(bulk_path, gravity_direction_entry)
                     << " = " << direction.toString() << " is no direction. Give two numbers"
                     << (Dim == 3 ? " or three" : "") << ", not all zero.");
  for (int d = 0; d < direction.size(); ++d) {
    result[d] = acceleration * direction[d] / std::sqrt(square);
  }
  return result;
}

template std::array<double, 2> gravity<2>(BulkSettings const&, std::array<double, 3> const&);
template std::array<double, 3> gravity<3>(BulkSettings const&, std::array<double, 3> const&);
} // namespace asperity::scenario
