#include "scenario/fields/RunScalars.hpp"

namespace asperity::scenario
{
void registerScalars(io::FieldRegistry& registry, RunView const& view, int dimension,
                     bool has_yielding_rock, bool may_open)
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
  count("energy_increases", "Sweeps and corrections of TNNMG in which J grew; must be 0.",
        &dynamics::SolveCount::energy_increases);
  count("failed_steps", "Steps that could not be solved.", &dynamics::SolveCount::failures);
  if (view.floor_count && view.floor_count->matters()) {
    add("share_on_floor", "", "Part of the fault whose normal stress is on its floor.",
        [&view] { return view.floor_count->share(); });
  }
  if (may_open) {
    add("share_open", "", "Part of the fault that is open.",
        [&view] { return view.fault->shareOpen(); });
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
  if (may_open) {
    energy("contact_work",
           "Energy dissipated where the sides of the fault meet or part since the start.",
           &dynamics::Energy::contact_work);
  }
  energy("numerical_dissipation", "Energy dissipated by the time integrator since the start.",
         &dynamics::Energy::numerical_dissipation);
  energy("energy_defect", "Defect of the energy balance since the start.",
         &dynamics::Energy::defect);
}
} // namespace asperity::scenario
