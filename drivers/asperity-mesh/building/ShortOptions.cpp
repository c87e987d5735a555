#include "building/ShortOptions.hpp"

#include "building/BuildParameters.hpp"
#include "surfaces/kinds/SurfaceKinds.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "parameters/Deck.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace asperity::geometry
{
namespace
{
// "Cell Size" for "cell-size": words begin with a capital letter.
std::string parameterName(std::string const& key)
{
  std::string name = key == "size" ? "cell-size" : key;
  bool is_start = true;
  for (char& c : name) {
    c = c == '-' ? ' ' : c;
    c = is_start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    is_start = c == ' ';
  }
  return name;
}

// "20000" for "20km" and "20 km"; other texts as they are.
std::string withoutUnit(std::string const& text)
{
  for (auto const& [unit, factor] : {std::pair("km", 1000.), std::pair("m", 1.)}) {
    const std::string ending = unit;
    if (text.size() > ending.size() &&
        text.compare(text.size() - ending.size(), ending.size(), ending) == 0) {
      if (const auto number = readNumber(trimmed(text.substr(0, text.size() - ending.size())))) {
        return formatNumber(factor * *number);
      }
    }
  }
  return text;
}

// FILE[,KEY=VALUE]...; a piece without = belongs to the value before it: min(1, 2).
class SurfaceText
{
public:
  SurfaceText(std::string const& text, std::string const& option)
  {
    std::string rest = text;
    for (std::size_t comma = 0; comma != std::string::npos;) {
      comma = rest.find(',');
      const auto piece = rest.substr(0, comma);
      const auto equals = piece.find('=');
      if (file_.empty()) {
        file_ = trimmed(piece);
      } else if (equals != std::string::npos && isKey(piece, equals)) {
        entries_.emplace_back(trimmed(piece.substr(0, equals)), trimmed(piece.substr(equals + 1)));
      } else {
        ASPERITY_REQUIRE(!entries_.empty(), option << ' ' << text << ": '" << piece
                                                   << "' is not of the form KEY=VALUE.");
        entries_.back().second += "," + piece;
      }
      rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
    }
    ASPERITY_REQUIRE(!file_.empty(), option << ' ' << text << ": the name of a file is missing.");
  }

  // "path/Entry=value" for each. The deck's files are relative to `folder`, those of options to
  // where the program runs.
  std::vector<std::string> assignments(std::string const& path, std::string const& units,
                                       std::filesystem::path const& folder) const
  {
    std::vector<std::string> entries, result;
    for (auto const& [key, value] : entries_) {
      entries.push_back(parameterName(key));
    }
    auto const file = folder.empty() ? file_ : std::filesystem::proximate(file_, folder).string();
    result.push_back(path + "/" + fileEntryFor(file_, entries) + "=" + file);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      result.push_back(path + "/" + entries[i] + "=" + withoutUnit(entries_[i].second));
    }
    if (!units.empty() && std::count(entries.begin(), entries.end(), "Units") == 0) {
      result.push_back(path + "/Units=" + units);
    }
    return result;
  }

private:
  static bool isKey(std::string const& piece, std::size_t equals)
  {
    return std::all_of(piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(equals),
                       [](unsigned char c) { return std::islower(c) || c == '-' || c == ' '; });
  }

  std::string file_;
  std::vector<std::pair<std::string, std::string>> entries_;
};

// Sets an entry of the deck, as a number if the text is one. All entries are validated later.
void assign(ParameterList& deck, std::string const& assignment)
{
  const auto equals = assignment.find('=');
  ASPERITY_REQUIRE(equals != std::string::npos,
                   "Option --set " << assignment << " is not of the form \"Path/To/Name=value\".");
  const auto names = split(assignment.substr(0, equals), '/');
  const auto value = assignment.substr(equals + 1);
  auto* list = &deck;
  for (std::size_t i = 0; i + 1 < names.size(); ++i) {
    list = &list->sublist(names[i]);
  }
  if (const auto number = readNumber(value)) {
    list->set(names.back(), *number);
  } else {
    list->set(names.back(), value);
  }
}
} // namespace

void applyOptions(ShortOptions const& options, ParameterList& deck,
                  std::filesystem::path const& folder)
{
  for (auto const& fault : options.faults) {
    const auto equals = fault.find('=');
    const auto name = trimmed(fault.substr(0, equals));
    ASPERITY_REQUIRE(equals != std::string::npos && !name.empty(),
                     "Option --fault " << fault << " is not of the form NAME=FILE.");
    ASPERITY_REQUIRE(name.find('/') == std::string::npos,
                     "Option --fault " << fault << ": a name has no '/'.");
    const SurfaceText text(fault.substr(equals + 1), "Option --fault");
    for (auto const& assignment : text.assignments("Faults/" + name, options.units, folder)) {
      assign(deck, assignment);
    }
  }
  if (!options.ground.empty()) {
    const SurfaceText text(options.ground, "Option --ground");
    for (auto const& assignment : text.assignments("Ground", options.units, folder)) {
      assign(deck, assignment);
    }
  }
  const std::pair<std::string, std::string const&> values[] = {
    {"Cell Size", options.size},       {"Largest", options.largest}, {"Growth", options.growth},
    {"Box/Margin", options.margin},    {"Box/Depth", options.depth}, {"Snap", options.snap},
    {"Projection", options.projection}};
  for (auto const& [path, value] : values) {
    if (!value.empty()) {
      assign(deck, path + "=" + withoutUnit(value));
    }
  }
  if (!options.deck.empty()) { // files of options are relative to the working directory
    deck.set("Deck", std::filesystem::absolute(options.deck).string());
  }
  for (auto const& assignment : options.assignments) {
    applyOverride(deck, *buildParameters(), assignment);
  }
}
} // namespace asperity::geometry
