#include "fem/inelastic/CellStrains.hpp"

#include "base/Errors.hpp"
#include "fem/detail/CellViews.hpp"

#include <Tpetra_Vector.hpp>

namespace asperity::fem
{
namespace
{
using Values = Kokkos::View<const double*, MemorySpace>;

template <int Dim, int Components>
struct StrainKernel
{
  detail::CellViews<Dim> mesh;
  IndexView cells;
  Values x;
  TensorView result;

  KOKKOS_FUNCTION void operator()(int i) const
  {
    const int cell = cells(i);
    Gradient<Dim, Components> gradient;
    for (int corner = 0; corner <= Dim; ++corner) {
      const int vertex = mesh.vertices(cell, corner);
      for (int t = mesh.terms_begin(vertex); t < mesh.terms_begin(vertex + 1); ++t) {
        const int node = mesh.terms(t).node;
        for (int a = 0; a < Components; ++a) {
          double along_axis = 0;
          for (int c = 0; c < Components; ++c) {
            along_axis += mesh.frames(node, c, a) * x(node * Components + c);
          }
          for (int k = 0; k < Dim; ++k) {
            gradient.entry[a][k] +=
              mesh.terms(t).factor * along_axis * mesh.gradients(cell, corner, k);
          }
        }
      }
    }
    double tensor[numTensorComponents(Components)] = {};
    gradient.strain(tensor);
    for (int k = 0; k < numTensorComponents(Components); ++k) {
      result(i, k) = tensor[k];
    }
  }
};

// Marks the nodes on which a cell's inelastic strain may act.
template <int Dim>
struct TouchKernel
{
  detail::CellViews<Dim> mesh;
  IndexView cells;
  ConstTensorView e;
  Kokkos::View<int*, MemorySpace> touched; // (num_nodes)

  KOKKOS_FUNCTION void operator()(int i) const
  {
    if (isZero(e, i)) { // most of the rock does not yield
      return;
    }
    for (int corner = 0; corner <= Dim; ++corner) {
      const int vertex = mesh.vertices(cells(i), corner);
      for (int t = mesh.terms_begin(vertex); t < mesh.terms_begin(vertex + 1); ++t) {
        Kokkos::atomic_exchange(&touched(mesh.terms(t).node), 1);
      }
    }
  }
};

template <int Dim, int Components>
struct ForceKernel
{
  detail::CellViews<Dim> mesh;
  IndexView touched;
  IndexView places; // (num cells of the mesh): the row of the cell, or -1
  ConstTensorView e;
  NodeView force;

  // Entry (a, k) of the tensor in a row.
  KOKKOS_FUNCTION double entry(int row, int a, int k) const
  {
    if constexpr (Components == 1) {
      return e(row, k);
    } else {
      return e(row, a < k ? placeOf<Dim>(a, k) : placeOf<Dim>(k, a));
    }
  }

  KOKKOS_FUNCTION void operator()(int node) const
  {
    if (touched(node) == 0) {
      return;
    }
    double along_axes[Components] = {};
    for (int c = mesh.corners_begin(node); c < mesh.corners_begin(node + 1); ++c) {
      auto const& corner = mesh.corners(c);
      const int row = places(corner.cell);
      if (row < 0) {
        continue;
      }
      auto const& material = mesh.materials(corner.cell);
      const double weight = corner.factor * mesh.measure(corner.cell);
      const double factor = 2 * material.shear_modulus * weight;
      const double of_volume =
        (material.bulk_modulus - 2. / 3 * material.shear_modulus) * weight * traceOf(e, row);
      for (int a = 0; a < Components; ++a) {
        for (int k = 0; k < Dim; ++k) {
          along_axes[a] +=
            factor * entry(row, a, k) * mesh.gradients(corner.cell, corner.corner, k);
        }
        if constexpr (Components == Dim) {
          along_axes[a] += of_volume * mesh.gradients(corner.cell, corner.corner, a);
        }
      }
    }
    for (int c = 0; c < Components; ++c) {
      for (int a = 0; a < Components; ++a) {
        force(node * Components + c) += mesh.frames(node, c, a) * along_axes[a];
      }
    }
  }
};

template <int Dim, int Components>
class CellStrainsOf final : public CellStrains
{
public:
  CellStrainsOf(Mesh<Dim> const& mesh, NodalFrames const& frames,
                std::vector<Material> const& materials, std::vector<int> const& cells)
      : mesh_(detail::makeCellViews(mesh, frames, materials))
      , cells_(toDevice(cells, "asperity::fem::yieldingCells"))
      , touched_("asperity::fem::touchedNodes", frames.numNodes())
      , num_owned_nodes_(mesh.num_owned)
  {
    std::vector<int> places(mesh.cells.size(), -1);
    std::vector<double> measures;
    auto const measure = toHost(mesh_.measure);
    for (std::size_t row = 0; row < cells.size(); ++row) {
      places[cells[row]] = static_cast<int>(row);
      measures.push_back(measure(cells[row]));
    }
    places_ = toDevice(places, "asperity::fem::placesOfYieldingCells");
    measures_ = toDevice(measures, "asperity::fem::measuresOfYieldingCells");
  }

  void strain(Vector const& x, TensorView const& strain) const override
  {
    auto const view = x.getLocalViewDevice(Tpetra::Access::ReadOnly);
    Kokkos::parallel_for(
      "asperity::fem::cellStrain", RangePolicy(0, cells_.extent_int(0)),
      StrainKernel<Dim, Components>{mesh_, cells_, Values(view.data(), view.extent(0)), strain});
  }

  void addForces(ConstTensorView const& e, Vector& f) const override
  {
    Kokkos::deep_copy(touched_, 0);
    Kokkos::parallel_for("asperity::fem::touchNodes", RangePolicy(0, cells_.extent_int(0)),
                         TouchKernel<Dim>{mesh_, cells_, e, touched_});
    auto const view = f.getLocalViewDevice(Tpetra::Access::ReadWrite);
    Kokkos::parallel_for("asperity::fem::forcesOfCells", RangePolicy(0, num_owned_nodes_),
                         ForceKernel<Dim, Components>{mesh_, touched_, places_, e,
                                                      NodeView(view.data(), view.extent(0))});
  }

  ConstNodeView measures() const override { return measures_; }

private:
  detail::CellViews<Dim> mesh_;
  IndexView cells_, places_;
  Kokkos::View<int*, MemorySpace> touched_; // (num_nodes)
  ConstNodeView measures_;
  int num_owned_nodes_;
};
} // namespace

template <int Dim>
std::unique_ptr<CellStrains> makeCellStrains(Mesh<Dim> const& mesh, NodalFrames const& frames,
                                             std::vector<Material> const& materials,
                                             std::vector<int> const& cells)
{
  if (frames.components() == Dim) {
    return std::make_unique<CellStrainsOf<Dim, Dim>>(mesh, frames, materials, cells);
  }
  ASPERITY_ASSERT(Dim == 2 && frames.components() == 1);
  if constexpr (Dim == 2) {
    return std::make_unique<CellStrainsOf<2, 1>>(mesh, frames, materials, cells);
  }
  return {};
}

template std::unique_ptr<CellStrains> makeCellStrains(Mesh<2> const&, NodalFrames const&,
                                                      std::vector<Material> const&,
                                                      std::vector<int> const&);
template std::unique_ptr<CellStrains> makeCellStrains(Mesh<3> const&, NodalFrames const&,
                                                      std::vector<Material> const&,
                                                      std::vector<int> const&);
} // namespace asperity::fem
