#pragma once

#include "dynamics/State.hpp"
#include "fem/FaultMesh.hpp"
#include "fem/FaultSurface.hpp"
#include "parameters/Kind.hpp"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace asperity::dynamics
{
class StepUnknown;

// What a process computes from its fields for outputs: values(state) gives (num_nodes, components).
struct ObservedField
{
  FieldInfo info;
  int components = 1;
  std::function<std::vector<double>(State const&)> values; // collective
};

// A process on the fault other than friction, its state and the normal stress, such as a fluid
// pressure or a second state variable: it adds fields to the state of a run and unknowns to the
// fixed point of a step, and changes what friction depends on.
class FaultProcess
{
public:
  virtual ~FaultProcess() = default;

  // Its fields at the start of a run, which has all other fields but alpha; outputs know them by
  // their names. A field that is an unknown is guessed (FieldInfo::is_guessed); the others follow
  // when a step is complete (StepUnknown::complete).
  virtual std::vector<State::Added> fields(State const& start) const = 0;
  // What each step has to find of them; a KnownField is known when the step begins.
  virtual std::vector<std::shared_ptr<StepUnknown>> unknowns() const = 0;
  // Changes alpha and sigma_n(num_nodes), those of the state or what other processes have made of
  // them, to what friction takes. sigma_n stays >= 0.
  virtual void act(State const& state, NodeView const& alpha, NodeView const& sigma_n) const = 0;

  // p(num_nodes) += the pressure [Pa] that act() subtracts from sigma_n: it parts the sides of a
  // fault that may open.
  virtual void addPressure(State const& state, NodeView const& p) const
  {
    static_cast<void>(state), static_cast<void>(p);
  }

  virtual std::vector<ObservedField> observed() const { return {}; }

  // Lines for the log about what it was made of. The same on all ranks.
  virtual std::vector<std::string> remarks() const { return {}; }

  // What alpha is for this process (friction/LawProperties.hpp); null: it works with any.
  virtual char const* stateVariable() const { return nullptr; }
};

// An entry of a deck that may change in time.
struct NodalFunction
{
  bool depends_on_time = false;
  std::function<std::vector<double>(double)> at; // its values (num_nodes) at a time [s]
};

// What a process is made of in addition to its parameters.
struct FaultProcessContext
{
  fem::FaultSurface const& surface; // lives as long as the process
  std::shared_ptr<const fem::FaultMesh> mesh;
  std::vector<std::array<double, 3>> places; // (num_nodes) [m], z = 0 in the plane
  // The values (num_nodes) of an entry that was declared as a field; a rank may throw alone.
  std::function<std::vector<double>(std::string const&)> values;
  std::function<NodalFunction(std::string const&)> values_in_time;
  std::string path; // of the list, for messages: "Asperity / Friction / Pore Pressure"
};

// Registered under the name of its list in the deck's list `Friction`, at the bottom of the file of
// the process; its parameters, `Enabled` among them, all have defaults:
//   ASPERITY_REGISTER(FaultProcessRegistry, "Pore Pressure", FaultProcessKindOf<PorePressure>)
struct FaultProcessKind : Kind<FaultProcess, FaultProcessContext>
{
  static constexpr char const* registered_as = "process on faults";
};
template <class Process>
using FaultProcessKindOf = KindOf<FaultProcessKind, Process>;
using FaultProcessRegistry = Registry<FaultProcessKind>;
} // namespace asperity::dynamics
