#pragma once

#include "base/Types.hpp"
#include "fem/bulk/BulkLaw.hpp"
#include "fem/bulk/Material.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "fem/dofs/DofMap.hpp"
#include "fem/inelastic/CellSharing.hpp"
#include "fem/inelastic/CellStrains.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::fem
{
// What the laws of cells say that yield; cells by their local numbers in the mesh.
struct YieldingRock
{
  struct Part // the cells of one law
  {
    BulkLaw law;
    std::vector<int> cells;
    std::vector<double> parameters; // (cells, parameters of the law)
  };
  std::vector<Part> parts;
  std::vector<double> initial_stress; // (num cells of the mesh, tensor components) [Pa]
  std::vector<double> initial_mean;   // (num cells of the mesh) [Pa], positive in tension
};

// The cells of a body that may yield. Strain is constant in a cell, and so is the inelastic strain
// e, whose stress -C e, with the stiffness C = 2 G e + (K - 2/3 G) tr e, adds to that of the whole
// strain. Each rank has all cells of its vertices.
class InelasticCells
{
public:
  // A rank may have no such cells. Collective.
  template <int Dim>
  InelasticCells(Mesh<Dim> const& mesh, std::shared_ptr<const DofMap> dofs,
                 NodalFrames const& frames, std::vector<Material> const& materials,
                 YieldingRock const& rock);

  CellSharing const& sharing() const { return sharing_; }
  int numCells() const { return static_cast<int>(sharing_.cells().size()); }
  int vertexOf(int row) const { return vertices_[row]; } // a local vertex of the cell
  InelasticStrain none() const;                          // zero
  // The columns of InelasticStrain::history.
  std::vector<HistoryColumns> const& history() const { return history_; }

  // Sets `after` to the inelastic strain at the end of a step [s] that begins with `before` and
  // ends with the displacement u. Collective.
  void respond(Vector const& u, double step, InelasticStrain const& before,
               InelasticStrain const& after) const;
  // f += the forces of e: the integral of C e : strain of the basis functions [N].
  void addForces(ConstTensorView const& e, Vector& f) const { strains_->addForces(e, f); }
  // The integral of C e : e / 2 - initial stress : e over all cells [J], the elastic energy of e
  // where the whole strain is zero. Collective.
  double energy(ConstTensorView const& e) const;

  // How much the stresses of e and of `other` differ, as a share of this and the trial's shear
  // stress in the last response: of roots of integrals, or of maxima. Collective.
  double distance(ConstTensorView const& e, ConstTensorView const& other, bool as_maximum) const;
  // (num_cells tensor components): the weight of each entry of e in the integral of (2 G)^2 e : e
  // over the cells that this rank owns, and 0 in the others.
  ConstNodeView weights() const { return weights_; }

  // The cell of the mesh, among those of this rank, whose shear stress t at the displacement u is
  // furthest above the t1 that it keeps for long; none if all of them bear theirs. Collective.
  struct Excess
  {
    int cell;
    double shear_stress, kept; // t and t1 [Pa]
  };
  std::optional<Excess> largestExcess(Vector const& u) const;

private:
  struct Part
  {
    YieldKernel yield;
    IndexView cells; // rows
    int column;      // of the law's history, the first one
  };

  ConstTensorView strainOf(Vector const& u) const;
  void yield(ConstTensorView const& strain, double step, InelasticStrain const& before,
             InelasticStrain const& after) const;

  CellSharing sharing_;
  std::shared_ptr<const DofMap> dofs_;
  int num_components_;        // of a tensor
  std::vector<int> vertices_; // (num_cells)
  std::unique_ptr<const CellStrains> strains_;
  int columnOf(BulkLaw const& law, std::map<std::string, int>& columns);

  std::vector<Part> parts_;
  std::vector<HistoryColumns> history_;
  int history_width_ = 0;
  ConstNodeView shear_modulus_, bulk_modulus_, initial_mean_, weights_;
  ConstNodeView own_measure_; // 0 in cells that another rank owns
  ConstTensorView initial_stress_;
  TensorView strain_;     // the whole one, in the last response
  NodeView shear_stress_; // t of the trial there
  RCP<Vector> u_;         // with ghosts
};
} // namespace asperity::fem
