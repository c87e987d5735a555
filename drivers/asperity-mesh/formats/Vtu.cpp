#include "formats/MeshFormat.hpp"
#include "formats/VtkGrid.hpp"
#include "formats/VtkPieces.hpp"
#include "formats/VtkXml.hpp"

#include "base/Text.hpp"
#include "registry/Registry.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

// Unstructured grids of VTK's XML format: .vtu, of one or several pieces, and .pvtu, which names
// the files of the pieces.
namespace asperity::geometry
{
namespace
{
std::vector<std::int64_t> wholeNumbers(std::vector<double> const& values, std::string const& name,
                                       VtkXml const& file)
{
  std::vector<std::int64_t> result;
  for (double value : values) {
    file.require(std::abs(value) < 1e15, "has a value " + formatNumber(value) + " in array '" +
                                           name + "', which needs whole numbers");
    result.push_back(static_cast<std::int64_t>(value));
  }
  return result;
}

void readArray(VtkXml const& file, std::string const& section, VtkXml::Tag const& tag,
               VtkGrid& grid)
{
  const auto name = tag.attribute("Name");
  if (section == "Points") {
    grid.points = file.valuesOf(tag);
  } else if (section == "CellData") {
    if (tag.attribute("type") != "String" && tag.attribute("NumberOfComponents", "1") == "1") {
      grid.cell_data[name] = file.valuesOf(tag);
    }
  } else if (section == "Cells" && name == "connectivity") {
    grid.connectivity = wholeNumbers(file.valuesOf(tag), name, file);
  } else if (section == "Cells" && name == "offsets") {
    grid.offsets = wholeNumbers(file.valuesOf(tag), name, file);
  } else if (section == "Cells" && name == "types") {
    grid.types = wholeNumbers(file.valuesOf(tag), name, file);
  }
}

std::vector<VtkGrid> piecesOf(std::string const& file_name)
{
  const VtkXml file(file_name, "UnstructuredGrid");
  std::vector<VtkGrid> pieces;
  std::string section;
  for (auto tag = file.next(0); !tag.name.empty() && tag.name != "AppendedData";
       tag = file.next(tag.end)) {
    if (tag.name == "Piece") {
      pieces.emplace_back();
    } else if (tag.name == "DataArray" && !pieces.empty()) {
      readArray(file, section, tag, pieces.back());
    } else if (tag.name == "Points" || tag.name == "Cells" || tag.name == "CellData" ||
               tag.name == "PointData") {
      section = tag.name;
    }
  }
  file.require(!pieces.empty(), "has no piece");
  return pieces;
}

class Vtu final : public MeshFormat
{
public:
  std::vector<std::string> endings() const override { return {".vtu"}; }
  std::vector<FormatOption> ownOptions() const override { return vtkOptions(); }
  AnyMesh read(std::string const& file_name, ReadOptions const& options) const override
  {
    const auto where = "Mesh file '" + file_name + "'";
    return meshOf(joined(piecesOf(file_name), where), options, where);
  }
};

class Pvtu final : public MeshFormat
{
public:
  std::vector<std::string> endings() const override { return {".pvtu"}; }
  std::vector<FormatOption> ownOptions() const override { return vtkOptions(); }
  AnyMesh read(std::string const& file_name, ReadOptions const& options) const override
  {
    const VtkXml file(file_name, "PUnstructuredGrid");
    const auto folder = std::filesystem::path(file_name).parent_path();
    std::vector<VtkGrid> pieces;
    for (auto tag = file.next(0); !tag.name.empty(); tag = file.next(tag.end)) {
      if (tag.name == "Piece") {
        const auto source = tag.attribute("Source");
        file.require(!source.empty(), "has a piece without Source, the name of its file");
        auto more = piecesOf((folder / source).string());
        std::move(more.begin(), more.end(), std::back_inserter(pieces));
      }
    }
    file.require(!pieces.empty(), "names no pieces");
    return meshOf(joined(std::move(pieces), file.where()), options, file.where());
  }
};
} // namespace

ASPERITY_REGISTER(MeshFormatRegistry, "VTU", Vtu)
ASPERITY_REGISTER(MeshFormatRegistry, "VTU in several files", Pvtu)
} // namespace asperity::geometry
