#include "scenario/OutputFields.hpp"

#include "base/parallel/Reductions.hpp"
#include "catalogue/stress/CoulombPlanes.hpp"
#include "catalogue/stress/StressFields.hpp"
#include "dynamics/FaultProcess.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "scenario/setup/FaultNodes.hpp"
#include "scenario/setup/friction/LawSetup.hpp"

#include <cmath>

namespace asperity::scenario
{
namespace
{
using Values = std::vector<double>;

using dynamics::FaultSample;

// What decks say about friction, of which fields follow.
struct GivenFriction
{
  bool has_state, has_normal_stress;
};

void registerFaultFields(io::FieldRegistry& registry, RunView const& view,
                         GivenFriction const& given)
{
  struct Quantity
  {
    char const* name;
    char const* unit;
    std::string meaning;
    int components;
    Values const& (FaultSample::*values)() const;
  };
  const int components = view.fault->numComponents();
  const std::string direction = components == 1 ? " along the tangent." : " along the axes.";
  const Quantity slip_velocity = {"slip_velocity", "m/s", "Slip rate as a vector," + direction,
                                  components, &FaultSample::slipVelocity};
  std::vector<Quantity> quantities = {
    {"slip_rate", "m/s", "Magnitude of the slip rate.", 1, &FaultSample::slipRate},
    {"slip", "m", "Tangential slip since the start," + direction, components, &FaultSample::slip},
    {"traction", "Pa", "Shear traction that friction bears," + direction, components,
     &FaultSample::traction}};
  if (given.has_state) {
    quantities.push_back({"alpha", "", "State ln(theta V* / L).", 1, &FaultSample::alpha});
  }
  if (given.has_normal_stress) {
    quantities.push_back({"normal_stress", "Pa", "Normal stress, positive in compression.", 1,
                          &FaultSample::normalStress});
  }
  if (components > 1) {
    quantities.push_back(slip_velocity);
  }
  for (auto const& quantity : quantities) {
    registry.add(io::OutputField{
      quantity.name, quantity.unit, quantity.meaning, "fault", quantity.components,
      [&view, get = quantity.values](Values& values) { values = (view.fault->*get)(); }});
  }
}

// The fields that processes on the fault have added to the state or compute from it, and the normal
// stress less the pressure of fluids.
void registerAddedFields(io::FieldRegistry& registry, dynamics::State const& initial,
                         dynamics::Fault const& fault, RunView const& view)
{
  for (auto const& field : initial.added) {
    auto const info = field.info;
    registry.add(io::OutputField{
      info->name, info->unit, "The " + info->quantity + ".", "fault", 1,
      [&view, name = info->name](Values& values) { values = toVector(view.state->at(name)); }});
  }
  for (auto const& process : fault.processes()) {
    for (auto const& field : process->observed()) {
      auto const& info = field.info;
      auto const axes = field.components > 1 ? ", along the axes." : ".";
      registry.add(io::OutputField{
        info.name, info.unit, "The " + info.quantity + axes, "fault", field.components,
        [&view, process, get = field.values](Values& values) { values = get(*view.state); }});
    }
  }
  if (!initial.added.empty()) {
    registry.add(io::OutputField{
      "effective_normal_stress", "Pa", "Normal stress less the pressure of fluids.", "fault", 1,
      [&view](Values& values) { values = view.fault->effectiveStress(); }});
  }
}

// Fields that do not change in time.
template <int Dim>
void registerFaultConstants(io::FieldRegistry& registry, Problem<Dim> const& problem)
{
  auto const add = [&registry](char const* name, char const* unit, char const* meaning,
                               Values const& constant) {
    registry.add(io::OutputField{name, unit, meaning, "fault", 1,
                                 [constant](Values& values) { values = constant; }});
  };
  Values shear_modulus;
  for (auto const& material : problem.fault_materials) {
    shear_modulus.push_back(material.shear_modulus);
  }
  add("shear_modulus", "Pa", "Shear modulus of the body beside the fault.", shear_modulus);
  Values prescribed, given;
  for (int node = 0; node < problem.surface().numNodes(); ++node) {
    prescribed.push_back(problem.surface().slides(node) ? 0 : 1);
    given.push_back((problem.surface())[node].has_given_slip ? 1 : 0);
  }
  add("prescribed", "", "1 where the slip rate is prescribed, 0 where friction decides on it.",
      prescribed);
  if (!problem.discretisation.boundary.given_slip.empty()) {
    add("given_slip", "", "1 on faults whose slip is prescribed, 0 on faults with friction.",
        given);
  }
}

// theta, for state laws that declare how it follows from alpha, and psi, for friction laws that
// depend on it.
template <int Dim>
void registerState(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                   ParameterList const& friction)
{
  auto const nodes = faultNodes(problem.mesh(), problem.surface());
  auto const reference = referenceFriction(friction, nodes);
  auto const effects = sensitivities(friction, nodes);
  if (reference && effects) {
    registry.add(
      io::OutputField{"psi", "", "State psi = mu* + b alpha.", "fault", 1,
                      [&view, reference = *reference, effects = *effects](Values& values) {
                        values = view.fault->alpha();
                        for (std::size_t i = 0; i < values.size(); ++i) {
                          values[i] = reference[i] + effects[i].state * values[i];
                        }
                      }});
  }
  if (auto const scale = thetaScales(friction, nodes)) {
    registry.add(io::OutputField{"theta", "s", "State variable.", "fault", 1,
                                 [&view, scale = *scale](Values& values) {
                                   values = view.fault->alpha();
                                   for (std::size_t i = 0; i < scale.size(); ++i) {
                                     values[i] = scale[i] * std::exp(values[i]);
                                   }
                                 }});
  }
}

template <int Dim>
dynamics::VertexMotion vertexMotion(Problem<Dim> const& problem, RunView const& view,
                                    std::vector<int> const& vertices,
                                    std::shared_ptr<dynamics::RecoveryRows> const& rows = nullptr)
{
  constexpr bool with_ghosts = false;
  return {problem.model.body, problem.discretisation.frames(),
          vertices,           with_ghosts,
          view.condensation,  rows};
}

catalogue::VertexMotion motionAt(dynamics::VertexMotion const& vertices,
                                 dynamics::State const& state, bool with_velocity)
{
  catalogue::VertexMotion motion = {
    vertices(*state.u), with_velocity ? vertices(*state.v) : Values(), {}};
  for (auto const& branch : state.branches) {
    motion.branches.push_back(vertices(*branch));
  }
  return motion;
}

// Displacement, velocity and acceleration, along the axes, at the vertices of a domain.
template <int Dim>
void registerMotion(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    io::OutputDomain const& domain)
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
    io::OutputField field{motion.name,
                          motion.unit,
                          motion.description,
                          domain.name,
                          problem.components(),
                          [&problem, &view, &domain, vector](Values& values) {
                            values =
                              vertexMotion(problem, view, domain.vertices)(*(view.state->*vector));
                          }};
    if (view.recovery_rows) {
      field.at = [&problem, &view, &domain, vector](std::vector<std::size_t> const& places) {
        std::vector<int> vertices;
        for (const std::size_t place : places) {
          vertices.push_back(domain.vertices[place]);
        }
        return io::OutputField::Values(
          [&view, vector, at = vertexMotion(problem, view, vertices, view.recovery_rows)](
            Values& values) { values = at(*(view.state->*vector)); });
      };
    }
    registry.add(std::move(field));
  }
}

