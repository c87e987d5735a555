#include "scenario/OutputFields.hpp"

#include "scenario/NodalField.hpp"

#include <cmath>

namespace asperity::scenario
{
namespace
{
using Values = std::vector<double>;

std::vector<double> tangential(Vector const& x, dynamics::Fault const& fault)
{
  auto const values = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<double> result;
  for (auto const& node : fault.dofs) {
    for (int dof : node) {
      result.push_back(values(dof, 0));
    }
  }
  return result;
}

void registerFaultFields(io::FieldRegistry& registry, Problem const& problem, RunView const& view)
{
  auto const& fault = problem.fault;
  const int size = fault.num_tangents;
  auto const initial = tangential(*problem.initial.u, fault);
  auto const magnitude = [&fault, size](Values const& blocks) {
    Values result(fault.numNodes());
    for (int node = 0; node < fault.numNodes(); ++node) {
      double square = 0;
      for (int k = 0; k < size; ++k) {
        square += blocks[node * size + k] * blocks[node * size + k];
      }
      result[node] = size == 1 ? std::abs(blocks[node]) : std::sqrt(square);
    }
    return result;
  };
  registry.add(io::Field{"slip_rate", "m/s", "Magnitude of the slip rate.", "fault", 1,
                         [&fault, &view, magnitude](Values& values) {
                           values = magnitude(tangential(*view.state->v, fault));
                           for (double& value : values) {
                             value *= fault.slip_factor;
                           }
                         }});
  registry.add(io::Field{
    "alpha", "", "State ln(theta V* / L).", "fault", 1, [&view](Values& values) {
      auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view.state->alpha);
      values.assign(host.data(), host.data() + host.extent(0));
    }});
  registry.add(io::Field{"slip", "m",
                         "Tangential slip since the start, along the tangents of the fault.",
                         "fault", size, [&fault, &view, initial](Values& values) {
                           values = tangential(*view.state->u, fault);
                           for (std::size_t i = 0; i < values.size(); ++i) {
                             values[i] = fault.slip_factor * (values[i] - initial[i]);
                           }
                         }});
  registry.add(io::Field{
    "traction", "Pa", "Shear traction that friction bears, along the tangents of the fault.",
    "fault", size, [&fault, &view, size](Values& values) {
      values = tangential(view.balance->force(), fault);
      auto const weight =
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fault.data.weight);
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] /= weight(i / size);
      }
    }});
  registry.add(io::Field{"normal_stress", "Pa", "Normal stress, positive in compression.", "fault",
                         1, [&fault](Values& values) {
                           auto const host = Kokkos::create_mirror_view_and_copy(
                             Kokkos::HostSpace(), fault.data.sigma_n);
                           values.assign(host.data(), host.data() + host.extent(0));
                         }});
}

// What does not change in time.
void registerFaultConstants(io::FieldRegistry& registry, Problem const& problem)
{
  auto const add = [&registry](char const* name, char const* unit, char const* meaning,
                               Values const& constant) {
    registry.add(io::Field{name, unit, meaning, "fault", 1,
                           [constant](Values& values) { values = constant; }});
  };
  Values shear_modulus;
  for (auto const& material : problem.fault_materials) {
    shear_modulus.push_back(material.shear_modulus);
  }
  add("shear_modulus", "Pa", "Shear modulus of the body beside the fault.", shear_modulus);
  add("prescribed", "", "1 where the slip rate is prescribed, 0 where friction decides on it.",
      Values(problem.fault.fixed.begin(), problem.fault.fixed.end()));
}

// theta = L / V* exp(alpha), for state laws that have these two.
void registerTheta(io::FieldRegistry& registry, Problem const& problem, RunView const& view,
                   ParameterList const& friction)
{
  char const* const distance = "L";
  char const* const rate = "Reference Slip Rate";
  if (!isGiven(friction, distance) || !isGiven(friction, rate)) {
    return;
  }
  auto const valuesOf = [&](char const* name) {
    return nodalValues(friction, name, "Asperity / Friction", problem.mesh,
                       problem.fault_nodes.nodes);
  };
  Values scale = valuesOf(distance);
  auto const reference = valuesOf(rate);
  for (std::size_t i = 0; i < scale.size(); ++i) {
    scale[i] /= reference[i];
  }
  registry.add(
    io::Field{"theta", "s", "State variable.", "fault", 1, [&view, scale](Values& values) {
                auto const alpha =
                  Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view.state->alpha);
                values.resize(scale.size());
                for (std::size_t i = 0; i < scale.size(); ++i) {
                  values[i] = scale[i] * std::exp(alpha(i));
                }
              }});
}

