#include "MeshFormat.hpp"

#include "../assembly/ForeignMesh.hpp"
#include "../assembly/GroupNaming.hpp"
#include "../assembly/NodeSets.hpp"
#include "../surfaces/files/TextFile.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <vector>

// Abaqus's input file: *NODE, *ELEMENT, sets *NSET and *ELSET, *SURFACE of sides S1, S2 ..., and
// sections, whose sets of elements are regions. Numbers are the user's own.
namespace
{
std::string upper(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string unquoted(std::string const& text)
{
  const auto inside = asperity::trimmed(text);
  return inside.size() > 1 && inside.front() == '"' && inside.back() == '"'
           ? inside.substr(1, inside.size() - 2)
           : inside;
}

// "*ELEMENT, TYPE=C3D4, ELSET=rock"; names are in upper case, values as they are.
struct Keyword
{
  explicit Keyword(std::string const& line)
  {
    for (auto const& piece : asperity::split(line.substr(1), ',')) {
      const auto equals = piece.find('=');
      const auto key = upper(asperity::trimmed(piece.substr(0, equals)));
      if (name.empty()) {
        name = key;
      } else {
        values[key] = equals == std::string::npos ? "" : unquoted(piece.substr(equals + 1));
      }
    }
  }
  std::string value(std::string const& key) const
  {
    const auto found = values.find(key);
    return found == values.end() ? "" : found->second;
  }

  std::string name;
  std::map<std::string, std::string> values;
};

// 3 for cells in space, 2 for those in the plane and shells, 1 for lines, -1 for what is unknown.
int dimensionOfType(std::string const& type)
{
  static const std::vector<std::pair<std::string, int>> begins = {
    {"C3D", 3},  {"DC3D", 3},  {"CPE", 2}, {"CPS", 2}, {"CAX", 2},   {"DC2D", 2},
    {"STRI", 2}, {"SFM3D", 2}, {"S", 2},   {"M3D", 2}, {"R3D", 2},   {"T2D", 1},
    {"T3D", 1},  {"B2", 1},    {"B3", 1},  {"R2D", 1}, {"FRAME", 1}, {"RAX", 1}};
  for (auto const& [begin, dimension] : begins) {
    if (type.rfind(begin, 0) == 0 && type.rfind("SPRING", 0) != 0) {
      return dimension;
    }
  }
  return -1;
}

// Side S(K + 1) of a cell, as places among its corners.
std::vector<std::vector<int>> const& abaqusSides(int dimension, int num_corners)
{
  static const std::map<int, std::vector<std::vector<int>>> in_space = {
    {4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}},
    {5, {{0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}}},
    {6, {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}},
    {8, {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}}};
  return dimension == 3 ? in_space.at(num_corners) : sidesOf(dimension, num_corners);
}

class AbaqusFile
{
public:
  AbaqusFile(std::string const& file_name, ReadOptions const& options)
      : options_(options)
      , file_(file_name, "Mesh file")
      , region_names_(options.names.regions, "--region-names", "set", {})
      , boundary_names_(options.names.boundaries, "--names", "set", {})
  {
  }

  AnyMesh mesh()
  {
    readFile();
    addVertices();
    addCells();
    addSurfaces();
    addShells();
    for (auto const& [key, set] : node_sets_) {
      addNodes(set);
    }
    return mesh_.dimension == 2 ? AnyMesh(finished<2>()) : AnyMesh(finished<3>());
  }

private:
  struct Element
  {
    int dimension;
    std::vector<std::int64_t> nodes;
    std::string set; // of its *ELEMENT
    int cell = -1;   // its position in the mesh
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

  template <int Dim>
  asperity::GlobalMesh<Dim> finished()
  {
    auto result = assemble<Dim>(mesh_, options_.assembly, file_.where());
    region_names_.finish(file_.where());
    boundary_names_.finish(file_.where());
    tellOfEmptySets(empty_);
    return result;
  }

