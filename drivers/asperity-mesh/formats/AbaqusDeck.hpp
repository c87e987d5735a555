#pragma once

#include "mesh/GlobalMesh.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace asperity::geometry
{
// What an input file of Abaqus says of the mesh; numbers are the user's own.
struct AbaqusDeck
{
  // InputError, with file and line, for what is wrong, and for what is not read: *INCLUDE, moved
  // instances and elements of unknown types.
  explicit AbaqusDeck(std::string const& file_name);

  struct Element
  {
    int dimension;
    std::vector<std::int64_t> nodes;
    std::string set; // of its *ELEMENT
  };
  struct Set
  {
    std::string name;
    std::vector<std::int64_t> members;
  };
  struct Surface
  {
    std::string name;
    std::vector<std::pair<std::string, std::string>> sides; // element or set, and side
    bool is_of_nodes;
  };

  std::string where; // "Mesh file 'NAME'"
  std::map<std::int64_t, Point<3>> nodes;
  std::map<std::int64_t, Element> elements;
  std::map<std::string, Set> node_sets, element_sets; // by their names in upper case
  std::vector<std::string> sections;                  // their sets
  std::vector<Surface> surfaces;
};

// Names of sets are equal in upper case.
std::string upperCase(std::string text);
} // namespace asperity::geometry
