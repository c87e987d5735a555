#include "scenario/BulkSetup.hpp"

#include "fem/Simplex.hpp"
#include "scenario/NodalField.hpp"

#include <cmath>
#include <optional>

namespace asperity::scenario
{
namespace
{
const std::string path = "Asperity / Bulk";

// Elastic constants of which any two determine the others.
constexpr char const* bulk_modulus = "Bulk Modulus";
constexpr char const* shear_modulus = "Shear Modulus";
constexpr char const* poisson = "Poisson's Ratio";
constexpr char const* radiation_damping = "Radiation Damping";
} // namespace

RCP<const ParameterList> bulkParameters()
{
  auto const quasi_dynamic =
    Declare()
      .field(radiation_damping, optional, "Pa s/m", Range::atLeast(0),
             "eta in tau = friction + eta V, V the slip rate; left out, G / (2 cs) on an "
             "antisymmetric fault and G / cs in bilateral contact.")
      .list();
  return Declare()
    .choice("Model", "Plane Strain", {"Plane Strain", "Antiplane"},
            "Displacement within the plane of the mesh, or perpendicular to it.")
    .choiceOfLists("Dynamics", "Inertial",
                   {{"Inertial", Declare().list()}, {"Quasi-dynamic", quasi_dynamic}},
                   "Inertial: with mass, and waves. Quasi-dynamic: without mass; the fault loses "
                   "what waves would carry away to a radiation damping.")
    .field("Density", required, "kg/m^3", Range::positive(), "Mass density.")
    .field(
      bulk_modulus, optional, "Pa", Range::positive(),
      "Bulk modulus; plane strain needs two of bulk modulus, shear modulus and Poisson's ratio.")
    .field(shear_modulus, optional, "Pa", Range::positive(),
           "Shear modulus; antiplane needs it, or both others.")
    .field(poisson, optional, "-", Range::open(-1, 0.5), "Poisson's ratio.")
    .field("Shear Viscosity", 0., "Pa s", Range::atLeast(0), "Viscosity of the change of shape.")
    .field("Bulk Viscosity", 0., "Pa s", Range::atLeast(0), "Viscosity of the change of volume.")
    .real("Gravitational Acceleration", 0., "m/s^2", Range::atLeast(0),
          "Acceleration of gravity; plane strain only.")
    .realArray("Gravity Direction", std::vector<double>{0., -1.}, "-", Range::any(),
               "Where down is, in x and y; any length.")
    .list();
}

int displacementComponents(ParameterList const& list)
{
  return list.get<std::string>("Model") == "Antiplane" ? 1 : 2;
}

bool quasiDynamic(ParameterList const& list)
{
  return list.get<std::string>("Dynamics") == "Quasi-dynamic";
}

std::vector<double> radiationDamping(ParameterList const& list, Mesh<2> const& mesh,
                                     std::vector<int> const& nodes,
                                     std::vector<fem::Material> const& at_nodes, double slip_factor)
{
  if (!quasiDynamic(list)) {
    return std::vector<double>(nodes.size(), 0.);
  }
  auto const& chosen = list.sublist("Quasi-dynamic");
  if (isGiven(chosen, radiation_damping)) {
    return nodalValues(chosen, radiation_damping, path + " / Quasi-dynamic", mesh, nodes);
  }
  std::vector<double> eta;
  for (auto const& material : at_nodes) {
    eta.push_back(material.shearImpedance() / slip_factor); // G / cs = rho cs
  }
  return eta;
}

std::array<double, 2> gravity(ParameterList const& list)
{
  const double acceleration = list.get<double>("Gravitational Acceleration");
  if (acceleration == 0) {
    return {0, 0};
  }
  ASPERITY_REQUIRE(displacementComponents(list) == 2,
                   path << " / Gravitational Acceleration = " << acceleration
                        << " does nothing to an antiplane model. Leave it out.");
  auto const direction = list.get<Teuchos::Array<double>>("Gravity Direction");
  const double size = direction.size() == 2 ? std::hypot(direction[0], direction[1]) : 0;
  ASPERITY_REQUIRE(size > 0, path << " / Gravity Direction = " << direction.toString()
                                  << " is no direction. Give two numbers, not both zero.");
  return {acceleration * direction[0] / size, acceleration * direction[1] / size};
}

namespace
{
class Elasticity
{
public:
  Elasticity(ParameterList const& list, Mesh<2> const& mesh)
      : bulk_(read(list, bulk_modulus, mesh))
      , shear_(read(list, shear_modulus, mesh))
      , poisson_(read(list, poisson, mesh))
      , antiplane_(displacementComponents(list) == 1)
  {
    const int given = bulk_.has_value() + shear_.has_value() + poisson_.has_value();
    const bool enough = given == 2 || (antiplane_ && shear_ && given == 1);
    ASPERITY_REQUIRE(enough, path << ": " << given << " of '" << bulk_modulus << "', '"
                                  << shear_modulus << "' and '" << poisson
                                  << "' are given; the elastic body needs exactly two"
                                  << (antiplane_ ? ", or the shear modulus alone." : "."));
  }

  void set(fem::Material& material, std::array<double, 3> const& x, int region) const
  {
    auto const at = [&](std::optional<Field> const& field) { return (*field)(x, 0, region); };
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
  static std::optional<Field> read(ParameterList const& list, char const* name, Mesh<2> const& mesh)
  {
    return isGiven(list, name) ? std::optional<Field>(steadyField(list, name, path, mesh))
                               : std::nullopt;
  }

  std::optional<Field> bulk_, shear_, poisson_;
  bool antiplane_;
};
} // namespace

std::vector<fem::Material> makeMaterials(ParameterList const& list, Mesh<2> const& mesh)
{
  const Elasticity elasticity(list, mesh);
  auto const density = steadyField(list, "Density", path, mesh);
  auto const shear_viscosity = steadyField(list, "Shear Viscosity", path, mesh);
  auto const bulk_viscosity = steadyField(list, "Bulk Viscosity", path, mesh);
  std::vector<fem::Material> materials(mesh.cells.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    auto const centroid = fem::simplexOf(mesh, static_cast<int>(cell)).centroid;
    const std::array<double, 3> x = {centroid[0], centroid[1], 0};
    const int region = mesh.cell_regions[cell];
    auto& material = materials[cell];
    material.density = density(x, 0, region);
    material.shear_viscosity = shear_viscosity(x, 0, region);
    material.bulk_viscosity = bulk_viscosity(x, 0, region);
    elasticity.set(material, x, region);
  }
  return materials;
}
} // namespace asperity::scenario
