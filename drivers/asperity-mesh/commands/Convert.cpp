#include "FormatChoice.hpp"
#include "TargetFolder.hpp"
#include "Warnings.hpp"
#include "assembly/GroupNames.hpp"
#include "commands/Commands.hpp"
#include "commands/Meshes.hpp"
#include "formats/MeshFormat.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/GlobalMesh.hpp"
#include "mesh/TouchingFacets.hpp"

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace asperity::geometry
{
namespace
{
template <int Dim>
std::string extents(GlobalMesh<Dim> const& mesh)
{
  std::string text;
  for (int d = 0; d < Dim; ++d) {
    const auto [low, high] =
      std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                          [d](auto const& a, auto const& b) { return a[d] < b[d]; });
    text += (d == 0 ? "" : ", ") + std::string(1, "xyz"[d]) + " from " + formatShort((*low)[d]) +
            " to " + formatShort((*high)[d]) + " m";
  }
  return text;
}

template <int Dim>
void writeConverted(GlobalMesh<Dim> const& mesh, std::string const& where,
                    std::string const& file_name)
{
  if (const auto touching = mesh::touchingFacets(mesh)) {
    warn(where + ": " + mesh::sentence(*touching));
  }
  auto split = mesh; // refuses faults that cannot be split before the mesh is written
  mesh::splitFaults(split, where);
  const std::size_t regions = mesh.region_names.size(), faults = split.faults.size();
  writeAndReport(mesh, file_name,
                 ", " + std::to_string(regions) + " regions, " +
                   std::to_string(mesh.boundaries.size() - faults) + " boundaries, " +
                   std::to_string(faults) + " faults");
  std::cout << extents(mesh) << '\n';
}

// The factor from coordinates of the file to metres.
double factor(std::string const& units, std::optional<double> const& scale)
{
  ASPERITY_REQUIRE(!scale || *scale > 0,
                   "Option --scale = " << formatNumber(*scale) << " is outside (0, inf).");
  ASPERITY_REQUIRE(units.empty() || units == "m" || units == "km",
                   "Option --units = " << units
                                       << " is neither m nor km. For other units give --scale, "
                                          "their size in metres.");
  ASPERITY_REQUIRE(units.empty() || !scale,
                   "Options --units and --scale are both given. Give one of them.");
  return scale.value_or(units == "km" ? 1000 : 1);
}

// The options that some formats alone have.
class OwnOptions
{
public:
  void declare(Arguments& arguments)
  {
    auto const& registry = MeshFormatRegistry::instance();
    for (auto const& name : registry.names()) {
      for (auto const& option : registry.at(name).ownOptions()) {
        auto& known = options_[option.name];
        known.option = option;
        known.formats += (known.formats.empty() ? "" : ", ") + name;
      }
    }
    for (auto& [name, known] : options_) {
      auto const& option = known.option;
      const auto meaning = known.formats + ": " + option.meaning;
      if (option.may_repeat) {
        arguments.values(name, known.values, option.sample, meaning);
      } else {
        arguments.value(name, known.value, option.sample, meaning);
      }
    }
  }

  // What is given. InputError if the file's format has no such option.
  std::map<std::string, std::vector<std::string>> givenTo(FoundFormat const& found,
                                                          std::string const& where) const
  {
    std::map<std::string, std::vector<std::string>> given;
    for (auto const& [name, known] : options_) {
      const auto values =
        known.value.empty() ? known.values : std::vector<std::string>{known.value};
      if (values.empty()) {
        continue;
      }
      const auto own = found.format->ownOptions();
      ASPERITY_REQUIRE(
        std::any_of(own.begin(), own.end(),
                    [&option = name](auto const& one) { return one.name == option; }),
        "Option " << name << ' ' << values.front() << ": " << where << " is read as " << found.name
                  << ", and the option is only for " << known.formats << '.');
      given[name] = values;
    }
    return given;
  }

private:
  struct Known
  {
    FormatOption option;
    std::string formats, value;
    std::vector<std::string> values;
  };
  std::map<std::string, Known> options_;
};

// "IN.geo, IN.msh or IN.puml.h5"
std::string inputNames()
{
  auto names = endingsOf<MeshFormat>();
  for (auto& name : names) {
    name = "IN" + name;
  }
  return alternatives(names);
}

class Convert final : public Command
{
public:
  CommandText text() const override
  {
    return {
      "convert",
      "IN OUT.h5",
      "Converts a mesh of another program or meshes a geometry: " + describeFormats<MeshFormat>() +
        ". Groups become regions, boundaries and, where inside, faults.",
      {inputNames(), "OUT.h5"}};
  }

  void declareOptions(Arguments& arguments) override
  {
    arguments
      .values(boundaries_option, names_, "NUMBER=NAME,...",
              "names of boundaries and faults by the numbers that the file has for them, as "
              "\"1=free,3=fault,5=far\", or by their names there, as \"old=new\"; groups without "
              "a name are called boundary_1, boundary_3, codes of SeisSol by their meaning, as "
              "free_surface and fault")
      .values(regions_option, region_names_, "NUMBER=NAME,...", "the same for regions")
      .values("--without", without_, "NAME,...", "leave out these boundaries or faults")
      .value("--units", units_, "m|km", "unit of the coordinates (m)");
    arguments.number("--scale", scale_, "factor of all coordinates to metres, instead of --units");
    arguments.flag("--simplices", simplices_,
                   "cut quadrilaterals, hexahedra, prisms and pyramids into triangles and "
                   "tetrahedra, and leave out nodes of second order");
    own_.declare(arguments);
    arguments.overwrite();
  }

  void run(Arguments const& arguments) override
  {
    auto const& from = arguments.file(0);
    auto const& to = arguments.file(1);
    const GroupNames groups(names_, region_names_, without_);
    const AssemblyOptions assembly = {factor(units_, scale_), simplices_, groups.without};
    arguments.requireNew(to);
    const std::string where = "'" + from + "'";
    const auto found = formatOf(from);
    const ReadOptions options = {groups, assembly, to, own_.givenTo(found, where)};
    requireFolder(to);
    const auto mesh = found.format->read(from, options);
    std::visit([&](auto const& any) { writeConverted(any, where, to); }, mesh);
  }

private:
  std::vector<std::string> names_, region_names_, without_;
  std::string units_;
  OwnOptions own_;
  std::optional<double> scale_;
  bool simplices_ = false;
};
} // namespace

std::unique_ptr<Command> convertCommand() { return std::make_unique<Convert>(); }
} // namespace asperity::geometry
