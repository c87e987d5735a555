#include "scenario/setup/BulkSetup.hpp"

#include "base/parallel/Agreement.hpp"
#include "base/parallel/Gather.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/Simplex.hpp"
#include "fem/bulk/BulkLaw.hpp"
#include "parameters/ParameterValue.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/ParameterTable.hpp"
#include "scenario/setup/StressAtStart.hpp"
#include "scenario/setup/Upright.hpp"
#include "scenario/setup/VolumetricSetup.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace asperity::scenario
{
namespace
{
// Elastic constants of which any two determine the others.
constexpr char const* bulk_modulus = "Bulk Modulus";
constexpr char const* shear_modulus = "Shear Modulus";
constexpr char const* poisson = "Poisson's Ratio";
constexpr char const* radiation_damping = "Radiation Damping";
constexpr char const* law_choice = "Law";
constexpr char const* in_regions = "Regions";

RCP<const ParameterList> lawsOfRegions()
{
  Declare one;
  declareChoice(one, law_choice, required, fem::bulkLaws(),
                "Selects the law of the rock in the region.");
  return Declare()
    .sublist("<region>", one.list(), "Names a region of the mesh and gives the law of its rock.")
    .list();
}
} // namespace

RCP<const ParameterList> bulkParameters()
{
  auto const quasi_dynamic =
    Declare()
      .field(
        radiation_damping, optional, "Pa s/m", Range::atLeast(0),
        "This is eta in tau = friction + eta V, where V is the slip rate. If it is left out, "
        "eta is G / (2 cs) on an antisymmetric fault and G / cs in bilateral contact; between two "
        "bodies it is Z1 Z2 / (Z1 + Z2) with their impedances Z = G / cs.")
      .list();
  Declare declare;
  declare
    .choice("Model", "Plane Strain", {"Plane Strain", "Antiplane", "Solid"},
            "Selects the components of the displacement. Plane Strain: it lies in the plane of the "
            "mesh. Antiplane: it is perpendicular to that plane. Solid: it has all three "
            "components on a mesh in space.")
    .choiceOfLists("Dynamics", "Inertial",
                   {{"Inertial", Declare().list()}, {"Quasi-dynamic", quasi_dynamic}},
                   "Selects whether the body has inertia. Inertial: it has mass, and waves travel "
                   "through it. Quasi-dynamic: it has no mass, and a radiation damping takes from "
                   "the fault the energy that waves would carry away.")
    .field("Density", required, "kg/m^3", Range::positive(), "The material has this mass density.")
    .field(bulk_modulus, optional, "Pa", Range::positive(),
           "The material has this bulk modulus. Plane strain and solids need exactly two of bulk "
           "modulus, shear modulus and Poisson's ratio.")
    .field(shear_modulus, optional, "Pa", Range::positive(),
           "The material has this shear modulus. Antiplane models need either this alone or two of "
           "the three moduli.")
    .field(poisson, optional, "-", Range::open(-1, 0.5), "The material has this Poisson's ratio.")
    .real("Gravitational Acceleration", 0., "m/s^2", Range::atLeast(0),
          "Gravity accelerates the body by this value. An antiplane model has no gravity.")
    .realArray("Gravity Direction", optional, "-", Range::any(),
               "Gravity points in the direction of this vector in x, y and, in three dimensions, z "
               "(0 if left out). Its length has no effect. If it is left out, gravity points down: "
               "against Output / Up or, without that, against the axis that is nearest to the "
               "outward normal of the Free Surface; along -y if the deck has neither.");
  declareVolumetricStrain(declare);
  declareChoice(
    declare, law_choice, "Kelvin-Voigt", fem::bulkLaws(),
    "Selects the law of the rock: how it creeps or flows. Kelvin-Voigt: it damps "
    "waves; without viscosity it is elastic. Maxwell: its shear stress relaxes. "
    "Burgers: it has a transient part of the strain, too. Power Law: it flows faster than "
    "in proportion to stress. Von Mises: it yields at a shear stress. Drucker-Prager: it "
    "yields at a shear stress that grows with pressure.");
  declare.openSublist(in_regions, lawsOfRegions(),
                      "Each entry is a region of the mesh whose rock has a law of its own, with "
                      "its parameters; the law above holds in the others.");
  declare.sublist(
    StressAtStart::list_name, StressAtStart::validParameters(),
    "Rock that yields or has a power law has this stress at the start, positive in "
    "tension, beside that of its displacement. It has to be in equilibrium by itself, "
    "with the initial tractions on the fault. An antiplane model takes XZ, YZ and "
    "the mean of XX, YY and ZZ; it has no effect on other rock.");
  return declare.list();
}

int displacementComponents(ParameterList const& list)
{
  auto const model = list.get<std::string>("Model");
  return model == "Antiplane" ? 1 : model == "Plane Strain" ? 2 : 3;
}

int displacementComponents(ParameterList const& list, int dimension)
{
  const int components = displacementComponents(list);
  ASPERITY_REQUIRE((components == 3) == (dimension == 3),
                   bulk_path << " / Model = " << list.get<std::string>("Model")
                             << ", but the mesh has " << dimension << " dimensions. Choose "
                             << (dimension == 3 ? "Solid." : "Plane Strain or Antiplane."));
  return components;
}

bool quasiDynamic(ParameterList const& list)
{
  return list.get<std::string>("Dynamics") == "Quasi-dynamic";
}

std::vector<double> radiationDamping(ParameterList const& list, FieldNodes const& nodes,
                                     fem::OtherSide const& other_side,
                                     std::vector<fem::Material> const& at_nodes)
{
  if (!quasiDynamic(list)) {
    return std::vector<double>(at_nodes.size(), 0.);
  }
  auto const& chosen = list.sublist("Quasi-dynamic");
  if (isGiven(chosen, radiation_damping)) {
    return nodalValues(chosen, radiation_damping, bulk_path + " / Quasi-dynamic", nodes);
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
std::array<double, Dim> gravity(ParameterList const& list, std::array<double, 3> const& down)
{
  const double acceleration = list.get<double>("Gravitational Acceleration");
  std::array<double, Dim> result{};
  if (acceleration == 0) {
    return result;
  }
  ASPERITY_REQUIRE(displacementComponents(list) > 1,
                   bulk_path << " / Gravitational Acceleration = " << acceleration
                             << " does nothing to an antiplane model. Leave it out.");
  auto const direction = isLeftOut(list, "Gravity Direction")
                           ? Teuchos::Array<double>(down.begin(), down.begin() + Dim)
                           : list.get<Teuchos::Array<double>>("Gravity Direction");
  double square = 0;
  for (double component : direction) {
    square += component * component;
  }
  ASPERITY_REQUIRE(square > 0 && direction.size() >= 2 && direction.size() <= Dim,
                   bulk_path << " / Gravity Direction = " << direction.toString()
                             << " is no direction. Give two numbers"
                             << (Dim == 3 ? " or three" : "") << ", not all zero.");
  for (int d = 0; d < direction.size(); ++d) {
    result[d] = acceleration * direction[d] / std::sqrt(square);
  }
  return result;
}

namespace
{
class Elasticity
{
public:
  Elasticity(ParameterList const& list, std::vector<std::string> const& region_names)
      : bulk_(fieldOf(list, bulk_modulus, region_names))
      , shear_(fieldOf(list, shear_modulus, region_names))
      , poisson_(fieldOf(list, poisson, region_names))
      , antiplane_(displacementComponents(list) == 1)
  {
    const int given = bulk_.has_value() + shear_.has_value() + poisson_.has_value();
    const bool enough = given == 2 || (antiplane_ && shear_ && given == 1);
    ASPERITY_REQUIRE(enough, bulk_path << ": " << given << " of '" << bulk_modulus << "', '"
                                       << shear_modulus << "' and '" << poisson
                                       << "' are given; the elastic body needs exactly two"
                                       << (antiplane_ ? ", or the shear modulus alone." : "."));
  }

  template <int Dim>
  void read(Mesh<Dim> const& mesh)
  {
    for (auto* field : {&bulk_, &shear_, &poisson_}) {
      if (*field) {
        (*field)->read(mesh);
      }
    }
  }

  void set(fem::Material& material, CellPlace const& place) const
  {
    auto const at = [&](std::optional<CellField> const& field) { return (*field)(place); };
    if (shear_) {
      material.shear_modulus = at(shear_);
    } else {
      const double nu = at(poisson_);
      material.shear_modulus = 3 * at(bulk_) * (1 - 2 * nu) / (2 * (1 + nu));
    }
    if (bulk_) {
      material.bulk_modulus = at(bulk_);
    } else if (poisson_) {
      const double nu = at(poisson_);
      material.bulk_modulus = 2 * material.shear_modulus * (1 + nu) / (3 * (1 - 2 * nu));
    }
  }

private:
  static std::optional<CellField> fieldOf(ParameterList const& list, char const* name,
                                          std::vector<std::string> const& region_names)
  {
    return isGiven(list, name)
             ? std::optional<CellField>(steadyField(list, name, bulk_path, region_names))
             : std::nullopt;
  }

  std::optional<CellField> bulk_, shear_, poisson_;
  bool antiplane_;
};

// Each one costs a matrix, a vector of the state, and a product in every step.
constexpr std::size_t most_branches = 8;

// The relaxing shares of cells by their relaxation time, which all ranks have in the same order.
std::vector<fem::MaxwellBranch>
branchesOf(std::vector<std::vector<fem::RelaxingShare>> const& of_cells,
           std::vector<fem::Material> const& materials, Communicator const& communicator)
{
  std::vector<double> mine;
  for (auto const& shares : of_cells) {
    for (auto const& of : shares) {
      mine.push_back(of.time);
    }
  }
  const auto distinct = [](std::vector<double> times) {
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
  };
  auto const times = distinct(gatherToAll(distinct(std::move(mine)), communicator));
  ASPERITY_REQUIRE(times.size() <= most_branches,
                   bulk_path << ": the body has " << times.size() << " relaxation times, from "
                             << times.front() << " to " << times.back() << " s; at most "
                             << most_branches
                             << " are possible. Make viscosity and shear modulus constant in "
                                "regions.");
  std::vector<fem::MaxwellBranch> branches;
  for (const double time : times) {
    branches.push_back({time, std::vector<double>(of_cells.size(), 0.)});
    for (std::size_t cell = 0; cell < of_cells.size(); ++cell) {
      for (auto const& of : of_cells[cell]) {
        branches.back().moduli[cell] +=
          of.time == time ? of.share * materials[cell].shear_modulus : 0;
      }
    }
  }
  return branches;
}

// A law and its parameters as fields.
class LawOfRock
{
public:
  // used: the regions that have this law.
  LawOfRock(ParameterList const& list, std::string const& path,
            std::vector<std::string> const& region_names, std::vector<bool> const& used)
      : law_(fem::bulkLaws().at(list.get<std::string>(law_choice)))
  {
    for (auto const& parameter : law_.parameters) {
      fields_.emplace_back(steadyField(list, parameter.name, path, region_names, used));
    }
    values_.resize(fields_.size());
  }

  template <int Dim>
  void read(Mesh<Dim> const& mesh)
  {
    for (auto& field : fields_) {
      field.read(mesh);
    }
  }

  // Completes the material of a cell; returns what relaxes in it.
  std::vector<fem::RelaxingShare> apply(CellPlace const& place, fem::Material& material)
  {
    std::transform(fields_.begin(), fields_.end(), values_.begin(),
                   [&](CellField const& field) { return field(place); });
    law_.complete(values_.data(), material);
    if (law_.yield) {
      yielding_.cells.push_back(place.cell);
      yielding_.parameters.insert(yielding_.parameters.end(), values_.begin(), values_.end());
    }
    return law_.relaxation(values_.data(), material);
  }

  // The cells so far, if they yield.
  std::optional<fem::YieldingRock::Part> yielding() const
  {
    return law_.yield
             ? std::optional<fem::YieldingRock::Part>({law_, yielding_.cells, yielding_.parameters})
             : std::nullopt;
  }

private:
  fem::BulkLaw law_;
  std::vector<CellField> fields_;
  std::vector<double> values_;
  fem::YieldingRock::Part yielding_;
};

template <int Dim>
CellPlace placeOf(Mesh<Dim> const& mesh, std::size_t cell)
{
  const int number = static_cast<int>(cell);
  return {number, inSpace<Dim>(fem::simplexOf(mesh, number).centroid), mesh.cell_regions[cell]};
}

// None if no rank has a cell that yields.
template <int Dim>
std::optional<fem::YieldingRock> yieldingRock(ParameterList const& list, Mesh<Dim> const& mesh,
                                              std::vector<LawOfRock> const& laws,
                                              Communicator const& communicator)
{
  fem::YieldingRock rock;
  std::int64_t num_cells = 0;
  for (auto const& law : laws) {
    if (auto part = law.yielding()) {
      num_cells += static_cast<std::int64_t>(part->cells.size());
      rock.parts.push_back(std::move(*part));
    }
  }
  if (sumOverRanks(num_cells, communicator) == 0) {
    return std::nullopt;
  }
  const int components = displacementComponents(list);
  StressAtStart stress(list.sublist(StressAtStart::list_name), mesh.region_names);
  onEveryRank(communicator, [&] {
    stress.read(mesh);
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
      stress.append(placeOf(mesh, cell), components, rock);
    }
  });
  return rock;
}
} // namespace

template <int Dim>
Rock makeRock(ParameterList const& list, Mesh<Dim> const& mesh, Communicator const& communicator)
{
  auto const& regions = mesh.region_names;
  Elasticity elasticity(list, regions);
  CellField density(steadyField(list, "Density", bulk_path, regions));
  auto const& own_laws = list.sublist(in_regions);
  std::vector<bool> of_main_law(regions.size(), true);
  std::map<std::size_t, LawOfRock> own;
  for (auto const& name : namesIn(own_laws)) {
    auto const path = joinPath(joinPath(bulk_path, in_regions), name);
    auto const region = regionOf(name, path, regions);
    std::vector<bool> used(regions.size(), false);
    used[region] = true;
    of_main_law[region] = false;
    own.emplace(region, LawOfRock(own_laws.sublist(name), path, regions, used));
  }
  std::vector<LawOfRock> laws(regions.size(), LawOfRock(list, bulk_path, regions, of_main_law));
  for (auto const& [region, law] : own) {
    laws[region] = law;
  }
  std::vector<fem::Material> materials(mesh.cells.size());
  std::vector<std::vector<fem::RelaxingShare>> relaxation;
  onEveryRank(communicator, [&] { // a region may lie on one rank alone
    density.read(mesh);
    elasticity.read(mesh);
    for (auto& law : laws) {
      law.read(mesh);
    }
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
      auto const place = placeOf(mesh, cell);
      auto& material = materials[cell];
      material.density = density(place);
      elasticity.set(material, place);
      relaxation.push_back(laws[place.region].apply(place, material));
    }
  });
  auto branches = branchesOf(relaxation, materials, communicator);
  auto yielding = yieldingRock(list, mesh, laws, communicator);
  return {std::move(materials), std::move(branches), std::move(yielding)};
}

template <int Dim>
std::vector<fem::Material> elasticRockAt(ParameterList const& list, Mesh<Dim> const& mesh,
                                         std::vector<int> const& cells,
                                         std::vector<std::array<double, 3>> const& places)
{
  Elasticity elasticity(list, mesh.region_names);
  CellField density(steadyField(list, "Density", bulk_path, mesh.region_names));
  elasticity.read(mesh);
  density.read(mesh);
  std::vector<fem::Material> materials(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellPlace place{cells[i], places[i], mesh.cell_regions[cells[i]]};
    materials[i].density = density(place);
    elasticity.set(materials[i], place);
  }
  return materials;
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template Rock makeRock(ParameterList const&, Mesh<Dim> const&, Communicator const&);             \
  template std::vector<fem::Material> elasticRockAt(ParameterList const&, Mesh<Dim> const&,        \
                                                    std::vector<int> const&,                       \
                                                    std::vector<std::array<double, 3>> const&);    \
  template std::array<double, Dim> gravity<Dim>(ParameterList const&, std::array<double, 3> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
