#pragma once

#include "FormatChoice.hpp"
#include "assembly/ForeignMesh.hpp"
#include "assembly/GroupNames.hpp"

#include "mesh/GlobalMesh.hpp"
#include "registry/Registry.hpp"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace asperity::geometry
{
// A format of meshes that convert reads.
using AnyMesh = std::variant<GlobalMesh<2>, GlobalMesh<3>>;

// An option of convert that some formats alone have. Formats may share one.
struct FormatOption
{
  std::string name, sample, meaning; // "--array", "NAME", a text for --help
  bool may_repeat = false;
};

struct ReadOptions
{
  GroupNames names; // of regions and boundaries in the file
  AssemblyOptions assembly;
  std::string target; // the file that convert writes
  // The values that are given for the format's own options; options that are not given are absent.
  std::map<std::string, std::vector<std::string>> own;

  std::vector<std::string> valuesOf(std::string const& option) const;
  std::string valueOf(std::string const& option) const; // "" if it is not given
};

// Registered under its name at the end of the format's file, which is all that the format needs:
//   ASPERITY_REGISTER(MeshFormatRegistry, "Exodus", Exodus)
class MeshFormat
{
public:
  static constexpr char const* registered_as = "mesh format";
  MeshFormat() = default;
  virtual ~MeshFormat() = default;
  MeshFormat(MeshFormat const&) = delete;
  MeshFormat& operator=(MeshFormat const&) = delete;

  virtual std::vector<std::string> endings() const = 0; // of file names, as ".msh"
  virtual std::vector<FormatOption> ownOptions() const { return {}; }

  // A mesh in m that mesh::checkMesh accepts (assemble). It may have boundaries inside the body,
  // which are faults then. Remarks and warnings are printed. InputError, which names the file, if
  // it cannot be read or is wrong.
  virtual AnyMesh read(std::string const& file_name, ReadOptions const& options) const = 0;
};
using MeshFormatRegistry = Registry<MeshFormat>;

using FoundFormat = NamedFormat<MeshFormat>;
// By the longest ending of the file's name, in lower or upper case; InputError if none fits.
FoundFormat formatOf(std::string const& file_name);
} // namespace asperity::geometry
