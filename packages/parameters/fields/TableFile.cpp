#include "parameters/fields/TableFile.hpp"

#include "base/Errors.hpp"
#include "base/Hashes.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "parameters/fields/MissingFile.hpp"
#include "parameters/fields/Unit.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace asperity
{
namespace
{
// The whole file, which begins without a byte order mark.
std::string contentOf(std::string const& file_name, std::string const& path)
{
  std::error_code ignored;
  ASPERITY_REQUIRE(std::filesystem::exists(file_name, ignored), path << " = '" << file_name
                                                                     << "': there is no such file. "
                                                                     << whereNot(file_name));
  std::ifstream file(file_name, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  ASPERITY_REQUIRE(!std::filesystem::is_directory(file_name, ignored) && file.is_open() &&
                     !file.bad(),
                   path << " = '" << file_name << "' cannot be read as a file.");
  const std::string mark = "\xef\xbb\xbf";
  const std::string text = content.str();
  return text.compare(0, mark.size(), mark) == 0 ? text.substr(mark.size()) : text;
}

bool countsAsLine(std::string const& line)
{
  const auto text = trimmed(line);
  return !text.empty() && text.front() != '#';
}
} // namespace

TableFile::TableFile(std::string const& file_name, std::string const& path)
    : file_name_(file_name)
    , path_(path + " = '" + file_name + "'")
{
  std::istringstream content(contentOf(file_name, path));
  std::string line;
  for (int number = 1; std::getline(content, line); ++number) {
    if (!countsAsLine(line)) {
      continue;
    }
    auto pieces = split(line, ',');
    if (headings_.empty()) {
      for (auto const& piece : pieces) {
        const auto open = piece.find('[');
        const bool has_unit = open != std::string::npos && piece.back() == ']';
        headings_.push_back(
          {trimmed(piece.substr(0, has_unit ? open : piece.size())),
           has_unit ? trimmed(piece.substr(open + 1, piece.size() - open - 2)) : "", has_unit});
      }
      continue;
    }
    ASPERITY_REQUIRE(pieces.size() == headings_.size(),
                     path_ << ", line " << number << ": '" << excerpt(trimmed(line)) << "' has "
                           << pieces.size() << " entries, but the first line names "
                           << headings_.size() << " columns, with commas between them.");
    pieces_.push_back(std::move(pieces));
    places_.push_back("line " + std::to_string(number) + " of '" + file_name + "'");
  }
  ASPERITY_REQUIRE(!headings_.empty(),
                   path_ << " is empty. A line with the names of its columns, such as "
                            "'depth [km], vp [km/s]', and lines of numbers are wanted.");
}

std::size_t TableFile::indexOf(Column const& column) const
{
  std::vector<std::string> names;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < headings_.size(); ++i) {
    names.push_back(headings_[i].name);
    if (headings_[i].name == column.name) {
      found.push_back(i);
    }
  }
  const std::string where = column.name_path + " = '" + column.name + "': '" + file_name_ + "'";
  ASPERITY_REQUIRE(!found.empty(), where << " has no such column." << didYouMean(column.name, names)
                                         << " Its first line has to name the columns, with commas "
                                            "between them: 'depth [km], vp [km/s]'.");
  ASPERITY_REQUIRE(found.size() == 1,
                   where << " has " << found.size() << " columns of this name. Rename one.");
  return found.front();
}

std::string TableFile::unitOf(Column const& column, Heading const& heading) const
{
  ASPERITY_REQUIRE(!heading.has_unit || column.unit.empty() || column.unit == heading.unit,
                   column.unit_path << " = '" << column.unit << "', but '" << file_name_
                                    << "' has the column '" << heading.name << "' in ["
                                    << heading.unit
                                    << "]. Remove the entry, or name the right column.");
  return heading.has_unit ? heading.unit : column.unit;
}

double TableFile::number(std::size_t row, std::size_t column) const
{
  auto const& text = pieces_[row][column];
  const auto value = readNumber(text);
  ASPERITY_REQUIRE(value, path_ << ", " << places_[row] << ", column '" << headings_[column].name
                                << "': '" << excerpt(text) << "' is no finite number.");
  return *value;
}

TableRows TableFile::rows(Column const& argument, Column const& value) const
{
  const auto numbersOf = [&](Column const& column, std::size_t index) {
    auto const& heading = headings_[index];
    const Unit unit(unitOf(column, heading), heading.has_unit
                                               ? path_ + ", column '" + heading.name + "'"
                                               : column.unit_path);
    std::vector<double> numbers;
    for (std::size_t row = 0; row < pieces_.size(); ++row) {
      numbers.push_back(unit.toSi(number(row, index)));
    }
    return numbers;
  };
  const auto of_arguments = indexOf(argument), of_values = indexOf(value);
  return {numbersOf(argument, of_arguments), numbersOf(value, of_values),
          unitOf(value, headings_[of_values]), places_};
}

std::uint64_t checksumOfFile(std::string const& file_name, std::string const& path)
{
  return Checksum().add(contentOf(file_name, path)).value();
}
} // namespace asperity
