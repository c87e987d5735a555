#include "fem/inelastic/InelasticCells.hpp"

#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace asperity::fem
{
namespace
{
std::vector<int> cellsOf(YieldingRock const& rock)
{
  std::vector<int> cells;
  for (auto const& part : rock.parts) {
    cells.insert(cells.end(), part.cells.begin(), part.cells.end());
  }
  return cells;
}

// values(num_rows, width)
TensorView table(std::vector<double> const& values, std::size_t num_rows, std::size_t width,
                 std::string const& label)
{
  const TensorView view(label, num_rows, width);
  auto const host = Kokkos::create_mirror_view(view);
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

// What the kernels of a sum know of the cells.
struct Moduli
{
  ConstNodeView shear, bulk; // [Pa]; bulk is 0 antiplane

  KOKKOS_FUNCTION double firstLame(int cell) const { return bulk(cell) - 2. / 3 * shear(cell); }
};

// s : s / 2 of the stress s = C (e - other) in a cell.
KOKKOS_FUNCTION double squareOfChange(int cell, Moduli const& moduli, ConstTensorView const& e,
                                      ConstTensorView const& other)
{
  if (areEqual(e, other, cell)) { // as in most cells
    return 0;
  }
  const double of_volume = moduli.firstLame(cell) * (traceOf(e, cell) - traceOf(other, cell));
  double square = 0;
  const int size = e.extent_int(1);
  for (int k = 0; k < size; ++k) {
    const double stress = 2 * moduli.shear(cell) * (e(cell, k) - other(cell, k)) +
                          (isOnDiagonal(size, k) ? of_volume : 0);
    square += multiplicity(size, k) * stress * stress / 2;
  }
  return square;
}

// C e : e / 2 - initial stress : e, per volume.
KOKKOS_FUNCTION double energyIn(int cell, Moduli const& moduli,
                                ConstTensorView const& initial_stress, ConstTensorView const& e)
{
  if (isZero(e, cell)) {
    return 0;
  }
  const double trace = traceOf(e, cell);
  double energy = moduli.firstLame(cell) / 2 * trace * trace;
  const int size = e.extent_int(1);
  for (int k = 0; k < size; ++k) {
    energy += multiplicity(size, k) * (moduli.shear(cell) * e(cell, k) - initial_stress(cell, k)) *
              e(cell, k);
  }
  return energy;
}
} // namespace

template <int Dim>
InelasticCells::InelasticCells(Mesh<Dim> const& mesh, std::shared_ptr<const DofMap> dofs,
                               NodalFrames const& frames, std::vector<Material> const& materials,
                               YieldingRock const& rock)
    : sharing_(mesh, cellsOf(rock), dofs->communicator())
    , dofs_(std::move(dofs))
    , num_components_(numTensorComponents(dofs_->components()))
    , strains_(makeCellStrains(mesh, frames, materials, sharing_.cells()))
    , strain_("asperity::fem::strain", sharing_.cells().size(), num_components_)
    , shear_stress_("asperity::fem::shearStress", sharing_.cells().size())
    , u_(rcp(new Vector(dofs_->overlap())))
{
  auto const& cells = sharing_.cells();
  std::vector<int> row_of(mesh.cells.size(), -1);
  std::vector<double> shear_modulus, bulk_modulus, mean, stress, weights, measures;
  auto const measure = toHost(strains_->measures());
  for (std::size_t row = 0; row < cells.size(); ++row) {
    const int cell = cells[row];
    auto const& material = materials[cell];
    row_of[cell] = static_cast<int>(row);
    vertices_.push_back(mesh.cells[cell].front());
    shear_modulus.push_back(material.shear_modulus);
    bulk_modulus.push_back(dofs_->components() > 1 ? material.bulk_modulus : 0);
    mean.push_back(rock.initial_mean[cell]);
    const bool is_owned = static_cast<int>(row) < sharing_.numOwned();
    measures.push_back(is_owned ? measure(row) : 0);
    for (int k = 0; k < num_components_; ++k) {
      stress.push_back(rock.initial_stress[cell * num_components_ + k]);
      weights.push_back(measures.back() * multiplicity(num_components_, k) * 4 *
                        material.shear_modulus * material.shear_modulus);
    }
  }
  shear_modulus_ = toDevice(shear_modulus, "asperity::fem::shearModulus");
  bulk_modulus_ = toDevice(bulk_modulus, "asperity::fem::bulkModulus");
  initial_mean_ = toDevice(mean, "asperity::fem::initialMeanStress");
  initial_stress_ = table(stress, cells.size(), num_components_, "asperity::fem::initialStress");
  weights_ = toDevice(weights, "asperity::fem::weightsOfCells");
  own_measure_ = toDevice(measures, "asperity::fem::ownMeasure");
  std::map<std::string, int> column_of_variable;
  for (auto const& part : rock.parts) {
    std::vector<int> of_part;
    for (const int cell : part.cells) {
      of_part.push_back(row_of[cell]);
    }
    auto const values = table(part.parameters, part.cells.size(), part.law.parameters.size(),
                              "asperity::fem::parametersOfLaw");
    parts_.push_back({part.law.make_kernel(values), toDevice(of_part, "asperity::fem::cellsOfLaw"),
                      columnOf(part.law, column_of_variable)});
  }
}

// The same law in several regions has its columns once.
int InelasticCells::columnOf(BulkLaw const& law, std::map<std::string, int>& columns)
{
  auto variables = law.history(num_components_);
  if (variables.empty()) {
    return 0;
  }
  auto const [found, is_new] = columns.emplace(variables.front().variable.name, history_width_);
  if (is_new) {
    for (auto& each : variables) {
      each.first = history_width_;
      history_width_ += each.width;
      history_.push_back(each);
    }
  }
  return found->second;
}

InelasticStrain InelasticCells::none() const
{
  return {TensorView("asperity::fem::inelasticStrain", numCells(), num_components_),
          TensorView("asperity::fem::inelasticShear", numCells(), 1),
          TensorView("asperity::fem::history", numCells(), history_width_)};
}

ConstTensorView InelasticCells::strainOf(Vector const& u) const
{
  dofs_->shareWithGhosts(u, *u_);
  strains_->strain(*u_, strain_);
  return strain_;
}

void InelasticCells::yield(ConstTensorView const& strain, double step,
                           InelasticStrain const& before, InelasticStrain const& after) const
{
  for (auto const& part : parts_) {
    part.yield({part.cells, shear_modulus_, bulk_modulus_, initial_stress_, initial_mean_, strain,
                before.strain, before.shear, before.history, part.column, step, after.strain,
                after.shear, after.history, shear_stress_});
  }
}

void InelasticCells::respond(Vector const& u, double step, InelasticStrain const& before,
                             InelasticStrain const& after) const
{
  ASPERITY_TIME_WORK("yielding rock");
  yield(strainOf(u), step, before, after);
}

double InelasticCells::energy(ConstTensorView const& e) const
{
  double mine = 0;
  auto const measure = own_measure_;
  const Moduli moduli{shear_modulus_, bulk_modulus_};
  auto const initial_stress = initial_stress_;
  Kokkos::parallel_reduce(
    "asperity::fem::energyOfCells", RangePolicy(0, numCells()),
    KOKKOS_LAMBDA(int cell, double& sum) {
      sum += measure(cell) * energyIn(cell, moduli, initial_stress, e);
    },
    mine);
  return sumOverRanks(mine, *sharing_.communicator());
}

double InelasticCells::distance(ConstTensorView const& e, ConstTensorView const& other,
                                bool as_maximum) const
{
  auto const measure = own_measure_;
  const Moduli moduli{shear_modulus_, bulk_modulus_};
  auto const shear_stress = ConstNodeView(shear_stress_);
  const RangePolicy cells(0, numCells());
  double change = 0, stress = 0; // squares
  if (as_maximum) {
    // A nan counts as an infinite change; a plain maximum would ignore it.
    Kokkos::parallel_reduce(
      "asperity::fem::largestInCells", cells,
      KOKKOS_LAMBDA(int cell, double& most, double& most_stress) {
        const double square = squareOfChange(cell, moduli, e, other);
        const double of_stress = shear_stress(cell) * shear_stress(cell);
        most = square <= most ? most : square >= 0 ? square : INFINITY;
        most_stress = of_stress > most_stress ? of_stress : most_stress;
      },
      Kokkos::Max<double>(change), Kokkos::Max<double>(stress));
  } else {
    Kokkos::parallel_reduce(
      "asperity::fem::sumsOverCells", cells,
      KOKKOS_LAMBDA(int cell, double& sum, double& sum_of_stress) {
        sum += measure(cell) * squareOfChange(cell, moduli, e, other);
        sum_of_stress += measure(cell) * shear_stress(cell) * shear_stress(cell);
      },
      change, stress);
  }
  auto const& comm = *sharing_.communicator();
  const std::array<double, 2> mine = {std::max(change, 0.), std::max(stress, 0.)};
  auto const [of_change, of_stress] =
    as_maximum ? maxOverRanks(mine, comm) : sumOverRanks(mine, comm);
  return of_change == 0 ? 0 : std::sqrt(of_change / (of_change + of_stress));
}

std::optional<InelasticCells::Excess> InelasticCells::largestExcess(Vector const& u) const
{
  auto const strain = strainOf(u);
  auto const before = none(), after = none();
  constexpr double for_long = std::numeric_limits<double>::infinity();
  yield(strain, for_long, before, after);
  auto const gamma = toHost(after.shear);
  auto const G = toHost(shear_modulus_), t = toHost(ConstNodeView(shear_stress_));
  std::optional<Excess> furthest;
  for (int row = 0; row < sharing_.numOwned(); ++row) {
    const double over = G(row) * gamma(row, 0);
    const double rounding = 1e-9 * t(row);
    if (over > rounding && (!furthest || over > furthest->shear_stress - furthest->kept)) {
      furthest = Excess{sharing_.cells()[row], t(row), t(row) - over};
    }
  }
  return furthest;
}

template InelasticCells::InelasticCells(Mesh<2> const&, std::shared_ptr<const DofMap>,
                                        NodalFrames const&, std::vector<Material> const&,
                                        YieldingRock const&);
template InelasticCells::InelasticCells(Mesh<3> const&, std::shared_ptr<const DofMap>,
                                        NodalFrames const&, std::vector<Material> const&,
                                        YieldingRock const&);
} // namespace asperity::fem
