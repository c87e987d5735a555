#include "Arguments.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <filesystem>

namespace
{
bool contains(std::vector<std::string> const& names, std::string const& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

void requireKnown(std::string const& option, AllowedArguments const& allowed)
{
  auto names = allowed.options;
  names.insert(names.end(), allowed.flags.begin(), allowed.flags.end());
  ASPERITY_REQUIRE(contains(names, option),
                   "Unknown option '" << option << "'." << asperity::didYouMean(option, names));
}
} // namespace

double Arguments::number(std::string const& option, double otherwise) const
{
  if (!has(option)) {
    return otherwise;
  }
  auto const& text = options.at(option);
  const auto value = asperity::readNumber(text);
  ASPERITY_REQUIRE(value, "Option " << option << ": '" << text << "' is not a number.");
  return *value;
}

int Arguments::integer(std::string const& option, int otherwise) const
{
  if (!has(option)) {
    return otherwise;
  }
  auto const& text = options.at(option);
  const auto value = asperity::readInteger(text);
  ASPERITY_REQUIRE(value, "Option " << option << ": '" << text << "' is not a whole number.");
  return *value;
}

Arguments parseArguments(std::vector<std::string> const& words, AllowedArguments const& allowed)
{
  Arguments arguments;
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (word->size() < 2 || (*word)[0] != '-') {
      ASPERITY_REQUIRE(arguments.files.size() < allowed.files.size(),
                       "Unexpected argument '" << *word << "'.");
      arguments.files.push_back(*word);
      continue;
    }
    requireKnown(*word, allowed);
    const std::string option = *word;
    ASPERITY_REQUIRE(!arguments.has(option), "Option '" << option << "' is given twice.");
    if (contains(allowed.options, option)) {
      ++word;
      ASPERITY_REQUIRE(word != words.end(), "Option '" << option << "' needs a value.");
      arguments.options[option] = *word;
    } else {
      arguments.options[option] = "";
    }
  }
  ASPERITY_REQUIRE(arguments.files.size() == allowed.files.size(),
                   "The file " << allowed.files[arguments.files.size()]
                               << " is missing. See asperity-mesh --help.");
  return arguments;
}

void requireNew(std::string const& file_name, Arguments const& arguments)
{
  std::error_code error;
  ASPERITY_REQUIRE(arguments.has("--overwrite") || !std::filesystem::exists(file_name, error),
                   "'" << file_name << "' is there already. Give --overwrite to replace it.");
}
