#pragma once

#include "io/Output.hpp"
#include "parameters/Parameters.hpp"

#include <string>

namespace asperity::platforms
{
// What the files of a platform say about the run.
struct RunFacts
{
  std::string problem; // "BP1-QD"
  std::string author;
  std::string date; // "2024/05/31"
  std::string code_version;
  double element_size = 0;       // [m] on the fault
  double depth_of_upper_end = 0; // [m] distance down dip at the fault's upper end

  // The entries of a platform's list; `problem` is the default of `Problem`.
  static Declare declare(std::string const& problem);

  // Reads such a list after it has been completed. Collective.
  static RunFacts from(Teuchos::ParameterList const& parameters, io::OutputContext const& context);
};
} // namespace asperity::platforms
