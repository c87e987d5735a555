#include "commands/Arguments.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <filesystem>

namespace asperity::geometry
{
namespace
{
void readTo(double& target, std::string const& option, std::string const& text)
{
  const auto value = readNumber(text);
  ASPERITY_REQUIRE(value, "Option " << option << ": '" << text << "' is not a number.");
  target = *value;
}

void readTo(int& target, std::string const& option, std::string const& text)
{
  const auto value = readInteger(text);
  ASPERITY_REQUIRE(value, "Option " << option << ": '" << text << "' is not a whole number.");
  target = *value;
}

template <class Number>
void readTo(std::optional<Number>& target, std::string const& option, std::string const& text)
{
  readTo(target.emplace(), option, text);
}

std::string inBrackets(double value) { return " (" + formatNumber(value) + ")"; }

template <class Number>
std::string inBrackets(std::optional<Number> const&)
{
  return "";
}
} // namespace

template <class Number>
Arguments& Arguments::number(std::string const& name, Number& target, std::string const& meaning)
{
  auto& text = texts_.emplace_back();
  value(name, text, "NUMBER", meaning + inBrackets(target));
  readers_.emplace_back([&target, name, &text] {
    if (!text.empty()) {
      readTo(target, name, text);
    }
  });
  return *this;
}

template Arguments& Arguments::number(std::string const&, double&, std::string const&);
template Arguments& Arguments::number(std::string const&, int&, std::string const&);
template Arguments& Arguments::number(std::string const&, std::optional<double>&,
                                      std::string const&);
template Arguments& Arguments::number(std::string const&, std::optional<int>&, std::string const&);

void Arguments::overwrite() { flag("--overwrite", overwrites_, "replace a file that is there"); }

void Arguments::read(std::vector<std::string> const& words, std::vector<std::string> const& files,
                     std::size_t fewest)
{
  files_ = parse(words);
  for (auto const& reader : readers_) {
    reader();
  }
  const std::size_t found = files_.size();
  ASPERITY_REQUIRE(found <= files.size(), "Unexpected argument '" << files_[files.size()] << "'.");
  ASPERITY_REQUIRE(found >= fewest,
                   "The file " << files[found] << " is missing. See asperity-mesh --help.");
}

void Arguments::requireNew(std::string const& file_name) const
{
  std::error_code error;
  ASPERITY_REQUIRE(overwrites_ || !std::filesystem::exists(file_name, error),
                   "'" << file_name << "' is there already. Give --overwrite to replace it.");
}
} // namespace asperity::geometry
