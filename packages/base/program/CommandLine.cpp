#include "base/program/CommandLine.hpp"

#include "base/NearestName.hpp"

#include <ostream>

namespace asperity
{
namespace
{
const std::vector<std::string> options = {
  "--set",       "--overlay",          "--output", "--restart", "--validate",
  "--overwrite", "--print-parameters", "--format", "--help",    "--plugin"};

bool startsWith(std::string const& text, std::string const& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

// "--name value" and "--name=value" alike; a flag has no value.
class Arguments
{
public:
  Arguments(int argc, char const* const* argv) : arguments_(argv + 1, argv + argc) {}

  bool next()
  {
    if (position_ == arguments_.size()) {
      return false;
    }
    name_ = arguments_[position_++];
    const auto equals = name_.find('=');
    has_value_ = startsWith(name_, "--") && equals != std::string::npos;
    if (has_value_) {
      value_ = name_.substr(equals + 1);
      name_ = name_.substr(0, equals);
    }
    return true;
  }

  std::string const& name() const { return name_; }

  std::string value()
  {
    if (!has_value_) {
      ASPERITY_REQUIRE(position_ < arguments_.size() && !startsWith(arguments_[position_], "--"),
                       "The option " << name_ << " wants a value. Try --help.");
      value_ = arguments_[position_++];
    }
    ASPERITY_REQUIRE(!value_.empty(), "The option " << name_ << " wants a value. Try --help.");
    return value_;
  }

  bool flag() const
  {
    ASPERITY_REQUIRE(!has_value_,
                     "The option " << name_ << " takes no value, but '" << value_ << "' is given.");
    return true;
  }

private:
  std::vector<std::string> arguments_;
  std::size_t position_ = 0;
  std::string name_, value_;
  bool has_value_ = false;
};

ParameterFormat readFormat(std::string const& word)
{
  ASPERITY_REQUIRE(word == "text" || word == "xml",
                   "--format = '" << word << "' is unknown." << didYouMean(word, {"text", "xml"}));
  return word == "xml" ? ParameterFormat::xml : ParameterFormat::text;
}

void readOption(Arguments& arguments, CommandLine& line)
{
  std::string const& name = arguments.name();
  if (name == "--set") {
    line.overrides.push_back(arguments.value());
  } else if (name == "--overlay") {
    line.overlays.push_back(arguments.value());
  } else if (name == "--plugin") {
    line.plugins.push_back(arguments.value());
  } else if (name == "--output") {
    line.output = arguments.value();
  } else if (name == "--restart") {
    line.restart = arguments.value();
  } else if (name == "--format") {
    line.format = readFormat(arguments.value());
  } else if (name == "--validate") {
    line.validate = arguments.flag();
  } else if (name == "--overwrite") {
    line.overwrite = arguments.flag();
  } else if (name == "--print-parameters") {
    line.print_parameters = arguments.flag();
  } else if (name == "--help" || name == "-h") {
    line.help = arguments.flag();
  } else {
    throw InputError("The option " + name + " is unknown." + didYouMean(name, options));
  }
}
} // namespace

CommandLine parseCommandLine(int argc, char const* const* argv)
{
  CommandLine line;
  Arguments arguments(argc, argv);
  while (arguments.next()) {
    std::string const& name = arguments.name();
    if (startsWith(name, "--kokkos")) {
      continue;
    }
    if (startsWith(name, "-")) {
      readOption(arguments, line);
      continue;
    }
    ASPERITY_REQUIRE(line.deck.empty(), "Two decks are given, '"
                                          << line.deck << "' and '" << name
                                          << "'. Lay one over the other with --overlay.");
    line.deck = name;
  }
  ASPERITY_REQUIRE(
    !line.deck.empty() || line.help || line.print_parameters,
    "No deck is given. Usage: asperity DECK.xml [options]; --help lists the options.");
  return line;
}

void printHelp(std::ostream& out)
{
  out
    << "Usage: asperity DECK.xml [options]\n"
       "       asperity --print-parameters [--format=text|xml] [--plugin LIBRARY]...\n"
       "\n"
       "Simulates the earthquakes that the deck describes.\n"
       "\n"
       "  --set \"Path/To/Parameter=value\"   replace or add a parameter; may be repeated\n"
       "  --overlay FILE                    lay a second short deck over the first; may be "
       "repeated\n"
       "  --plugin LIBRARY                  shared library with laws and outputs of your own; may "
       "be "
       "repeated\n"
       "  --output DIR                      where the results go\n"
       "  --restart FILE                    go on from a checkpoint\n"
       "  --overwrite                       replace results that are already there\n"
       "  --validate                        check deck and mesh, compute nothing\n"
       "  --print-parameters                every parameter with default, unit, range and meaning\n"
       "  --format=text|xml                 of --print-parameters\n"
       "  --help                            this text\n"
       "  --kokkos-...                      options of Kokkos\n"
       "\n"
       "Exit status: 0 done, 2 the input is at fault, 3 a solve failed, 4 stopped by a signal, 5 a "
       "file cannot be written, 1 other.\n";
}
} // namespace asperity
