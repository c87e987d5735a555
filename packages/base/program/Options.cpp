#include "base/program/Options.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "portability/Backend.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <functional>

namespace asperity
{
namespace
{
using Words = std::vector<std::string>;

bool startsWith(std::string const& text, std::string const& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

// "--output" of "--output=results".
std::string optionIn(std::string const& word) { return word.substr(0, word.find('=')); }

// Leaves out the dots that CLI11 prints after an option that takes several values: the meaning says
// which options may be repeated.
class OptionLines : public CLI::Formatter
{
public:
  std::string make_option_opts(CLI::Option const* option) const override
  {
    return option->get_type_name().empty() ? "" : " " + option->get_type_name();
  }
};

[[noreturn]] void refuseWithoutValue(std::string const& option)
{
  throw InputError("The option " + option + " needs a value. Try --help.");
}
} // namespace

struct Options::Implementation
{
  CLI::App app;
  std::vector<std::string> flags;
  std::vector<std::string> names;

  void addValued(std::string const& name, std::string const& sample, std::string const& meaning,
                 std::function<void(Words const&)> const& take)
  {
    const auto check_and_take = [name, take](Words const& given) {
      for (auto const& value : given) {
        if (value.empty() || startsWith(value, "--")) {
          refuseWithoutValue(name);
        }
      }
      take(given);
    };
    names.push_back(name);
    app.add_option_function<Words>(name, check_and_take, meaning)
      ->type_name(sample)
      ->allow_extra_args(false) // one value for each time it is given
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }

  // CLI11 found a value that is missing, or one too many.
  [[noreturn]] void refuseMismatch(Words const& words) const
  {
    for (auto const& word : words) {
      const auto equals = word.find('=');
      const bool is_flag = std::find(flags.begin(), flags.end(), optionIn(word)) != flags.end();
      ASPERITY_REQUIRE(equals == std::string::npos || !is_flag,
                       "The option " << optionIn(word) << " takes no value, but '"
                                     << word.substr(equals + 1) << "' is given.");
    }
    refuseWithoutValue(optionIn(words.back()));
  }
};

Options::Options() : implementation_(std::make_unique<Implementation>())
{
  implementation_->app.set_help_flag();
  implementation_->app.allow_extras();
}

Options::~Options() = default;

Options& Options::value(std::string const& name, std::string& target, std::string const& sample,
                        std::string const& meaning)
{
  implementation_->addValued(name, sample, meaning, [name, &target](Words const& given) {
    ASPERITY_REQUIRE(given.size() == 1, "The option " << name << " is given twice: '" << given[0]
                                                      << "' and '" << given[1] << "'.");
    target = given.front();
  });
  return *this;
}

Options& Options::values(std::string const& name, std::vector<std::string>& target,
                         std::string const& sample, std::string const& meaning)
{
  implementation_->addValued(name, sample, meaning + "; may be repeated",
                             [&target](Words const& given) { target = given; });
  return *this;
}

Options& Options::flag(std::string const& name, bool& target, std::string const& meaning)
{
  const auto last = name.substr(name.rfind(',') + 1); // its long form
  implementation_->flags.push_back(last);
  implementation_->names.push_back(last);
  implementation_->app.add_flag(name, target, meaning)->disable_flag_override();
  return *this;
}

std::vector<std::string> Options::parse(std::vector<std::string> const& words)
{
  std::vector<std::string> reversed(words.rbegin(), words.rend()); // as CLI11 wants them
  try {
    implementation_->app.parse(reversed);
  } catch (CLI::ArgumentMismatch const&) {
    implementation_->refuseMismatch(words);
  } catch (CLI::ParseError const& error) {
    throw InputError(std::string(error.what()) + " Try --help.");
  }
  std::vector<std::string> others;
  for (auto const& word : implementation_->app.remaining()) {
    if (word.size() < 2 || word[0] != '-') {
      others.push_back(word);
    } else if (startsWith(word, "--kokkos")) {
      throw InputError("The option " + optionIn(word) + " is unknown to Kokkos " + kokkosVersion() +
                       ", with which this program was built." +
                       didYouMean(optionIn(word), kokkosOptions()) +
                       " --kokkos-help lists its options.");
    } else {
      throw InputError("The option " + optionIn(word) + " is unknown." +
                       didYouMean(optionIn(word), implementation_->names));
    }
  }
  return others;
}

std::string Options::help() const
{
  OptionLines formatter;
  formatter.column_width(34);
  return formatter.make_groups(&implementation_->app, CLI::AppFormatMode::Normal);
}

std::vector<std::string> wordsOf(int argc, char const* const* argv)
{
  return {argv + std::min(argc, 1), argv + argc};
}
} // namespace asperity
