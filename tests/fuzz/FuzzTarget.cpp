#include "FuzzTarget.hpp"

#include "base/Errors.hpp"

#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace asperity::fuzz
{
namespace
{
// A message repeats what it refuses, whose line ends are not ours.
void requireOneMessage(std::string const& message, std::string const& input)
{
  constexpr std::ptrdiff_t most_lines = 6;
  const auto line_ends = std::count(message.begin(), message.end(), '\n');
  const auto of_input = std::count(input.begin(), input.end(), '\n');
  if (message.empty() || line_ends - of_input >= most_lines) {
    std::cerr << "This is not one message: '" << message << "'\n";
    std::abort();
  }
}
} // namespace

// The reader of checkpoints sends messages to itself. Open MPI would keep crashes to itself, too.
void start(int& argc, char**& argv)
{
  setenv("OMPI_MCA_opal_signal", "", 1);
  MPI_Init(&argc, &argv);
  std::atexit([] { MPI_Finalize(); });
}

std::string checkInput(std::string const& input)
{
  try {
    tryInput(input);
    return "";
  } catch (InputError const& error) {
    requireOneMessage(error.what(), input);
    return error.what();
  }
}
} // namespace asperity::fuzz