  // Lines of data follow their keyword.
  void readFile()
  {
    Keyword keyword("*");
    while (file_.next()) {
      const auto line = asperity::trimmed(std::string(file_.line()));
      if (line.rfind("**", 0) == 0) {
        continue;
      }
      if (line.front() == '*') {
        requireWholeElement();
        keyword = Keyword(line);
        begin(keyword);
      } else {
        readData(keyword, line);
      }
    }
    requireWholeElement();
    ASPERITY_REQUIRE(!elements_.empty(), file_.where() << " has no *ELEMENT.");
  }

  void requireWholeElement() const
  {
    if (!pending_.empty()) {
      file_.fail("element " + std::to_string(pending_.front()) +
                 " ends with a comma, and no line with its other nodes follows.");
    }
  }

  void begin(Keyword const& keyword)
  {
    if (keyword.name == "INCLUDE") {
      file_.fail("*INCLUDE is not followed. Put the mesh into one file.");
    }
    if (keyword.name == "ELEMENT" && dimensionOfType(upper(keyword.value("TYPE"))) < 0) {
      file_.fail("elements of type '" + keyword.value("TYPE") +
                 "' cannot be read, only solids, shells, membranes and lines.");
    }
    if (keyword.name.size() > 8 && keyword.name.find(" SECTION") != std::string::npos &&
        !keyword.value("ELSET").empty()) {
      sections_.push_back(keyword.value("ELSET"));
    }
    const bool has_name = keyword.name == "NSET" || keyword.name == "ELSET";
    if ((has_name && keyword.value(keyword.name).empty()) ||
        (keyword.name == "SURFACE" && keyword.value("NAME").empty())) {
      file_.fail("*" + keyword.name + " needs a name.");
    }
    if (keyword.name == "SURFACE") {
      surfaces_.push_back({keyword.value("NAME"), {}, upper(keyword.value("TYPE")) == "NODE"});
    }
  }

  void readData(Keyword const& keyword, std::string const& line)
  {
    if (keyword.name == "NODE") {
      readNode();
    } else if (keyword.name == "ELEMENT") {
      readElement(keyword, line.back() == ',');
    } else if (keyword.name == "NSET" || keyword.name == "ELSET") {
      readSet(keyword, line);
    } else if (keyword.name == "SURFACE") {
      auto words = asperity::split(line, ',');
      words.resize(2);
      surfaces_.back().sides.emplace_back(unquoted(words[0]), upper(asperity::trimmed(words[1])));
    } else if (keyword.name == "INSTANCE") {
      file_.fail("an instance that is moved cannot be read. Merge the instances of the assembly "
                 "into one part.");
    }
  }

  void readNode()
  {
    file_.require(3, "node, x, y, z");
    const double z = file_.words().size() > 3 ? file_.number(3) : 0;
    const auto number = file_.integer(0);
    if (!nodes_.emplace(number, asperity::Point<3>{file_.number(1), file_.number(2), z}).second) {
      file_.fail("node " + std::to_string(number) +
                 " is given a second time. Merge the parts of the assembly into one.");
    }
  }

  // A line that ends with a comma goes on in the next one.
  void readElement(Keyword const& keyword, bool goes_on)
  {
    for (std::size_t i = 0; i < file_.words().size(); ++i) {
      pending_.push_back(file_.integer(i));
    }
    if (goes_on) {
      return;
    }
    const auto number = pending_.front();
    Element element{dimensionOfType(upper(keyword.value("TYPE"))),
                    {pending_.begin() + 1, pending_.end()},
                    keyword.value("ELSET")};
    pending_.clear();
    if (!element.set.empty()) {
      setOf(element_sets_, element.set).members.push_back(number);
    }
    if (!elements_.emplace(number, std::move(element)).second) {
      file_.fail("element " + std::to_string(number) +
                 " is given a second time. Merge the parts of the assembly into one.");
    }
  }

  static Set& setOf(std::map<std::string, Set>& sets, std::string const& name)
  {
    auto& set = sets[upper(name)];
    set.name = set.name.empty() ? name : set.name;
    return set;
  }

