#pragma once

#include "base/parallel/Reductions.hpp"
#include "hdf5/File.hpp"
#include "io/Output.hpp"
#include "unit/io/Support.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <functional>

namespace asperity::test
{
// The largest `slip_rate` on the fault over all ranks where it is not `prescribed`; 0 without the
// field. Collective.
inline double peakSlipRate(io::FieldRegistry const& fields)
{
  double largest = 0;
  if (fields.hasField("fault", "slip_rate")) {
    std::vector<double> rates;
    fields.field("fault", "slip_rate").values(rates);
    std::vector<double> prescribed(rates.size(), 0);
    if (fields.hasField("fault", "prescribed")) {
      fields.field("fault", "prescribed").values(prescribed);
    }
    for (std::size_t i = 0; i < rates.size(); ++i) {
      largest = std::max(largest, prescribed[i] != 0 ? 0 : rates[i]);
    }
  }
  return maxOverRanks(largest, *world());
}

// A strip, or a block, with fields that are functions of place and time, for outputs to look at.
struct Stage
{
  using Function = std::function<double(double const* x, int component)>;

  explicit Stage(int num_base) : Stage(stripMesh(num_base)) {}

  template <int Dim>
  explicit Stage(Mesh<Dim> const& mesh)
  {
    domains["fault"] = io::boundaryDomain("fault", mesh, "base", world());
    domains["volume"] = io::volumeDomain(mesh, world());
  }

  void add(std::string const& domain, std::string const& name, int components,
           Function const& function)
  {
    io::OutputDomain const& nodes = domains.at(domain);
    fields.add({name, "1", "Test.", domain, components,
                [components, function, &nodes](std::vector<double>& values) {
                  values.clear();
                  for (std::size_t i = 0; i < nodes.numOwned(); ++i) {
                    for (int c = 0; c < components; ++c) {
                      values.push_back(function(&nodes.coordinates[nodes.dimension * i], c));
                    }
                  }
                }});
  }

  io::OutputContext context(std::filesystem::path const& directory) const
  {
    return {directory, world(), fields, domains};
  }

  io::StepInfo at(int step, double step_size, bool is_last = false)
  {
    time = step * step_size;
    return {step, time, step_size, peakSlipRate(fields), is_last};
  }

  double time = 0;
  io::FieldRegistry fields;
  std::map<std::string, io::OutputDomain> domains;
};

// As a deck has it.
inline Teuchos::Array<double> position(std::vector<double> const& coordinates)
{
  return coordinates;
}

inline std::vector<double> readNumbers(std::filesystem::path const& file,
                                       std::string const& dataset)
{
  return h5::File::open(file).openDataset(dataset).read<double>();
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
