#include "commands/Commands.hpp"
#include "commands/Meshes.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/GlobalMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::geometry
{
namespace
{
// "0.05 to 0.25, 0.35 to 0.55"
std::vector<std::array<double, 2>> patchesFrom(std::string const& text)
{
  std::vector<std::array<double, 2>> patches;
  for (auto const& piece : split(text, ',')) {
    const auto middle = piece.find(" to ");
    const auto low = readNumber(trimmed(piece.substr(0, middle)));
    const auto high =
      middle == std::string::npos ? std::nullopt : readNumber(trimmed(piece.substr(middle + 4)));
    ASPERITY_REQUIRE(low && high, "Option --patches: '" << piece << "' is no interval of z. Write "
                                                        << "'0.05 to 0.25, 0.35 to 0.55'.");
    patches.push_back({*low, *high});
  }
  return patches;
}

class Wedge final : public Command
{
public:
  CommandText text() const override
  {
    return {"wedge",
            "OUT.h5",
            "Makes the subduction wedge of Pipping 2014, A.1, by bisection.",
            {"OUT.h5"}};
  }

  void declareOptions(Arguments& arguments) override
  {
    arguments
      .number("--cell-size", shape_.cell_size,
              "largest diameter of cells at the seismogenic zone, m")
      .number("--growth-factor", shape_.growth_factor,
              "relative growth of cells over one growth length")
      .number("--growth-length", shape_.growth_length,
              "distance from the zone over which cells grow, m")
      .number("--length", shape_.length, "of the surface, m")
      .number("--height", shape_.height, "of the right face, m")
      .number("--zone-width", shape_.zone_width, "of the seismogenic zone along the base, m")
      .number("--zone-end", shape_.zone_end, "its lower end, along the surface from the trench, m")
      .number("--viscous-thickness", shape_.viscous_thickness, "of the region 'lower', m")
      .number("--depth", depth_, "along z, m: tetrahedra instead of triangles")
      .number("--layers", layers_, "with depth: number of equal layers of the plane wedge")
      .value("--patches", patches_, "INTERVALS",
             "with depth: z of the seismogenic zone, m (all), as '0.05 to 0.25, 0.35 to 0.55'")
      .flag("--periodic", is_periodic_, "with depth: along z");
    arguments.overwrite();
  }

  void run(Arguments const& arguments) override
  {
    arguments.requireNew(arguments.file(0));
    if (depth_) {
      writeAndReport(deepMesh(), arguments.file(0));
    } else {
      requireNoOptionOfDepth();
      writeAndReport(mesh::wedgeMesh(shape_), arguments.file(0));
    }
  }

private:
  void requireNoOptionOfDepth() const
  {
    char const* option = !patches_.empty() ? "--patches"
                         : layers_         ? "--layers"
                         : is_periodic_    ? "--periodic"
                                           : nullptr;
    ASPERITY_REQUIRE(option == nullptr, "Option " << option << " needs --depth too.");
  }

  GlobalMesh<3> deepMesh() const
  {
    if (!layers_) {
      mesh::DeepWedge deep;
      deep.depth = *depth_;
      deep.is_periodic = is_periodic_;
      if (!patches_.empty()) {
        deep.patches = patchesFrom(patches_);
      }
      return mesh::deepWedgeMesh(shape_, deep);
    }
    ASPERITY_REQUIRE(patches_.empty(), "Option --patches cannot be combined with --layers, whose "
                                       "layers are all alike.");
    auto mesh = mesh::layeredWedgeMesh(shape_, *depth_, *layers_);
    if (is_periodic_) {
      mesh::makePeriodic(mesh, 2, "front", "back");
    }
    return mesh;
  }

  mesh::WedgeShape shape_;
  std::optional<double> depth_;
  std::optional<int> layers_;
  std::string patches_;
  bool is_periodic_ = false;
};
} // namespace

std::unique_ptr<Command> wedgeCommand() { return std::make_unique<Wedge>(); }
} // namespace asperity::geometry
