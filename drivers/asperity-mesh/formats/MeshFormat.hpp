#pragma once

#include "../GmshGroups.hpp"
#include "../assembly/ForeignMesh.hpp"

#include "mesh/GlobalMesh.hpp"
#include "portability/Registry.hpp"

#include <string>
#include <variant>
#include <vector>

// A format of meshes that convert reads.
using AnyMesh = std::variant<asperity::GlobalMesh<2>, asperity::GlobalMesh<3>>;

struct ReadOptions
{
  GroupNames names; // of regions and boundaries in the file
  AssemblyOptions assembly;
  std::vector<std::string> settings; // NAME=VALUE, for a geometry
  std::string target;                // the file that convert writes
  std::string array;                 // of a VTK file: the cell data that number the groups, or ""
};

// Registered under its name at the end of the format's file, which is all that the format needs:
//   ASPERITY_REGISTER(MeshFormatRegistry, "PUML", Puml)
class MeshFormat
{
public:
  static constexpr char const* registered_as = "mesh format";
  MeshFormat() = default;
  virtual ~MeshFormat() = default;
  MeshFormat(MeshFormat const&) = delete;
  MeshFormat& operator=(MeshFormat const&) = delete;

  virtual std::vector<std::string> endings() const = 0; // of file names, as ".msh"
  // Whether a file with this ending is a geometry, which takes settings.
  virtual bool isGeometry(std::string const& /*ending*/) const { return false; }

  // A mesh in m that mesh::checkMesh accepts (assemble). It may have boundaries inside the body,
  // which are faults then. Remarks and warnings are printed. InputError, which names the file, if
  // it cannot be read or is wrong.
  virtual AnyMesh read(std::string const& file_name, ReadOptions const& options) const = 0;
};
using MeshFormatRegistry = asperity::Registry<MeshFormat>;

struct FoundFormat
{
  MeshFormat const* format;
  std::string ending;
};
// By the longest ending of the file's name, in lower or upper case; InputError if none fits.
FoundFormat formatOf(std::string const& file_name);
std::vector<std::string> knownEndings(); // sorted
