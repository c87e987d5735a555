#include "dynamics/processes/Wells.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/PointText.hpp"
#include "parameters/fields/Field.hpp"

#include <Tpetra_Map.hpp>

#include <algorithm>

namespace asperity::dynamics
{
struct Wells::Well
{
  std::array<double, 3> place;
  Field rate;
  std::vector<std::pair<int, double>> shares; // of this rank's nodes
};

Teuchos::RCP<const Teuchos::ParameterList> Wells::validParameters()
{
  auto const well =
    Declare()
      .realArray("Place", required, "m", Range::any(),
                 "The well lies at this place on the fault, in coordinates of the mesh.")
      .field("Rate", required, "m^3/s", Range::any(),
             "This volume flows into the fault per time, out of it if negative; a number or an "
             "expression in t. In two dimensions it is that per metre of thickness [m^2/s].")
      .withoutDatasets()
      .list();
  return Declare().sublist("<well>", well, "This list describes the well of that name.").list();
}

namespace
{
constexpr double reach = 0.01;    // from the fault, as a share of the cell's size; as for receivers
constexpr double rounding = 1e-9; // of shares that sum to one

std::array<double, 3> placeOf(Teuchos::ParameterList const& well, std::string const& path,
                              int dimension)
{
  auto const given = well.get<Teuchos::Array<double>>("Place");
  ASPERITY_REQUIRE(given.size() == dimension, joinPath(path, "Place")
                                                << " has " << given.size()
                                                << " numbers, but the mesh has " << dimension
                                                << " dimensions.");
  std::array<double, 3> place{};
  std::copy(given.begin(), given.end(), place.begin());
  return place;
}

Field rateOf(Teuchos::ParameterList const& well, std::string const& path)
{
  Field rate(well, "Rate", path, {});
  ASPERITY_REQUIRE(!rate.isDataset(), joinPath(path, "Rate")
                                        << " names a dataset, but a well has one place. Give a "
                                           "number or an expression in t.");
  return rate;
}

std::string textOf(std::array<double, 3> const& place, int dimension)
{
  return dimension == 2 ? mesh::text(std::array<double, 2>{place[0], place[1]}) : mesh::text(place);
}

// Over all ranks, of those that take a part of the rate that is more than rounding.
int numNodesThatShare(fem::FaultMesh::Nearest const& nearest, Communicator const& communicator)
{
  const auto mine =
    std::count_if(nearest.shares.begin(), nearest.shares.end(),
                  [](auto const& node_and_share) { return node_and_share.second > rounding; });
  return static_cast<int>(sumOverRanks(static_cast<double>(mine), communicator));
}

std::string remarkOn(std::string const& name, std::string const& place, double cell_size,
                     int num_nodes)
{
  return "Well '" + name + "' meets the fault at " + place + " m, where cells have a size of " +
         formatShort(cell_size) + " m: " +
         (num_nodes == 1 ? "one node takes its rate."
                         : std::to_string(num_nodes) + " nodes of a cell share its rate.");
}
} // namespace

Wells::Wells(Teuchos::ParameterList const& list, std::string const& path,
             fem::FaultMesh const& mesh)
{
  const int dimension = mesh.numCorners();
  for (auto const& entry : list) {
    auto const& name = entry.first;
    auto const& well = list.sublist(name);
    auto const where = joinPath(path, name);
    auto const place = placeOf(well, where, dimension);
    auto rate = rateOf(well, where);
    auto nearest = mesh.nearest(place);
    ASPERITY_REQUIRE(nearest.distance <= reach * nearest.cell_size,
                     where << " is at " << textOf(place, dimension) << ", " << nearest.distance
                           << " m from the fault, whose cells have a size of " << nearest.cell_size
                           << " m there; at most " << reach
                           << " of that is allowed. Move the well onto the fault.");
    remarks_.push_back(remarkOn(name, textOf(place, dimension), nearest.cell_size,
                                numNodesThatShare(nearest, *mesh.owned()->getComm())));
    wells_.push_back(
      std::make_unique<Well>(Well{place, std::move(rate), std::move(nearest.shares)}));
  }
}

Wells::~Wells() = default;

bool Wells::dependOnTime() const
{
  return std::any_of(wells_.begin(), wells_.end(),
                     [](auto const& well) { return well->rate.dependsOnTime(); });
}

void Wells::add(double t, std::vector<double>& rates) const
{
  for (auto const& well : wells_) {
    const double rate = well->rate(well->place, t, 0);
    for (auto const& [node, share] : well->shares) {
      rates[node] += share * rate;
    }
  }
}
} // namespace asperity::dynamics