// dimension: of space.
void registerScalars(io::FieldRegistry& registry, RunView const& view, int dimension,
                     bool has_yielding_rock)
{
  auto const add = [&](char const* name, char const* unit, char const* meaning, auto value) {
    registry.add(io::OutputScalar{name, unit, meaning, value});
  };
  auto const count = [&](char const* name, char const* meaning,
                         std::int64_t dynamics::SolveCount::*member) {
    add(name, "", meaning, [&view, member] { return static_cast<double>(view.count.*member); });
  };
  add("fixed_point_iterations", "", "Fixed-point iterations of the accepted step.",
      [&view] { return static_cast<double>(view.step.iterations); });
  add("error", "", "Estimated error of the step, in the norm of the step control.",
      [&view] { return view.step.error; });
  count("coupled_steps", "Steps solved to find the accepted one.",
        &dynamics::SolveCount::coupled_steps);
  count("rate_problems", "Rate problems: one for each iteration of the fixed point.",
        &dynamics::SolveCount::rate_problems);
  count("tnnmg_iterations", "TNNMG iterations of all rate problems.",
        &dynamics::SolveCount::tnnmg_iterations);
  count("corrections", "Linear corrections of TNNMG.", &dynamics::SolveCount::corrections);
  count("correction_iterations", "Iterations of conjugate gradients in the corrections.",
        &dynamics::SolveCount::correction_iterations);
  count("v_cycles", "Multigrid cycles.", &dynamics::SolveCount::v_cycles);
  count("energy_rises", "Sweeps and corrections of TNNMG in which J grew; must be 0.",
        &dynamics::SolveCount::rises);
  count("failed_steps", "Steps that could not be solved.", &dynamics::SolveCount::failures);
  if (view.floor_count && view.floor_count->matters()) {
    add("share_on_floor", "", "Part of the fault whose normal stress is on its floor.",
        [&view] { return view.floor_count->share(); });
  }

  auto const energy = [&](char const* name, char const* meaning, double dynamics::Energy::*member) {
    // Slip and moment, in contrast, are those of the whole fault.
    auto const description = meaning + std::string(" With an antisymmetric fault: of the half "
                                                   "that is modelled.");
    registry.add(io::OutputScalar{name, dimension == 2 ? "J/m" : "J", description,
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
  if (has_yielding_rock) {
    energy("inelastic_work", "Energy dissipated by rock that yields since the start.",
           &dynamics::Energy::inelastic_work);
  }
  energy("numerical_dissipation", "Energy dissipated by the time integrator since the start.",
         &dynamics::Energy::numerical_dissipation);
  energy("energy_defect", "Defect of the energy balance since the start.",
         &dynamics::Energy::defect);
}
// Returns what local cells have yielded: zero in elastic cells, empty if no cell can yield.
template <int Dim>
std::function<catalogue::YieldedStrain(std::vector<int> const&)>
yieldedStrain(Problem<Dim> const& problem, RunView const& view)
{
  auto const cells = problem.model.body.cells;
  if (!cells) {
    return {};
  }
  std::vector<int> rows(problem.mesh().cells.size(), -1);
  for (int row = 0; row < cells->numCells(); ++row) {
    rows[cells->sharing().cells()[row]] = row;
  }
  return [rows, columns = cells->history(), &view](std::vector<int> const& of_cells) {
    auto const strain = toHost(view.state->inelastic->strain);
    auto const shear = toHost(view.state->inelastic->shear);
    auto const history = toHost(view.state->inelastic->history);
    catalogue::YieldedStrain result;
    for (auto const& each : columns) {
      auto& values = result.history[each.variable.name];
      for (const int cell : of_cells) {
        for (int k = each.first; k < each.first + each.width; ++k) {
          values.push_back(rows[cell] < 0 ? 0 : history(rows[cell], k));
        }
      }
    }
    for (const int cell : of_cells) {
      for (int k = 0; k < strain.extent_int(1); ++k) {
        result.strain.push_back(rows[cell] < 0 ? 0 : strain(rows[cell], k));
      }
      result.shear.push_back(rows[cell] < 0 ? 0 : shear(rows[cell], 0));
    }
    return result;
  };
}

template <int Dim>
io::OutputDomain faultDomain(Problem<Dim> const& problem)
{
  auto fault =
    io::boundaryDomain("fault", problem.mesh(), problem.surface().name(), problem.communicator);
  io::nameParts(fault, problem.mesh(), problem.discretisation.boundary.faults);
  double rise = 0; // of the normals, out of the plus side
  for (auto const& node : problem.surface()) {
    rise += node.weight * node.normal[1];
  }
  const double rounding = 1e-6 * problem.surface().totalWeight(); // of a vertical fault
  fault.is_foot_wall = Dim == 2 && sumOverRanks(rise, *problem.communicator) > rounding;
  return fault;
}
} // namespace

template <int Dim>
std::map<std::string, io::OutputDomain> makeDomains(Problem<Dim> const& problem)
{
  std::map<std::string, io::OutputDomain> domains;
  if (problem.surface().numGlobalNodes() > 0) {
    domains.emplace("fault", faultDomain(problem));
  }
  domains.emplace("volume", io::volumeDomain(problem.mesh(), problem.communicator));
  if (!problem.discretisation.boundary.surface.empty()) {
    domains.emplace("surface", io::boundaryDomain("surface", problem.mesh(),
                                                  problem.discretisation.boundary.surface,
                                                  problem.communicator));
  }
  return domains;
}

template <int Dim>
void registerFields(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    std::map<std::string, io::OutputDomain> const& domains,
                    ParameterList const& friction)
{
  if (domains.count("fault") > 0) {
    registerFaultFields(
      registry, view,
      {hasState(friction), bearsFriction(friction) || isGiven(friction, "Normal Stress")});
    registerState(registry, problem, view, friction);
    registerAddedFields(registry, problem.model.initial, problem.model.fault, view);
    registerFaultConstants(registry, problem);
  }
  for (auto const& [name, domain] : domains) {
    registerMotion(registry, problem, view, domain);
  }
  registerScalars(registry, view, Dim, problem.model.body.cells != nullptr);
}

template <int Dim>
void registerStress(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    std::map<std::string, io::OutputDomain> const& domains,
                    ParameterList const& output)
{
  auto const observe = [&problem, &view](std::vector<int> const& vertices, bool are_few) {
    constexpr bool with_ghosts = true;
    auto const& frames = problem.discretisation.frames();
    const dynamics::VertexMotion now(problem.model.body, frames, vertices, with_ghosts,
                                     view.condensation, are_few ? view.recovery_rows : nullptr);
    const dynamics::VertexMotion initial(problem.model.body, frames, vertices, with_ghosts);
    return catalogue::VertexMotions{
      [=, &view](bool with_velocity) { return motionAt(now, *view.state, with_velocity); },
      [=, &problem](bool with_velocity) {
        return motionAt(initial, problem.model.initial, with_velocity);
      }};
  };
  const catalogue::StressedBody<Dim> body{problem.mesh(),
                                          problem.components(),
                                          problem.discretisation.rock.materials,
                                          problem.discretisation.rock.branches,
                                          problem.discretisation.patches,
                                          problem.discretisation.boundary.surface,
                                          observe,
                                          yieldedStrain(problem, view),
                                          problem.model.body.cells
                                            ? problem.model.body.cells->history()
                                            : std::vector<fem::HistoryColumns>()};
  auto const planes = catalogue::coulombPlanes(output, Dim);
  for (auto const& [name, domain] : domains) {
    if (name != "fault") {
      catalogue::registerStressFields(registry, domain, body, planes);
    }
  }
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::map<std::string, io::OutputDomain> makeDomains(Problem<Dim> const&);               \
  template void registerFields(io::FieldRegistry&, Problem<Dim> const&, RunView const&,            \
                               std::map<std::string, io::OutputDomain> const&,                     \
                               ParameterList const&);                                              \
  template void registerStress(io::FieldRegistry&, Problem<Dim> const&, RunView const&,            \
                               std::map<std::string, io::OutputDomain> const&,                     \
                               ParameterList const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
