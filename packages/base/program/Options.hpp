#pragma once

#include <memory>
#include <string>
#include <vector>

namespace asperity
{
// The options of a program; CLI11 reads them. "--name value" and "--name=value" are alike.
//
//   std::string output;
//   Options options;
//   options.value("--output", output, "DIR", "where the results go");
//   auto const files = options.parse(words);
//
// A name may have a short form: "-h,--help". Targets must outlive this object.
class Options
{
public:
  Options();
  ~Options();

  // A value that is given at most once.
  Options& value(std::string const& name, std::string& target, std::string const& sample,
                 std::string const& meaning);
  // Values of an option that may be repeated, in their order.
  Options& values(std::string const& name, std::vector<std::string>& target,
                  std::string const& sample, std::string const& meaning);
  Options& flag(std::string const& name, bool& target, std::string const& meaning);

  // What is neither an option nor its value, in its order. MpiScope has taken out the options that
  // Kokkos knows, so that a --kokkos-... that is left is refused.
  // InputError for an unknown option, with the nearest one, for a missing value, a second value,
  // and a value where none is taken.
  std::vector<std::string> parse(std::vector<std::string> const& words);

  // A line for each option.
  std::string help() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// What follows the name of the program.
std::vector<std::string> wordsOf(int argc, char const* const* argv);
} // namespace asperity
