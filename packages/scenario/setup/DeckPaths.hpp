#pragma once

#include <string>

// Where the lists of a deck are, for messages.
namespace asperity::scenario
{
inline const std::string mesh_path = "Asperity / Mesh";
inline const std::string bulk_path = "Asperity / Bulk";
inline const std::string friction_path = "Asperity / Friction";
inline const std::string initial_path = "Asperity / Initial State";
inline const std::string time_path = "Asperity / Time Stepping";
inline const std::string output_path = "Asperity / Output";
} // namespace asperity::scenario
