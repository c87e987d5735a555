#pragma once

#include "dynamics/fault/Fault.hpp"

namespace asperity::dynamics
{
// Over what a regularised normal stress follows the effective one, at the nodes (num_nodes).
struct RegularisationScales
{
  std::vector<double> slip_distance; // L_pc [m], above zero; infinity: slip does nothing
  std::vector<double> time;          // T_pc [s], above zero; infinity: time does nothing
};

// The law of Prakash and Clifton in its simplified form (Prakash 1998; Cochard and Rice 2000;
// Rubin and Ampuero 2007): in place of the effective normal stress sigma friction takes s >= 0,
//
//   ds/dt = (V / L_pc + 1 / T_pc) (sigma - s),   s = sigma at the start,
//
// V the slip rate. SCEC's -(V + V_ref) (s - sigma) / L has T_pc = L / V_ref. A step has the exact s
// of its mean V and of a sigma that is linear in time. s is an unknown of the step, an added field
// of the state, `regularised_normal_stress`, and an output.
//
// sigma is what the processes `before` leave of State::sigma_n. So this acts after all others and
// is not registered with them: `Normal Stress Change` of a deck chooses it, and it becomes
// FaultLaws::regularisation. The surface must outlive this.
std::shared_ptr<const FaultProcess> makeRegularisedStress(fem::FaultSurface const& surface,
                                                          RegularisationScales const& scales,
                                                          FaultProcesses before);
} // namespace asperity::dynamics
