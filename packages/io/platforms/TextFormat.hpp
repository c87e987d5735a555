#pragma once

#include "base/parameters/Parameters.hpp"

#include <filesystem>
#include <string>

namespace asperity::io
{
// Where the text files of a run may be uploaded: nowhere, the platform for sequences of
// earthquakes and aseismic slip (SEAS), or that of the rupture codes (SCEC).
enum class Platform
{
  none,
  seas,
  scec
};

// As the deck has it: "None", "SEAS", "SCEC".
char const* platformName(Platform platform);

// The platform and what its files say about the run: the choice `Text Format` in the deck's list
// `Output` and the list of that name.
struct TextFormat
{
  Platform platform = Platform::none;
  std::string problem; // "BP1-QD"
  std::string author;
  std::string date; // "2024/05/31"
  std::string code_version;
  double element_size = 0; // [m] on the fault; 0: that of its shortest element
  double time_step = 0;    // [s] between two rows, SCEC alone

  // The folder of its files within that of the run: "seas" or "scec".
  std::filesystem::path folder() const;

  static void declare(Declare& parameters);

  // Of the list `Output`, complete or not.
  static TextFormat from(Teuchos::ParameterList const& output);
};
} // namespace asperity::io
