#include "scenario/setup/FaultLoads.hpp"

#include "fem/NodalFrames.hpp"
#include "friction/Registry.hpp"
#include "scenario/setup/FrictionSetup.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
namespace
{
const std::string path = "Asperity / Friction";

// traction(num_nodes, T), times each node's share of the fault.
void addTraction(std::vector<double> const& traction, std::vector<double> const& weights,
                 std::vector<std::vector<int>> const& dofs, Vector& load)
{
  auto const values = load.getLocalViewHost(Tpetra::Access::ReadWrite);
  std::size_t entry = 0;
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    for (int dof : dofs[i]) {
      values(dof, 0) += weights[i] * traction[entry++];
    }
  }
}

void fill(std::vector<double> const& values, double factor, friction::NodeView const& view)
{
  auto const host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < values.size(); ++i) {
    host(i) = factor * std::max(values[i], 0.);
  }
  Kokkos::deep_copy(view, host);
}

template <int Dim>
std::vector<double> givenStress(NodalField const& field, Mesh<Dim> const& mesh,
                                std::vector<int> const& nodes)
{
  auto const values = field.at(0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASPERITY_REQUIRE(values[i] >= 0, joinPath(path, "Normal Stress")
                                       << " = " << values[i]
                                       << " at x = " << formatPoint<Dim>(mesh.vertices[nodes[i]])
                                       << ", t = 0, is outside [0, inf). Check the sign: "
                                          "compression is positive.");
  }
  return values;
}
std::vector<double> slipDirection(ParameterList const& friction)
{
  auto const given = friction.get<Teuchos::Array<double>>("Slip Direction").toVector();
  ASPERITY_REQUIRE(given.size() == 3 && std::hypot(given[0], given[1], given[2]) > 0,
                   joinPath(path, "Slip Direction")
                     << " needs three numbers, not all zero: where the shear traction points.");
  return given;
}

// Of `towards` onto the fault at a node, as a unit vector along the tangents there.
template <std::size_t Dim>
std::vector<double> projection(std::vector<double> const& towards, fem::NodalFrames const& frames,
                               int node, std::array<double, Dim> const& normal)
{
  std::vector<double> result;
  double square = 0;
  for (int tangent : fem::tangentialComponents(frames, node, normal)) {
    double along = 0;
    for (std::size_t c = 0; c < Dim; ++c) {
      along += frames.entry(node, tangent, static_cast<int>(c)) * towards[c];
    }
    result.push_back(along);
    square += along * along;
  }
  const double length = std::hypot(towards[0], towards[1], towards[2]);
  ASPERITY_REQUIRE(std::sqrt(square) > 1e-6 * length,
                   joinPath(path, "Slip Direction")
                     << " is at right angles to the fault somewhere. Choose one along it.");
  for (double& x : result) {
    x /= std::sqrt(square);
  }
  return result;
}
} // namespace

template <int Dim>
ShearTraction::ShearTraction(ParameterList const& friction, Mesh<Dim> const& mesh,
                             fem::BoundaryNodes<Dim> const& nodes, fem::NodalFrames const& frames)
    : size_(friction, "Shear Traction", path, mesh, nodes.nodes)
{
  if (Dim == 2) {
    direction_.assign(nodes.nodes.size(), 1.);
    return;
  }
  auto const towards = slipDirection(friction);
  for (std::size_t i = 0; i < nodes.nodes.size(); ++i) {
    auto const projected = projection(towards, frames, nodes.nodes[i], nodes.normals[i]);
    direction_.insert(direction_.end(), projected.begin(), projected.end());
  }
}

std::vector<double> ShearTraction::at(double t) const
{
  auto const sizes = size_.at(t);
  auto result = direction_;
  const std::size_t num_tangents = sizes.empty() ? 1 : result.size() / sizes.size();
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] *= sizes[i / num_tangents];
  }
  return result;
}

std::function<void(double, Vector&)> loadWithTraction(ShearTraction const& traction,
                                                      std::vector<double> const& weights,
                                                      dynamics::Fault const& fault,
                                                      RCP<const Vector> const& constant)
{
  auto const dofs = fault.dofs;
  if (!traction.dependsOnTime()) {
    auto const load = rcp(new Vector(*constant, Teuchos::Copy));
    addTraction(traction.at(0), weights, dofs, *load);
    return [load](double, Vector& l) { Tpetra::deep_copy(l, *load); };
  }
  return [traction, weights, dofs, constant](double t, Vector& l) {
    Tpetra::deep_copy(l, *constant);
    addTraction(traction.at(t), weights, dofs, l);
  };
}

template <int Dim>
void setNormalStress(dynamics::Fault& fault, ParameterList const& friction, Mesh<Dim> const& mesh,
                     std::vector<int> const& nodes, NormalStress& stress)
{
  const double factor = friction.get<double>("Normal Stress Factor");
  fault.normal_stress = friction::NodeView("asperity::scenario::normalStress", nodes.size());
  fault.data.sigma_n = fault.normal_stress;
  if (isGiven(friction, "Normal Stress")) {
    const NodalField given(friction, "Normal Stress", path, mesh, nodes);
    stress.values = givenStress(given, mesh, nodes);
    if (given.dependsOnTime()) {
      fault.normal_stress_at = [given, factor](double t, friction::NodeView const& view) {
        fill(given.at(t), factor, view);
      };
    }
  }
  const auto num_tensile = std::count_if(stress.values.begin(), stress.values.end(),
                                         [](double value) { return value < 0; });
  stress.num_tensile = fault.sumOverRanks(static_cast<int>(num_tensile));
  fill(stress.values, factor, fault.normal_stress);
  fault.friction = friction::makeFrictionKernels(friction.get<std::string>("Law"), fault.data);
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template ShearTraction::ShearTraction(ParameterList const&, Mesh<Dim> const&,                    \
                                        fem::BoundaryNodes<Dim> const&, fem::NodalFrames const&);  \
  template void setNormalStress(dynamics::Fault&, ParameterList const&, Mesh<Dim> const&,          \
                                std::vector<int> const&, NormalStress&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
