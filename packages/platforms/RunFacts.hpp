#pragma once

#include "base/parameters/Parameters.hpp"
#include "io/Output.hpp"

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
  double depth_of_upper_end = 0; // [m] down dip, where the problem begins to count above the mesh

  // The entries of a platform's list; `problem` is the default of `Problem`.
  static Declare declare(std::string const& problem);

  // Of such a list, complete. Collective.
  static RunFacts from(Teuchos::ParameterList const& parameters, io::OutputContext const& context);
};
} // namespace asperity::platforms
