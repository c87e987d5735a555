#include "Arguments.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/program/Options.hpp"

#include <filesystem>

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

std::vector<std::string> Arguments::all(std::string const& option) const
{
  const auto found = repeated.find(option);
  return found == repeated.end() ? std::vector<std::string>() : found->second;
}

Arguments parseArguments(std::vector<std::string> const& words, AllowedArguments const& allowed)
{
  std::map<std::string, std::string> values;
  std::map<std::string, bool> flags;
  asperity::Options options;
  for (auto const& name : allowed.options) {
    options.value(name, values[name], "VALUE", "");
  }
  for (auto const& name : allowed.flags) {
    options.flag(name, flags[name], "");
  }
  Arguments arguments;
  for (auto const& name : allowed.repeated) {
    options.values(name, arguments.repeated[name], "VALUE", "");
  }
  arguments.files = options.parse(words);
  for (auto const& [name, value] : values) {
    if (!value.empty()) {
      arguments.options[name] = value;
    }
  }
  for (auto const& [name, is_given] : flags) {
    if (is_given) {
      arguments.options[name] = "";
    }
  }
  const std::size_t found = arguments.files.size(), wanted = allowed.files.size();
  ASPERITY_REQUIRE(found <= wanted, "Unexpected argument '" << arguments.files[wanted] << "'.");
  ASPERITY_REQUIRE(found == wanted,
                   "The file " << allowed.files[found] << " is missing. See asperity-mesh --help.");
  return arguments;
}

void requireNew(std::string const& file_name, Arguments const& arguments)
{
  std::error_code error;
  ASPERITY_REQUIRE(arguments.has("--overwrite") || !std::filesystem::exists(file_name, error),
                   "'" << file_name << "' is there already. Give --overwrite to replace it.");
}
