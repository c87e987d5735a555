#include "formats/VtkPieces.hpp"

#include "Warnings.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <array>
#include <cstdint>
#include <iostream>
#include <map>
#include <set>

namespace asperity::geometry
{
namespace
{
using Place = std::array<double, 3>;

std::string text(Place const& place)
{
  return "(" + formatNumber(place[0]) + ", " + formatNumber(place[1]) + ", " +
         formatNumber(place[2]) + ")";
}

// Whether each cell is a copy of another piece's.
std::vector<bool> ghosts(VtkGrid const& piece)
{
  std::vector<bool> result(piece.types.size(), false);
  for (auto const* name : {"vtkGhostType", "vtkGhostLevels"}) {
    const auto found = piece.cell_data.find(name);
    if (found != piece.cell_data.end() && found->second.size() == result.size()) {
      for (std::size_t cell = 0; cell < result.size(); ++cell) {
        result[cell] = result[cell] || found->second[cell] != 0;
      }
    }
  }
  return result;
}

class Joining
{
public:
  explicit Joining(std::string const& where) : where_(where) {}

  void add(VtkGrid const& piece)
  {
    requireCounts(piece, where_);
    const auto numbers = joinPoints(piece);
    const auto is_ghost = ghosts(piece);
    keepCellData(piece);
    for (std::size_t cell = 0; cell < piece.types.size(); ++cell) {
      if (!is_ghost[cell]) {
        addCell(piece, cell, numbers);
      }
    }
    ++num_pieces_;
  }

  VtkGrid finished()
  {
    if (num_shared_ == 0) {
      warn(where_ + ": no two of its " + std::to_string(num_pieces_) +
           " pieces have a point in common. The body is in pieces, too.");
    } else {
      std::cout << num_pieces_ << " pieces are put together at " << num_shared_
                << " points that they share\n";
    }
    return std::move(grid_);
  }

private:
  // The number that each point of the piece has in the whole grid.
  std::vector<std::int64_t> joinPoints(VtkGrid const& piece)
  {
    std::map<Place, std::int64_t> of_piece;
    std::vector<std::int64_t> numbers;
    for (std::size_t i = 0; i + 2 < piece.points.size(); i += 3) {
      constexpr double zero = 0; // -0 + 0 is 0: both zeros are one place
      const Place place = {piece.points[i] + zero, piece.points[i + 1] + zero,
                           piece.points[i + 2] + zero};
      const auto known = point_at_.find(place);
      const bool is_shared = known != point_at_.end();
      const auto number =
        is_shared ? known->second : static_cast<std::int64_t>(grid_.points.size() / 3);
      const bool is_single = of_piece.emplace(place, number).second;
      ASPERITY_REQUIRE(!is_shared || (is_single && repeated_.count(place) == 0),
                       where_ << ": one of the pieces has several points at " << text(place)
                              << ", and another piece has one there, too. Which of them are to be "
                                 "one is unknown. Save the mesh as one piece.");
      if (!is_single) {
        repeated_.insert(place);
      }
      if (is_shared) {
        ++num_shared_;
      } else {
        grid_.points.insert(grid_.points.end(), place.begin(), place.end());
      }
      numbers.push_back(number);
    }
    point_at_.merge(of_piece);
    return numbers;
  }

  // Before the cells are added.
  void keepCellData(VtkGrid const& piece)
  {
    if (num_pieces_ == 0) {
      for (auto const& [name, values] : piece.cell_data) {
        grid_.cell_data[name];
      }
    }
    for (auto kept = grid_.cell_data.begin(); kept != grid_.cell_data.end();) {
      const auto found = piece.cell_data.find(kept->first);
      const bool has = found != piece.cell_data.end() && found->second.size() == piece.types.size();
      kept = has ? std::next(kept) : grid_.cell_data.erase(kept);
    }
  }

  void addCell(VtkGrid const& piece, std::size_t cell, std::vector<std::int64_t> const& numbers)
  {
    const auto count = static_cast<std::int64_t>(numbers.size());
    for (auto i = cell == 0 ? 0 : piece.offsets[cell - 1]; i < piece.offsets[cell]; ++i) {
      const auto point = piece.connectivity[static_cast<std::size_t>(i)];
      ASPERITY_REQUIRE(point >= 0 && point < count,
                       where_ << ": cell " << cell << " of piece " << num_pieces_ + 1
                              << " has point " << point << ", outside [0, " << count << ").");
      grid_.connectivity.push_back(numbers[static_cast<std::size_t>(point)]);
    }
    grid_.offsets.push_back(static_cast<std::int64_t>(grid_.connectivity.size()));
    grid_.types.push_back(piece.types[cell]);
    for (auto& [name, values] : grid_.cell_data) {
      values.push_back(piece.cell_data.at(name)[cell]);
    }
  }

  std::string const& where_;
  VtkGrid grid_;
  int num_pieces_ = 0;
  std::map<Place, std::int64_t> point_at_; // of the pieces so far
  std::set<Place> repeated_;               // where one piece has several points
  std::int64_t num_shared_ = 0;
};
} // namespace

VtkGrid joined(std::vector<VtkGrid> pieces, std::string const& where)
{
  if (pieces.size() == 1) {
    return std::move(pieces.front());
  }
  Joining joining(where);
  for (auto const& piece : pieces) {
    joining.add(piece);
  }
  return joining.finished();
}
} // namespace asperity::geometry
