#include "scenario/run/CarriedRock.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/Views.hpp"
#include "base/parallel/Agreement.hpp"
#include "catalogue/receivers/Interpolation.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "scenario/run/WholeBodyArchive.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace asperity::scenario
{
namespace
{
using Values = std::vector<double>;

// The variables by name, of equal order in both runs.
std::map<std::string, fem::HistoryColumns> columnsOf(fem::InelasticCells const& cells)
{
  std::map<std::string, fem::HistoryColumns> columns;
  for (auto const& each : cells.history()) {
    columns[each.variable.name] = each;
  }
  return columns;
}

// The columns of a row in which a cell's values travel: strain, shear, variables in the order of
// their names.
struct Width
{
  int strain, all;
};

// (num_owned_elements, width): zero in elements that do not yield.
template <int Dim>
Values valuesOfElements(Problem<Dim> const& problem, fem::InelasticStrain const& inelastic,
                        io::OutputDomain const& volume, Width const& width)
{
  auto const& cells = *problem.model.body.cells;
  auto const rows = cells.sharing().rowsOfMesh(problem.mesh().cells.size());
  auto const columns = columnsOf(cells);
  auto const strain = toHost(inelastic.strain), shear = toHost(inelastic.shear),
             history = toHost(inelastic.history);
  Values values;
  for (const int cell : volume.numbers_in_mesh) {
    const int row = rows[static_cast<std::size_t>(cell)];
    if (row < 0) {
      values.insert(values.end(), static_cast<std::size_t>(width.all), 0);
      continue;
    }
    for (int k = 0; k < width.strain; ++k) {
      values.push_back(strain(row, k));
    }
    values.push_back(shear(row, 0));
    for (auto const& [name, of_name] : columns) {
      for (int k = 0; k < of_name.width; ++k) {
        values.push_back(history(row, of_name.first + k));
      }
    }
  }
  return values;
}

// The centroids of all cells that this rank has.
template <int Dim>
Values centroids(Mesh<Dim> const& mesh)
{
  Values points;
  for (auto const& cell : mesh.cells) {
    auto const centre = mesh::centroid(mesh::corners(mesh, cell));
    points.insert(points.end(), centre.begin(), centre.end());
  }
  return points;
}

// values: (num_cells, width)
template <int Dim>
void refuseLostStrain(Problem<Dim> const& problem, Values const& values, Width const& width,
                      std::filesystem::path const& run)
{
  auto const rows = problem.model.body.cells->sharing().rowsOfMesh(problem.mesh().cells.size());
  onEveryRank(*problem.communicator, [&] {
    for (std::size_t cell = 0; cell < rows.size(); ++cell) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(cell) * width.all;
      const bool has_yielded =
        std::any_of(first, first + width.all, [](double value) { return value != 0; });
      if (rows[cell] < 0 && has_yielded) {
        auto const centre =
          mesh::centroid(mesh::corners(problem.mesh(), problem.mesh().cells[cell]));
        throw InputError("--restart-from " + run.string() + ": the rock at " +
                         formatPoint({centre.begin(), centre.end()}) +
                         " m has yielded there and cannot yield here (Asperity / Bulk / Law), so "
                         "that its stress would be another one. Let it yield here, too.");
      }
    }
  });
}
} // namespace

std::string internalVariables(dynamics::Body const& body)
{
  if (!body.cells) {
    return "none";
  }
  std::string text = "inelastic_strain, inelastic_shear";
  for (auto const& [name, columns] : columnsOf(*body.cells)) {
    text += ", " + name + " (" + std::to_string(columns.width) + ")";
  }
  return text;
}

template <int Dim>
void carryRock(Problem<Dim> const& other, dynamics::State const& state,
               io::OutputDomain const& from, Problem<Dim> const& problem,
               std::filesystem::path const& run, Archive& archive)
{
  const int of_strain = state.inelastic->strain.extent_int(1);
  const Width width{of_strain, of_strain + 1 + state.inelastic->history.extent_int(1)};
  const catalogue::Interpolation in_cells(from, centroids(problem.mesh()), run.string());
  auto const there = valuesOfElements(other, *state.inelastic, from, width);
  auto const values = in_cells({there}, width.all, io::Centring::elements).front();
  refuseLostStrain(problem, values, width, run);
  auto const& cells = *problem.model.body.cells;
  auto const columns = columnsOf(cells);
  const auto num_owned = static_cast<std::size_t>(cells.sharing().numOwned());
  const int of_history = width.all - of_strain - 1;
  Values strain, shear, history(num_owned * static_cast<std::size_t>(of_history));
  for (std::size_t row = 0; row < num_owned; ++row) {
    auto from_cell =
      values.begin() + static_cast<std::ptrdiff_t>(cells.sharing().cells()[row]) * width.all;
    strain.insert(strain.end(), from_cell, from_cell + of_strain);
    shear.push_back(from_cell[of_strain]);
    from_cell += of_strain + 1;
    for (auto const& [name, of_name] : columns) {
      std::copy_n(from_cell, of_name.width,
                  history.begin() + static_cast<std::ptrdiff_t>(row) * of_history + of_name.first);
      from_cell += of_name.width;
    }
  }
  const std::map<std::string, Values const*> fields{
    {"inelastic_strain", &strain}, {"inelastic_shear", &shear}, {"inelastic_history", &history}};
  dynamics::State::visitCells(
    [&](dynamics::FieldInfo const& info, fem::TensorView const&) {
      archive.set("state/" + info.name, *fields.at(info.name));
    },
    problem.model.initial);
}

template void carryRock(Problem<2> const&, dynamics::State const&, io::OutputDomain const&,
                        Problem<2> const&, std::filesystem::path const&, Archive&);
template void carryRock(Problem<3> const&, dynamics::State const&, io::OutputDomain const&,
                        Problem<3> const&, std::filesystem::path const&, Archive&);
} // namespace asperity::scenario
