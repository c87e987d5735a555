#include "surfaces/Contours.hpp"

#include "surfaces/files/TextFile.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity::geometry
{
namespace
{
bool isNumber(std::string_view word) { return readNumber(std::string(word)).has_value(); }

class ContourReader
{
public:
  explicit ContourReader(std::string const& file_name) : file_(file_name, "Contours file", '#') {}

  std::vector<Polyline> run()
  {
    while (file_.next()) {
      if (file_.followsBlank()) {
        finish();
      }
      readLine();
    }
    finish();
    ASPERITY_REQUIRE(!contours_.empty(), file_.where() << " has no contour.");
    setSign();
    return std::move(contours_);
  }

private:
  void readLine()
  {
    const std::size_t num_words = file_.words().size();
    if (!isNumber(file_.word(0))) { // END, "> -Z20"
      finish();
      level_ = levelIn();
      return;
    }
    if (num_words == 1) {
      finish();
      level_ = file_.number(0);
      return;
    }
    if (num_words == 2 && !level_) {
      file_.fail("'x y z' is expected, or a line with the depth alone before lines 'x y'.");
    }
    const SpacePoint point = {file_.number(0), file_.number(1),
                              num_words > 2 ? file_.number(2) : *level_};
    if (!contour_.empty() && contour_.back()[2] != point[2]) {
      finish();
    }
    if (contour_.empty() || contour_.back() != point) {
      contour_.push_back(point);
    }
  }

  // Of GMT's "> -Z20".
  std::optional<double> levelIn() const
  {
    for (auto const& word : file_.words()) {
      if (word.substr(0, 2) == "-Z") {
        return readNumber(std::string(word.substr(2)));
      }
    }
    return std::nullopt;
  }

  void finish()
  {
    if (!contour_.empty()) {
      if (contour_.size() < 2) {
        file_.fail("the contour that ends before this line has one point only, at z = " +
                   formatShort(contour_.front()[2]) + ". Is each point at a depth of its own?");
      }
      contours_.push_back(std::move(contour_));
      contour_.clear();
    }
  }

  void setSign()
  {
    bool has_positive = false, has_negative = false;
    for (auto const& contour : contours_) {
      has_positive = has_positive || contour.front()[2] > 0;
      has_negative = has_negative || contour.front()[2] < 0;
    }
    ASPERITY_REQUIRE(!has_positive || !has_negative,
                     file_.where() << " has positive and negative depths. Write depths below zero "
                                      "with one sign, and leave out contours above.");
    if (has_positive) {
      for (auto& contour : contours_) {
        for (auto& point : contour) {
          point[2] = -point[2];
        }
      }
    }
  }

  TextFile file_;
  std::vector<Polyline> contours_;
  Polyline contour_;
  std::optional<double> level_;
};

// The chain with the nearest of the pieces at one of its ends; the gap [m].
double append(Polyline& chain, std::vector<Polyline>& pieces)
{
  std::size_t nearest = 0;
  double smallest = std::numeric_limits<double>::infinity();
  bool at_front = false, turned = false;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const bool front : {false, true}) {
      for (const bool turn : {false, true}) {
        auto const& end = front ? chain.front() : chain.back();
        auto const& begin = front == turn ? pieces[i].front() : pieces[i].back();
        if (distanceOf(end, begin) < smallest) {
          smallest = distanceOf(end, begin);
          nearest = i;
          at_front = front;
          turned = turn;
        }
      }
    }
  }
  auto piece = std::move(pieces[nearest]);
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(nearest));
  if (turned) {
    std::reverse(piece.begin(), piece.end());
  }
  chain.insert(at_front ? chain.begin() : chain.end(), piece.begin(), piece.end());
  return smallest;
}

// One contour for each depth, the shallowest first.
std::vector<Polyline> joined(std::vector<Polyline>&& contours, std::string const& where,
                             RemarkSink const& remark)
{
  const auto z = [](Polyline const& contour) { return contour.front()[2]; };
  std::stable_sort(contours.begin(), contours.end(),
                   [&](auto const& a, auto const& b) { return z(a) > z(b); });
  std::vector<Polyline> result;
  for (std::size_t i = 0; i < contours.size();) {
    const double level = z(contours[i]);
    std::vector<Polyline> pieces;
    for (; i < contours.size() && z(contours[i]) == level; ++i) {
      pieces.push_back(std::move(contours[i]));
    }
    Polyline chain = std::move(pieces.front());
    pieces.erase(pieces.begin());
    const std::size_t more = pieces.size();
    double gap = 0;
    while (!pieces.empty()) {
      gap = std::max(gap, append(chain, pieces));
    }
    if (more > 0) {
      remark(where + ": the contour at z = " + formatShort(level) + " m has " +
             std::to_string(more + 1) + " pieces, which are joined across up to " +
             formatShort(gap) + " m.");
    }
    ASPERITY_REQUIRE(chain.front() != chain.back(),
                     where << ": the contour at z = " << formatShort(level)
                           << " m is closed. Only contours with two ends can be connected.");
    result.push_back(std::move(chain));
  }
  return result;
}

