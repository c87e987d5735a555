#include "scenario/setup/rock/RockSetup.hpp"

#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Gather.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/Simplex.hpp"
#include "fem/bulk/BulkLaw.hpp"
#include "parameters/ParameterValue.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/ParameterTable.hpp"
#include "scenario/setup/rock/BulkEntries.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"
#include "scenario/setup/rock/StressAtStart.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace asperity::scenario
{
namespace
{
// The elastic constants, from moduli or from wave speeds.
class Elasticity
{
public:
  Elasticity(BulkSettings const& bulk, ParameterList const& list,
             std::vector<std::string> const& region_names)
      : bulk_(fieldOf(list, bulk_entries::bulk_modulus, region_names))
      , shear_(fieldOf(list, bulk_entries::shear_modulus, region_names))
      , poisson_(fieldOf(list, bulk_entries::poissons_ratio, region_names))
      , p_wave_(fieldOf(list, bulk_entries::p_wave_speed, region_names))
      , s_wave_(fieldOf(list, bulk_entries::s_wave_speed, region_names))
      , antiplane_(bulk.components == 1)
  {
    const int given = bulk_.has_value() + shear_.has_value() + poisson_.has_value();
    if (p_wave_ || s_wave_) {
      requireSpeeds(given);
      return;
    }
    const bool enough = given == 2 || (antiplane_ && shear_ && given == 1);
    ASPERITY_REQUIRE(enough, bulk_path << ": " << given << " of '" << bulk_entries::bulk_modulus
                                       << "', '" << bulk_entries::shear_modulus << "' and '"
                                       << bulk_entries::poissons_ratio
                                       << "' are given; the elastic body needs exactly two"
                                       << (antiplane_ ? ", or the shear modulus alone" : "")
                                       << ", or wave speeds instead.");
  }

  template <int Dim>
  void read(Mesh<Dim> const& mesh)
  {
    for (auto* field : {&bulk_, &shear_, &poisson_, &p_wave_, &s_wave_}) {
      if (*field) {
        (*field)->read(mesh);
      }
    }
  }

  // The material has its density.
  void set(fem::Material& material, CellPlace const& place) const
  {
    if (s_wave_) {
      setFromSpeeds(material, place);
    } else {
      setFromModuli(material, place);
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

  void requireSpeeds(int num_moduli) const
  {
    auto const* const given = p_wave_ ? bulk_entries::p_wave_speed : bulk_entries::s_wave_speed;
    ASPERITY_REQUIRE(num_moduli == 0, bulk_path << " / " << given
                                                << " is given beside a modulus or Poisson's ratio. "
                                                   "Give moduli or wave speeds, not both.");
    ASPERITY_REQUIRE(
      s_wave_ && (p_wave_ || antiplane_),
      bulk_path << " / " << (s_wave_ ? bulk_entries::p_wave_speed : bulk_entries::s_wave_speed)
                << " is missing: the elastic body needs both wave speeds"
                << (antiplane_ ? ", or that of shear waves alone." : "."));
  }

  void setFromModuli(fem::Material& material, CellPlace const& place) const
  {
    const auto at = [&](std::optional<CellField> const& field) { return (*field)(place); };
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

  // G = rho cs^2, K = rho (cp^2 - 4/3 cs^2)
  void setFromSpeeds(fem::Material& material, CellPlace const& place) const
  {
    const double shear = (*s_wave_)(place);
    material.shear_modulus = material.density * shear * shear;
    if (!p_wave_) {
      return;
    }
    const double compressional = (*p_wave_)(place);
    const double difference = compressional * compressional - 4. / 3 * shear * shear;
    auto const& x = place.centroid;
    ASPERITY_REQUIRE(difference > 0, bulk_path
                                       << " / " << bulk_entries::p_wave_speed << " is "
                                       << formatShort(compressional) << " m/s at (x, y, z) = "
                                       << formatPoint({x.begin(), x.end()}) << " m, but "
                                       << bulk_entries::s_wave_speed << " is " << formatShort(shear)
                                       << " m/s. The bulk modulus is positive only where the first "
                                          "is above sqrt(4/3) = 1.155 times the second.");
    material.bulk_modulus = material.density * difference;
  }

  std::optional<CellField> bulk_, shear_, poisson_, p_wave_, s_wave_;
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
    for (auto const& relaxation : shares) {
      mine.push_back(relaxation.time);
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
      for (auto const& relaxation : of_cells[cell]) {
        branches.back().moduli[cell] +=
          relaxation.time == time ? relaxation.share * materials[cell].shear_modulus : 0;
      }
    }
  }
  return branches;
}

// A law and its parameters as fields.
class LawOfRock
{
public:
  // list: has the parameters of the law. used: the regions that have this law.
  LawOfRock(std::string const& name, ParameterList const& list, std::string const& path,
            std::vector<std::string> const& region_names, std::vector<bool> const& used)
      : law_(fem::bulkLaws().at(name))
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
    if (law_.yields()) {
      yielding_.cells.push_back(place.cell);
      yielding_.parameters.insert(yielding_.parameters.end(), values_.begin(), values_.end());
    }
    return law_.relaxation(values_.data(), material);
  }

  // The cells so far, if they yield.
  std::optional<fem::YieldingRock::Part> yielding() const
  {
    return law_.yields()
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

// Where all rock is elastic or viscous, its stress counts from the start.
void refuseStressAtStart(ParameterList const& list)
{
  if (!hasGivenEntry(list.sublist(StressAtStart::list_name))) {
    return;
  }
  std::vector<std::string> laws;
  for (auto const& name : fem::bulkLaws().names()) {
    if (fem::bulkLaws().at(name).yields()) {
      laws.push_back(name);
    }
  }
  throw InputError(joinPath(bulk_path, StressAtStart::list_name) +
                   " has no effect: no cell has a Law that asks for it, " +
                   quotedAlternatives(laws) +
                   ". The stress on the fault is that of Friction / Shear Traction and Friction / "
                   "Normal Stress. Remove the list, or choose such a Law.");
}

// The rock that yields; nullopt if no rank has a cell that does.
template <int Dim>
std::optional<fem::YieldingRock>
yieldingRock(BulkSettings const& bulk, ParameterList const& list, Mesh<Dim> const& mesh,
             std::vector<LawOfRock> const& laws, Communicator const& communicator)
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
    refuseStressAtStart(list);
    return std::nullopt;
  }
  StressAtStart stress(list.sublist(StressAtStart::list_name), mesh.region_names);
  onEveryRank(communicator, [&] {
    stress.read(mesh);
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
      stress.append(placeOf(mesh, cell), bulk.components, rock);
    }
  });
  return rock;
}
} // namespace

template <int Dim>
Rock makeRock(BulkSettings const& bulk, ParameterList const& list, Mesh<Dim> const& mesh,
              Communicator const& communicator)
{
  auto const& regions = mesh.region_names;
  Elasticity elasticity(bulk, list, regions);
  CellField density(steadyField(list, bulk_entries::density, bulk_path, regions));
  auto const& own_laws = list.sublist(bulk_entries::regions);
  std::vector<bool> of_main_law(regions.size(), true);
  std::map<std::size_t, LawOfRock> own;
  for (auto const& name : namesIn(own_laws)) {
    auto const path = joinPath(joinPath(bulk_path, bulk_entries::regions), name);
    auto const region = regionOf(name, path, regions);
    std::vector<bool> used(regions.size(), false);
    used[region] = true;
    of_main_law[region] = false;
    auto const& own_list = own_laws.sublist(name);
    own.emplace(region, LawOfRock(LawOfRegion::entries().read(own_list, path).law, own_list, path,
                                  regions, used));
  }
  std::vector<LawOfRock> laws(regions.size(),
                              LawOfRock(bulk.law, list, bulk_path, regions, of_main_law));
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
  auto yielding = yieldingRock(bulk, list, mesh, laws, communicator);
  return {std::move(materials), std::move(branches), std::move(yielding)};
}

template <int Dim>
std::vector<fem::Material> elasticRockAt(BulkSettings const& bulk, ParameterList const& list,
                                         Mesh<Dim> const& mesh, std::vector<int> const& cells,
                                         std::vector<std::array<double, 3>> const& places)
{
  Elasticity elasticity(bulk, list, mesh.region_names);
  CellField density(steadyField(list, bulk_entries::density, bulk_path, mesh.region_names));
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
  template Rock makeRock(BulkSettings const&, ParameterList const&, Mesh<Dim> const&,              \
                         Communicator const&);                                                     \
  template std::vector<fem::Material> elasticRockAt(BulkSettings const&, ParameterList const&,     \
                                                    Mesh<Dim> const&, std::vector<int> const&,     \
                                                    std::vector<std::array<double, 3>> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
