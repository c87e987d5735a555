#pragma once

#include "base/Types.hpp"
#include "fem/VolumetricPatches.hpp"
#include "fem/bulk/Material.hpp"
#include "fem/bulk/MaxwellBranch.hpp"
#include "fem/constraints/HeldDofs.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "fem/dofs/DofMap.hpp"
#include "mesh/Mesh.hpp"

#include <vector>

namespace asperity::fem
{
// Consistent mass M [kg/m^(3-Dim)], viscosity C and stiffness K of P1 elements in nodal frames,
// without any boundary condition (Pipping 2014, eq. 14). Those of a mesh share one graph; in
// general the graph of stiffness holds those of mass and viscosity, and all three have its columns.
// Components is 1 (antiplane) or Dim. At a split vertex the unknowns are mean and jump
// (VertexTerms): with v = T x the matrices are T'MT, T'CT and T'KT.
struct BodyMatrices
{
  RCP<const CrsMatrix> mass;
  RCP<const CrsMatrix> viscosity;
  RCP<const CrsMatrix> stiffness; // of what never relaxes
  bool is_massless = false;       // whether mass is zero, so that products with it can be left out

  // A Maxwell branch: its relaxation time [s], and the stiffness K_k of its moduli.
  struct Branch
  {
    double time;
    RCP<const CrsMatrix> stiffness;
  };
  std::vector<Branch> branches = {};
};

// The matrices with the number of components of the dofs. materials(num_cells). With patches, whose
// cells share volumetric strains, the graph of the matrices couples the vertices of a patch; mass,
// viscosity and branches are those of single cells, and the stiffness of the patches never relaxes.
// Collective, but without communication, since every rank has all cells of its rows and of its
// patches.
template <int Dim>
BodyMatrices assembleBody(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
                          std::vector<Material> const& materials,
                          std::vector<MaxwellBranch> const& branches = {},
                          VolumetricPatches const& patches = {});

// The load of a body force density * acceleration, acceleration(Components) in m/s^2 along the
// axes.
template <int Dim, int Components>
RCP<Vector> assembleGravity(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
                            std::vector<Material> const& materials,
                            std::array<double, Components> const& acceleration);

// The same with the number of components of the dofs; zero antiplane.
template <int Dim>
RCP<Vector> assembleGravity(Mesh<Dim> const& mesh, DofMap const& dofs, NodalFrames const& frames,
                            std::vector<Material> const& materials,
                            std::array<double, Dim> const& acceleration);

// A weighted sum of the matrices of a body; branches(num_branches), or none.
struct Weights
{
  double mass = 0, viscosity = 0, stiffness = 0;
  std::vector<double> branches = {};
};
Weights massWeights();
Weights viscosityWeights();
Weights branchWeights(BodyMatrices const& body, std::size_t branch);
// K and the stiffness of all branches, which a body has against a sudden motion.
Weights elasticityWeights(BodyMatrices const& body);

// The sum, on the graph of stiffness; with `held`, the rows and columns of held dofs are replaced
// by their diagonal entry.
RCP<CrsMatrix> combine(BodyMatrices const& body, Weights const& weights);
RCP<CrsMatrix> combine(BodyMatrices const& body, Weights const& weights, HeldDofs const& held);
} // namespace asperity::fem