double distanceBetween(Polyline const& a, Polyline const& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += distanceOf(a[i], b[i]);
  }
  return sum;
}

int numSegments(std::vector<Polyline> const& contours, double spacing)
{
  constexpr double most = 2000;
  double longest = 0, segments = 0;
  for (auto const& contour : contours) {
    longest = std::max(longest, lengthOf(contour));
    segments += static_cast<double>(contour.size() - 1);
  }
  const double wanted =
    spacing > 0 ? longest / spacing : segments / static_cast<double>(contours.size());
  return static_cast<int>(std::clamp(std::ceil(wanted), 2., most));
}

Polyline rowBetween(Polyline const& upper, Polyline const& lower, double z)
{
  const double share = (z - upper.front()[2]) / (lower.front()[2] - upper.front()[2]);
  Polyline row;
  for (std::size_t i = 0; i < upper.size(); ++i) {
    row.push_back(between(upper[i], lower[i], share));
    row.back()[2] = z;
  }
  return row;
}

void endAt(double z, std::vector<Polyline>& rows, std::string const& where)
{
  ASPERITY_REQUIRE(z < rows.front().front()[2] && z >= rows.back().front()[2],
                   where << ": the lower edge, z = " << formatShort(z)
                         << " m, is not among the contours, from z = "
                         << formatShort(rows.front().front()[2]) << " m down to "
                         << formatShort(rows.back().front()[2]) << " m.");
  while (rows[rows.size() - 2].front()[2] <= z) {
    rows.pop_back();
  }
  rows.back() = rowBetween(rows[rows.size() - 2], rows.back(), z);
}

// The way up dip for each metre of z, the mean over neighbours: single contours are rough.
std::vector<std::array<double, 2>> upDipSlopes(Polyline const& upper, Polyline const& lower)
{
  const int size = static_cast<int>(upper.size()), window = std::max(1, size / 10);
  const double rise = upper.front()[2] - lower.front()[2];
  std::vector<std::array<double, 2>> slopes;
  for (int i = 0; i < size; ++i) {
    auto& slope = slopes.emplace_back();
    const int first = std::max(0, i - window), last = std::min(size - 1, i + window);
    for (int k = first; k <= last; ++k) {
      for (std::size_t d = 0; d < 2; ++d) {
        const auto at = static_cast<std::size_t>(k);
        slope[d] += (upper[at][d] - lower[at][d]) / rise / (last - first + 1);
      }
    }
  }
  return slopes;
}

void extendTo(double z, std::vector<Polyline>& rows, std::string const& where)
{
  const double rise = z - rows.front().front()[2];
  if (rise <= 0) {
    return;
  }
  const auto slopes = upDipSlopes(rows[0], rows[1]);
  Polyline row = rows.front();
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = {row[i][0] + rise * slopes[i][0], row[i][1] + rise * slopes[i][1], z};
  }
  ASPERITY_REQUIRE(foldedSegment(rows.front(), row) < 0,
                   where << ": the surface cannot go on up dip from z = "
                         << formatShort(rows.front().front()[2]) << " m to z = " << formatShort(z)
                         << " m: it is folded there. Set Extend Up to false, or add a shallower "
                            "contour.");
  rows.insert(rows.begin(), std::move(row));
}
} // namespace

std::vector<Polyline> readContours(std::string const& file_name)
{
  return ContourReader(file_name).run();
}

TriangleSurface contourSurface(std::vector<Polyline> contours, ContourOptions const& options,
                               std::string const& where, RemarkSink const& remark)
{
  const auto sorted = joined(std::move(contours), where, remark);
  ASPERITY_REQUIRE(sorted.size() >= 2, where << " has contours of " << sorted.size()
                                             << " depth; two or more are needed.");
  const int num_segments = numSegments(sorted, options.spacing);
  std::vector<Polyline> rows;
  for (auto const& contour : sorted) {
    auto row = resampled(contour, num_segments);
    if (!rows.empty()) {
      const Polyline turned(row.rbegin(), row.rend());
      if (distanceBetween(rows.back(), turned) < distanceBetween(rows.back(), row)) {
        row = turned;
      }
    }
    rows.push_back(std::move(row));
  }
  if (options.lower_z) {
    endAt(*options.lower_z, rows, where);
  }
  if (options.upper_z) {
    extendTo(*options.upper_z, rows, where);
  }
  return lofted(rows);
}
} // namespace asperity::geometry