  void readSet(Keyword const& keyword, std::string const& line)
  {
    auto& sets = keyword.name == "NSET" ? node_sets_ : element_sets_;
    auto& set = setOf(sets, keyword.value(keyword.name));
    if (keyword.values.count("GENERATE") > 0) {
      file_.require(2, "first, last, step");
      const auto first = file_.integer(0), last = file_.integer(1);
      const auto step = file_.words().size() > 2 ? file_.integer(2) : 1;
      const auto largest = keyword.name == "NSET" ? last_of(nodes_) : last_of(elements_);
      if (step < 1 || first < 0 || last > largest) {
        file_.fail("the set goes from " + std::to_string(first) + " to " + std::to_string(last) +
                   " by " + std::to_string(step) + ", outside [0, " + std::to_string(largest) +
                   "].");
      }
      for (auto number = first; number <= last; number += step) {
        set.members.push_back(number);
      }
      return;
    }
    for (auto const& word : asperity::split(line, ',')) {
      const auto name = unquoted(word);
      const auto number = asperity::readInteger(name);
      const auto other = sets.find(upper(name));
      if (number) {
        set.members.push_back(*number);
      } else if (other != sets.end()) {
        const auto members = other->second.members; // may be of the same set
        set.members.insert(set.members.end(), members.begin(), members.end());
      } else if (!name.empty()) {
        file_.fail("'" + name + "' is neither a number nor a set before this line.");
      }
    }
  }

  template <class Value>
  static std::int64_t last_of(std::map<std::int64_t, Value> const& items)
  {
    return items.empty() ? 0 : items.rbegin()->first;
  }

  void addVertices()
  {
    for (auto const& [number, place] : nodes_) {
      position_[number] = static_cast<int>(mesh_.vertices.size());
      mesh_.numbers.push_back(number);
      mesh_.vertices.push_back(place);
    }
  }

  int positionOf(std::int64_t node, std::string const& user) const
  {
    const auto found = position_.find(node);
    ASPERITY_REQUIRE(found != position_.end(), file_.where() << ": " << user << " has node " << node
                                                             << ", which is not there.");
    return found->second;
  }

  std::vector<int> positions(std::vector<std::int64_t> const& nodes, std::string const& user) const
  {
    std::vector<int> result;
    for (auto node : nodes) {
      result.push_back(positionOf(node, user));
    }
    return result;
  }

  // The set of a section is the region, or the set of *ELEMENT, or else 'body'.
  std::map<std::int64_t, std::string> regions() const
  {
    std::map<std::int64_t, std::string> result;
    for (auto const& section : sections_) {
      const auto found = element_sets_.find(upper(section));
      if (found != element_sets_.end()) {
        for (auto number : found->second.members) {
          result[number] = found->second.name;
        }
      }
    }
    return result;
  }

  void addCells()
  {
    const bool is_solid = std::any_of(elements_.begin(), elements_.end(),
                                      [](auto const& item) { return item.second.dimension == 3; });
    mesh_.dimension = is_solid ? 3 : 2;
    const auto region_of = regions();
    for (auto& [number, element] : elements_) {
      if (element.dimension != mesh_.dimension) {
        continue;
      }
      const auto what = "element " + std::to_string(number);
      const int corners = cornersOf(element, what);
      const auto section = region_of.find(number);
      const auto region = section != region_of.end() ? section->second
                          : element.set.empty()      ? "body"
                                                     : element.set;
      element.cell = static_cast<int>(mesh_.cells.size());
      mesh_.addCell(mesh_.region(region_names_.nameOf(region)), positions(element.nodes, what),
                    corners, number);
    }
    ASPERITY_REQUIRE(!mesh_.cells.empty(), file_.where() << " has no cells.");
  }

  int cornersOf(Element const& element, std::string const& what) const
  {
    const auto count = static_cast<int>(std::min<std::size_t>(element.nodes.size(), 1000));
    const int corners =
      element.dimension == 1 ? std::min(count, 2) : cornersOfCell(element.dimension, count);
    ASPERITY_REQUIRE(corners > 1, file_.where()
                                    << ": " << what << " has " << count
                                    << " nodes. Only cells of first and, with --simplices, second "
                                       "order can be read.");
    return corners;
  }

