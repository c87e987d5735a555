#include "fem/Constraints.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Vector.hpp>

#include <cmath>
#include <map>

namespace asperity::fem
{
namespace
{
using Terms = std::vector<std::pair<int, double>>;

double dot(std::vector<double> const& a, std::vector<double> const& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

void addScaled(std::vector<double>& a, double factor, std::vector<double> const& b)
{
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] += factor * b[i];
  }
}

void addScaled(Terms& terms, double factor, Terms const& others)
{
  for (auto const& [condition, coefficient] : others) {
    terms.emplace_back(condition, factor * coefficient);
  }
}

// Below this the sine of the angle between two directions counts as zero.
constexpr double parallel = 1e-8;

int axisOf(std::vector<double> const& direction)
{
  for (std::size_t i = 0; i < direction.size(); ++i) {
    if (std::abs(std::abs(direction[i]) - 1) < 1e-14) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

// Completes orthonormal directions, placed last, to a frame (not always a right-handed one).
NodalFrames::Matrix frameFrom(std::vector<std::vector<double>> const& directions, int components)
{
  auto frame = NodalFrames::identity(components);
  std::vector<std::vector<double>> basis = directions;
  for (int axis = 0; axis < components && static_cast<int>(basis.size()) < components; ++axis) {
    std::vector<double> candidate(components, 0.);
    candidate[axis] = 1;
    for (auto const& known : basis) {
      addScaled(candidate, -dot(candidate, known), known);
    }
    const double size = std::sqrt(dot(candidate, candidate));
    if (size > 0.4) {
      for (double& x : candidate) {
        x /= size;
      }
      basis.push_back(candidate);
    }
  }
  for (int k = 0; k < components; ++k) {
    for (int c = 0; c < components; ++c) {
      frame[(components - 1 - k) * components + c] = basis[k][c];
    }
  }
  return frame;
}
} // namespace

template <int Dim>
Constraints<Dim>::Constraints(Mesh<Dim> const& mesh, DofMap const& dofs,
                              std::vector<VelocityCondition<Dim>> conditions,
                              std::vector<double> const& sample_times)
    : conditions_(std::move(conditions))
    , frames_(dofs.numLocalNodes(), dofs.components())
    , fixed_(static_cast<std::size_t>(dofs.numLocalNodes()) * dofs.components(), 0)
    , owned_vertices_(mesh.vertices.begin(), mesh.vertices.begin() + mesh.num_owned)
{
  for (auto const& [node, directions] : collect(mesh)) {
    constrain(mesh, dofs, node, directions, sample_times);
  }
  shareWithGhosts(dofs);
}

template <int Dim>
typename Constraints<Dim>::NodalDirections Constraints<Dim>::collect(Mesh<Dim> const& mesh) const
{
  const int components = frames_.components();
  NodalDirections result;
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    auto const& condition = conditions_[i];
    auto const boundary = mesh.boundaries.find(condition.boundary);
    ASPERITY_REQUIRE(boundary != mesh.boundaries.end(), condition.name
                                                          << ": the mesh has no boundary '"
                                                          << condition.boundary << "'.");
    std::map<int, std::vector<double>> normals;
    for (auto const& facet : boundary->second) {
      auto const outward = mesh::areaNormal(mesh::corners<Dim>(mesh.vertices, facet));
      for (int node : facet) {
        if (node < mesh.num_owned) {
          auto& normal = normals.try_emplace(node, components, 0.).first->second;
          for (int c = 0; c < std::min(components, Dim); ++c) {
            normal[c] -= outward[c];
          }
        }
      }
    }
    for (auto& [node, normal] : normals) {
      auto direction = condition.direction.empty() ? normal : condition.direction;
      ASPERITY_ASSERT(static_cast<int>(direction.size()) == components);
      const double size = std::sqrt(dot(direction, direction));
      ASPERITY_REQUIRE(size > 0, condition.name << ": the direction has no length.");
      for (double& x : direction) {
        x /= size;
      }
      result[node].push_back({direction, static_cast<int>(i)});
    }
  }
  return result;
}

template <int Dim>
void Constraints<Dim>::constrain(Mesh<Dim> const& mesh, DofMap const& dofs, int node,
                                 std::vector<Direction> const& directions,
                                 std::vector<double> const& sample_times)
{
  const int components = frames_.components();
  std::vector<std::vector<double>> basis;
  std::vector<Terms> velocities; // of the basis directions, in terms of the conditions' velocities
  for (auto const& [vector, condition] : directions) {
    auto remainder = vector;
    Terms terms = {{condition, 1.}};
    for (std::size_t k = 0; k < basis.size(); ++k) {
      const double share = dot(vector, basis[k]);
      addScaled(remainder, -share, basis[k]);
      addScaled(terms, -share, velocities[k]);
    }
    const double size = std::sqrt(dot(remainder, remainder));
    if (size < parallel) {
      requireAgreement(mesh, node, condition, terms, sample_times);
      continue;
    }
    for (double& x : remainder) {
      x /= size;
    }
    for (auto& term : terms) {
      term.second /= size;
    }
    basis.push_back(remainder);
    velocities.push_back(terms);
  }

  bool along_axes = true;
  for (auto const& direction : basis) {
    along_axes = along_axes && axisOf(direction) >= 0;
  }
  if (!along_axes) {
    frames_.set(node, frameFrom(basis, components));
  }
  for (std::size_t k = 0; k < basis.size(); ++k) {
    const int axis = axisOf(basis[k]);
    const int row = along_axes ? axis : components - 1 - static_cast<int>(k);
    FixedRow fixed{dofs.dof(node, row), node, velocities[k]};
    if (along_axes && basis[k][axis] < 0) {
      for (auto& term : fixed.terms) {
        term.second = -term.second;
      }
    }
    fixed_[fixed.dof] = 1;
    rows_.push_back(fixed);
  }
}

template <int Dim>
void Constraints<Dim>::requireAgreement(Mesh<Dim> const& mesh, int node, int condition,
                                        Terms const& terms,
                                        std::vector<double> const& sample_times) const
{
  auto const& x = mesh.vertices[node];
  for (double t : sample_times) {
    double difference = 0;
    double magnitude = 0;
    for (auto const& [other, coefficient] : terms) {
      const double share = coefficient * velocity(other, x, t);
      difference += share;
      magnitude += std::abs(share);
    }
    const int first = terms.size() > 1 ? terms[1].first : condition;
    ASPERITY_REQUIRE(std::abs(difference) <= 1e-10 * magnitude,
                     conditions_[condition].name
                       << " (boundary '" << conditions_[condition].boundary << "') contradicts "
                       << conditions_[first].name << " (boundary '" << conditions_[first].boundary
                       << "') at x = (" << x[0] << ", " << x[1] << "), t = " << t
                       << " s: both prescribe the velocity in the same direction, and the values "
                          "differ by "
                       << difference << " m/s. Remove one of them.");
  }
}

template <int Dim>
double Constraints<Dim>::velocity(int condition, Point<Dim> const& x, double t) const
{
  auto const& function = conditions_[condition].velocity;
  return function ? function(x, t) : 0.;
}

template <int Dim>
void Constraints<Dim>::prescribedVelocity(double t, Vector& v) const
{
  v.putScalar(0);
  auto values = v.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (auto const& row : rows_) {
    double sum = 0;
    for (auto const& [condition, coefficient] : row.terms) {
      sum += coefficient * velocity(condition, owned_vertices_[row.node], t);
    }
    values(row.dof, 0) = sum;
  }
}

template <int Dim>
void Constraints<Dim>::shareWithGhosts(DofMap const& dofs)
{
  const int components = dofs.components();
  // One column a frame column, and one more for the flag.
  MultiVector owned(dofs.owned(), components + 1);
  MultiVector local(dofs.overlap(), components + 1);
  {
    auto values = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int node = 0; node < dofs.numOwnedNodes(); ++node) {
      for (int r = 0; r < components; ++r) {
        for (int c = 0; c < components; ++c) {
          values(dofs.dof(node, r), c) = frames_.entry(node, r, c);
        }
        values(dofs.dof(node, r), components) = fixed_[dofs.dof(node, r)];
      }
    }
  }
  local.doImport(owned, *dofs.ghostImport(), Tpetra::INSERT);
  auto const values = local.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int node = dofs.numOwnedNodes(); node < dofs.numLocalNodes(); ++node) {
    NodalFrames::Matrix frame{};
    for (int r = 0; r < components; ++r) {
      for (int c = 0; c < components; ++c) {
        frame[r * components + c] = values(dofs.dof(node, r), c);
      }
      fixed_[dofs.dof(node, r)] = values(dofs.dof(node, r), components) != 0;
    }
    frames_.set(node, frame);
  }
}

template class Constraints<2>;
template class Constraints<3>;
} // namespace asperity::fem