// Displacement, velocity and acceleration, along the axes, at the vertices of a location.
void registerMotion(io::FieldRegistry& registry, Problem const& problem, RunView const& view,
                    io::Location const& location)
{
  struct Motion
  {
    char const* name;
    char const* unit;
    char const* description;
    RCP<Vector> dynamics::State::*vector;
  };
  static const Motion motions[] = {
    {"displacement", "m", "Displacement along the axes.", &dynamics::State::u},
    {"velocity", "m/s", "Velocity along the axes.", &dynamics::State::v},
    {"acceleration", "m/s^2", "Acceleration along the axes.", &dynamics::State::a}};
  for (auto const& motion : motions) {
    auto const vector = motion.vector;
    registry.add(
      io::Field{motion.name, motion.unit, motion.description, location.name, problem.components,
                [&problem, &view, &location, vector](Values& values) {
                  Values all;
                  problem.alongAxes(*(view.state->*vector), all);
                  const int components = problem.components;
                  values.clear();
                  for (int vertex : location.vertices) {
                    for (int c = 0; c < components; ++c) {
                      values.push_back(all[static_cast<std::size_t>(vertex) * components + c]);
                    }
                  }
                }});
  }
}

void registerScalars(io::FieldRegistry& registry, RunView const& view)
{
  auto const add = [&](char const* name, char const* unit, char const* meaning, auto value) {
    registry.add(io::Scalar{name, unit, meaning, value});
  };
  auto const count = [&](char const* name, char const* meaning,
                         std::int64_t dynamics::SolveCount::*member) {
    add(name, "", meaning, [&view, member] { return static_cast<double>(view.count.*member); });
  };
  add("fixed_point_iterations", "", "Of the step that was accepted.",
      [&view] { return static_cast<double>(view.step.iterations); });
  add("error", "", "Estimated error of alpha over the fault, in the norm of the step control.",
      [&view] { return view.step.error; });
  count("coupled_steps", "Steps solved to find the accepted one.",
        &dynamics::SolveCount::coupled_steps);
  count("rate_problems", "Rate problems solved.", &dynamics::SolveCount::rate_problems);
  count("tnnmg_iterations", "Of all rate problems.", &dynamics::SolveCount::tnnmg_iterations);
  count("corrections", "Linear corrections.", &dynamics::SolveCount::corrections);
  count("correction_iterations", "Conjugate gradients in the corrections.",
        &dynamics::SolveCount::correction_iterations);
  count("v_cycles", "Multigrid cycles.", &dynamics::SolveCount::v_cycles);
  count("energy_rises", "Half iterations of TNNMG after which J was larger.",
        &dynamics::SolveCount::rises);
  count("failed_steps", "Steps that could not be solved.", &dynamics::SolveCount::failures);

  auto const energy = [&](char const* name, char const* meaning, double dynamics::Energy::*member) {
    // Slip and moment are those of the whole fault.
    auto const description = meaning + std::string(" With an antisymmetric fault: of the half "
                                                   "that is modelled.");
    registry.add(io::Scalar{name, "J/m", description,
                            [&view, member] { return view.balance->energy().*member; }});
  };
  energy("kinetic_energy", "Kinetic energy.", &dynamics::Energy::kinetic);
  energy("elastic_energy", "Elastic energy.", &dynamics::Energy::elastic);
  energy("load_work", "Work of gravity and tractions since the start.",
         &dynamics::Energy::load_work);
  energy("boundary_work", "Work of the prescribed boundaries since the start.",
         &dynamics::Energy::boundary_work);
  energy("friction_work", "Energy dissipated by friction since the start.",
         &dynamics::Energy::friction_work);
  energy(
    "viscous_work",
    "Energy dissipated by viscosity, radiation damping and absorbing boundaries since the start.",
    &dynamics::Energy::viscous_work);
  energy("numerical_dissipation", "Energy dissipated by the time integrator since the start.",
         &dynamics::Energy::numerical_dissipation);
  energy("energy_defect", "What is missing in the balance of energy since the start.",
         &dynamics::Energy::defect);
}
} // namespace

std::map<std::string, io::Location> makeLocations(Problem const& problem)
{
  std::map<std::string, io::Location> locations;
  locations.emplace("fault", io::boundaryLocation("fault", problem.mesh, problem.boundary.fault,
                                                  problem.communicator));
  locations.emplace("volume", io::volumeLocation(problem.mesh, problem.communicator));
  if (!problem.boundary.surface.empty()) {
    locations.emplace("surface",
                      io::boundaryLocation("surface", problem.mesh, problem.boundary.surface,
                                           problem.communicator));
  }
  return locations;
}

void registerFields(io::FieldRegistry& registry, Problem const& problem, RunView const& view,
                    std::map<std::string, io::Location> const& locations,
                    ParameterList const& friction)
{
  registerFaultFields(registry, problem, view);
  registerTheta(registry, problem, view, friction);
  registerFaultConstants(registry, problem);
  for (auto const& [name, location] : locations) {
    registerMotion(registry, problem, view, location);
  }
  registerScalars(registry, view);
}
} // namespace asperity::scenario
