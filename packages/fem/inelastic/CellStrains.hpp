#pragma once

#include "base/Types.hpp"
#include "fem/bulk/Material.hpp"
#include "fem/bulk/ReturnMapping.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "mesh/Mesh.hpp"

#include <memory>
#include <vector>

namespace asperity::fem
{
// Strain in some cells of a rank, and the forces of stress in them.
class CellStrains
{
public:
  virtual ~CellStrains() = default;
  // strain(num_cells, tensor components) of a displacement x(owned and ghost dofs) in nodal frames.
  virtual void strain(Vector const& x, TensorView const& strain) const = 0;
  // f(owned dofs) += the integral of C e : strain of the basis functions, with the stiffness C of
  // the cells and e(num_cells, tensor components).
  virtual void addForces(ConstTensorView const& e, Vector& f) const = 0;
  virtual ConstNodeView measures() const = 0; // (num_cells) m^Dim
};

// cells: local; materials(num cells of the mesh).
template <int Dim>
std::unique_ptr<CellStrains> makeCellStrains(Mesh<Dim> const& mesh, NodalFrames const& frames,
                                             std::vector<Material> const& materials,
                                             std::vector<int> const& cells);
} // namespace asperity::fem
