#include "scenario/fields/FaultFields.hpp"

#include "dynamics/FaultProcess.hpp"

#include <cmath>

namespace asperity::scenario
{
namespace
{
using Values = std::vector<double>;

using dynamics::FaultSample;

// The choices of a deck on which it depends which fields a fault has.
struct GivenFriction
{
  bool has_state, has_normal_stress, may_open;
  std::string state_variable; // of the law
};

void registerSample(io::FieldRegistry& registry, RunView const& view, GivenFriction const& given)
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
    quantities.push_back(
      {"alpha", "", "State: " + given.state_variable + ".", 1, &FaultSample::alpha});
  }
  if (given.has_normal_stress) {
    quantities.push_back({"normal_stress", "Pa", "Normal stress, positive in compression.", 1,
                          &FaultSample::normalStress});
  }
  if (components > 1) {
    quantities.push_back(slip_velocity);
  }
  if (given.may_open) {
    quantities.push_back(
      {"opening", "m", "Opening: how far the two sides are apart.", 1, &FaultSample::opening});
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
void registerState(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view)
{
  auto const reference = problem.laws.referenceFriction();
  auto const effects = problem.laws.sensitivities();
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
  if (auto const scale = problem.laws.thetaScales()) {
    registry.add(io::OutputField{"theta", "s", "State variable.", "fault", 1,
                                 [&view, scale = *scale](Values& values) {
                                   values = view.fault->alpha();
                                   for (std::size_t i = 0; i < scale.size(); ++i) {
                                     values[i] = scale[i] * std::exp(values[i]);
                                   }
                                 }});
  }
}
} // namespace

template <int Dim>
void registerFaultFields(io::FieldRegistry& registry, Problem<Dim> const& problem,
                         RunView const& view)
{
  auto const& laws = problem.laws.laws();
  registerSample(registry, view,
                 {laws.hasState(),
                  laws.hasFrictionLaw() || problem.settings.friction.gives_normal_stress,
                  problem.surface().mayOpen(), laws.frictionLaw().state_variable});
  registerState(registry, problem, view);
  registerAddedFields(registry, problem.model.initial, problem.model.fault, view);
  registerFaultConstants(registry, problem);
}

template void registerFaultFields(io::FieldRegistry&, Problem<2> const&, RunView const&);
template void registerFaultFields(io::FieldRegistry&, Problem<3> const&, RunView const&);
} // namespace asperity::scenario
