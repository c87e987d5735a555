#pragma once

#include "io/Output.hpp"
#include "unit/io/Support.hpp"

#include <Teuchos_Array.hpp>

#include <functional>

namespace asperity::test
{
// A strip, or a block, with fields that are functions of place and time, for outputs to look at.
struct Stage
{
  using Function = std::function<double(double const* x, int component)>;

  explicit Stage(int num_base) { locate(stripMesh(num_base)); }
  explicit Stage(Mesh<3> const& mesh) { locate(mesh); }

  template <int Dim>
  void locate(Mesh<Dim> const& mesh)
  {
    locations["fault"] = io::boundaryLocation("fault", mesh, "base", world());
    locations["volume"] = io::volumeLocation(mesh, world());
  }

  void add(std::string const& location, std::string const& name, int components,
           Function const& function)
  {
    io::Location const& nodes = locations.at(location);
    fields.add({name, "1", "Test.", location, components,
                [components, function, &nodes](std::vector<double>& values) {
                  values.clear();
                  for (std::size_t i = 0; i < nodes.numOwned(); ++i) {
                    for (int c = 0; c < components; ++c) {
                      values.push_back(function(&nodes.coordinates[nodes.dimension * i], c));
                    }
                  }
                }});
  }

  io::OutputContext context(std::filesystem::path const& directory,
                            io::TextFormat const& text = {}) const
  {
    return {directory, world(), fields, locations, text};
  }

  io::StepInfo at(int step, double step_size, bool is_last = false)
  {
    time = step * step_size;
    return {step, time, step_size, 0, is_last};
  }

  double time = 0;
  io::FieldRegistry fields;
  std::map<std::string, io::Location> locations;
};

inline io::TextFormat textFormat(io::Platform platform)
{
  io::TextFormat format;
  format.platform = platform;
  format.problem = "BP1-QD";
  format.author = "A. Modeller";
  format.date = "2024/05/31";
  format.code_version = "1.2";
  format.element_size = 50;
  format.time_step = 0.25;
  return format;
}

// As a deck has it.
inline Teuchos::Array<double> position(std::vector<double> const& coordinates)
{
  return coordinates;
}

// The lines of a file that do not begin with '#'.
inline std::vector<std::string> dataLines(std::filesystem::path const& file)
{
  std::vector<std::string> lines;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] != '#') {
      lines.push_back(line);
    }
  }
  return lines;
}
} // namespace asperity::test
