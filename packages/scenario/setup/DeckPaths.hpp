#pragma once

#include <string>

namespace asperity::scenario
{
// The names of the lists of a deck.
namespace deck_lists
{
inline constexpr char const* mesh = "Mesh";
inline constexpr char const* bulk = "Bulk";
inline constexpr char const* friction = "Friction";
inline constexpr char const* conditions = "Boundary Conditions";
inline constexpr char const* initial = "Initial State";
inline constexpr char const* time = "Time Stepping";
inline constexpr char const* coupling = "Coupling";
inline constexpr char const* solver = "TNNMG";
inline constexpr char const* output = "Output";
} // namespace deck_lists

// Where they are, for messages.
inline std::string pathInDeck(char const* list) { return std::string("Asperity / ") + list; }
inline const std::string mesh_path = pathInDeck(deck_lists::mesh);
inline const std::string bulk_path = pathInDeck(deck_lists::bulk);
inline const std::string friction_path = pathInDeck(deck_lists::friction);
inline const std::string conditions_path = pathInDeck(deck_lists::conditions);
inline const std::string initial_path = pathInDeck(deck_lists::initial);
inline const std::string time_path = pathInDeck(deck_lists::time);
inline const std::string output_path = pathInDeck(deck_lists::output);
} // namespace asperity::scenario
