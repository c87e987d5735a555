#pragma once

#include "io/OutputSet.hpp"
#include "io/checkpoint/Checkpoint.hpp"
#include "unit/io/Stage.hpp"

#include <cmath>

namespace asperity::test
{
constexpr int num_base = 6, num_steps = 60;

// A body that shakes as a function of the time, with everything that the default outputs ask for.
struct Body
{
  Body()
  {
    const auto mesh = stripMesh(num_base);
    domains["fault"] = io::boundaryDomain("fault", mesh, "base", world());
    domains["surface"] =
      io::boundaryDomain("surface", mesh, "surface", world(), io::CurveStart::smaller_x);
    domains["volume"] = io::volumeDomain(mesh, world());
    addField("fault", "slip_rate", 1, [this](double x) { return rate(x); });
    addField("fault", "alpha", 1, [this](double x) { return x - time; });
    addField("fault", "slip", 1, [this](double x) { return time * x; });
    addField("fault", "traction", 1, [this](double x) { return 1e6 * x + time; });
    addField("fault", "normal_stress", 1, [](double x) { return 1e7 * x; });
    addField("fault", "theta", 1, [this](double x) { return std::exp(x - time); });
    addField("fault", "shear_modulus", 1, [](double) { return 3e10; });
    addField("surface", "displacement", 2, [this](double x) { return time + x; });
    addField("volume", "displacement", 2, [this](double x) { return time - x; });
    addField("volume", "velocity", 2, [](double x) { return 1 + x; });
    fields.add(io::OutputScalar{"fixed_point_iterations", "", "Test.",
                                [this] { return 2 + std::floor(time); }});
    fields.add(io::OutputScalar{"kinetic_energy", "J", "Test.", [this] { return time / 3; }});
  }

  double rate(double x) const { return std::exp(3 * std::sin(time) * (1 - x)); }

  void addField(std::string const& domain, std::string const& name, int components,
                std::function<double(double)> const& value)
  {
    io::OutputDomain const& nodes = domains.at(domain);
    fields.add({name, "1", "Test.", domain, components, [=, &nodes](std::vector<double>& values) {
                  values.clear();
                  for (std::size_t i = 0; i < nodes.numOwned(); ++i) {
                    values.insert(values.end(), components, value(nodes.coordinates[2 * i]));
                  }
                }});
  }

  io::StepInfo at(int step)
  {
    time = step / 4.0;
    return {step, time, 0.25, rate(0), step == num_steps, step / 8.0};
  }

  NodeSets nodeSets() const
  {
    NodeSets sets;
    for (auto const& [name, domain] : domains) {
      sets[name].assign(domain.node_numbers.begin(), domain.node_numbers.end());
    }
    return sets;
  }

  double time = 0;
  io::FieldRegistry fields;
  std::map<std::string, io::OutputDomain> domains;
};

inline void checkpoint(io::OutputSet& outputs, Body const& body,
                       std::filesystem::path const& directory)
{
  outputs.closeSegment();
  Archive archive;
  archive.insert("outputs", outputs.save());
  io::writeCheckpoint(directory / "checkpoint.h5", archive,
                      io::Fingerprint{{{"Asperity", "deck", ""}}}, *world(), body.nodeSets());
}

inline void steps(io::OutputSet& outputs, Body& body, std::filesystem::path const& directory,
                  int first, int end)
{
  for (int step = first; step < end; ++step) {
    outputs.write(body.at(step));
    if (step % 25 == 24) {
      checkpoint(outputs, body, directory);
    }
  }
}

inline void finish(io::OutputSet& outputs, Body const& body, std::filesystem::path const& directory)
{
  checkpoint(outputs, body, directory);
  outputs.finish();
}
} // namespace asperity::test