  void addSurfaces()
  {
    for (auto const& surface : surfaces_) {
      if (surface.is_of_nodes) {
        Set all{surface.name, {}};
        for (auto const& [set, unused] : surface.sides) {
          const auto found = node_sets_.find(upper(set));
          if (found != node_sets_.end()) {
            auto const& members = found->second.members;
            all.members.insert(all.members.end(), members.begin(), members.end());
          }
        }
        addNodes(all);
        continue;
      }
      const auto name = boundary_names_.nameOf(surface.name);
      mesh_.group(name);
      for (auto const& [what, side] : surface.sides) {
        for (auto number : elementsOf(what, surface.name)) {
          addSide(name, number, side);
        }
      }
    }
  }

  std::vector<std::int64_t> elementsOf(std::string const& what, std::string const& surface) const
  {
    if (const auto number = asperity::readInteger(what)) {
      return {*number};
    }
    const auto found = element_sets_.find(upper(what));
    ASPERITY_REQUIRE(found != element_sets_.end(),
                     file_.where() << ": surface '" << surface << "' has '" << what
                                   << "', which is neither an element nor a set of elements.");
    return found->second.members;
  }

  void addSide(std::string const& name, std::int64_t number, std::string const& side)
  {
    const auto element = elements_.find(number);
    const bool is_numbered = side.size() > 1 && side[0] == 'S';
    const int which = is_numbered ? asperity::readInteger(side.substr(1)).value_or(0) : 0;
    const bool is_cell = element != elements_.end() && element->second.cell >= 0;
    const int corners =
      is_cell ? mesh_.cells[static_cast<std::size_t>(element->second.cell)].num_corners : 0;
    ASPERITY_REQUIRE(is_cell && which >= 1 &&
                       which <= static_cast<int>(abaqusSides(mesh_.dimension, corners).size()),
                     file_.where()
                       << ": surface '" << name << "' has side '" << side << "' of element "
                       << number << ". It needs sides S1, S2 ... of cells.");
    mesh_.addSide(name, element->second.cell,
                  abaqusSides(mesh_.dimension, corners)[static_cast<std::size_t>(which) - 1]);
  }

  // Sets of elements that are sides of cells.
  void addShells()
  {
    for (auto const& [key, set] : element_sets_) {
      std::vector<ForeignMesh::Side> sides;
      for (auto number : set.members) {
        const auto element = elements_.find(number);
        if (element != elements_.end() && element->second.dimension == mesh_.dimension - 1) {
          const auto what = "element " + std::to_string(number);
          auto nodes = positions(element->second.nodes, what);
          nodes.resize(static_cast<std::size_t>(cornersOf(element->second, what)));
          sides.push_back(ForeignMesh::side(nodes));
        }
      }
      if (!sides.empty()) {
        auto& group = mesh_.group(boundary_names_.nameOf(set.name)).sides;
        group.insert(group.end(), sides.begin(), sides.end());
      }
    }
  }

  void addNodes(Set const& set)
  {
    const auto name = boundary_names_.nameOf(set.name);
    if (!addNodeSet(mesh_, name, positions(set.members, "set '" + set.name + "'"))) {
      empty_.push_back(name);
    }
  }

  ReadOptions const& options_;
  asperity::geometry::TextFile file_;
  GroupNaming region_names_, boundary_names_;
  std::map<std::int64_t, asperity::Point<3>> nodes_;
  std::map<std::int64_t, int> position_;
  std::map<std::int64_t, Element> elements_;
  std::vector<std::int64_t> pending_;                   // of an element whose line goes on
  std::map<std::string, Set> node_sets_, element_sets_; // by their names in upper case
  std::vector<std::string> sections_;                   // their sets
  std::vector<Surface> surfaces_;
  ForeignMesh mesh_{3};
  std::vector<std::string> empty_; // sets without a side of a cell
};

class Abaqus final : public MeshFormat
{
public:
  std::vector<std::string> endings() const override { return {".inp"}; }
  AnyMesh read(std::string const& file_name, ReadOptions const& options) const override
  {
    return AbaqusFile(file_name, options).mesh();
  }
};
} // namespace

ASPERITY_REGISTER(MeshFormatRegistry, "Abaqus", Abaqus)
