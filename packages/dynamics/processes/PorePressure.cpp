// A fluid in a permeable fault, whose pressure diffuses along it and relieves the normal stress:
//
//   S w p_t = div(k w / eta grad p) + q,    sigma_eff = max(0, sigma - p)
//
// with the storage S (compressibility times porosity), the width w, the permeability k, the
// viscosity eta and the rates q of wells, on the surface of the fault. Darcy's velocity is
// -k / eta grad p. Where faults cross or join, all have one pressure, and what flows out of one
// flows into the others: S w p_t at such a point is the sum over its nodes (fem/FaultPoints.hpp).
//
// Where k changes (Permeability.hpp), each step has that of its middle: steps stay of second order,
// but for changes of sigma, which count from the step after.
#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/FaultProcess.hpp"
#include "dynamics/coupling/StepUnknown.hpp"
#include "dynamics/processes/DiffusionStep.hpp"
#include "dynamics/processes/EffectiveStress.hpp"
#include "dynamics/processes/Permeability.hpp"
#include "dynamics/processes/Wells.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/Parameters.hpp"

#include <algorithm>
#include <optional>

namespace asperity::dynamics
{
namespace
{
using NodalValues = std::vector<double>;
char const* const field_name = "pore_pressure";

// What flows into the nodes: distributed sources, and wells.
class Inflow
{
public:
  Inflow(Teuchos::ParameterList const& parameters, FaultProcessContext const& context)
      : communicator_(context.surface.communicator())
      , injection_(context.values_in_time("Injection"))
      , wells_(parameters.sublist("Wells"), joinPath(context.path, "Wells"), *context.mesh)
      , depends_on_time_(injection_.depends_on_time || wells_.dependOnTime())
  {
    for (auto const& node : context.surface) {
      weights_.push_back(node.weight);
    }
  }

  // (num_nodes) volume per time at a time [s]. Collective.
  NodalValues const& at(double t)
  {
    if (rates_.empty() || depends_on_time_) {
      onEveryRank(*communicator_, [&] {
        rates_ = injection_.at(t);
        for (std::size_t i = 0; i < rates_.size(); ++i) {
          rates_[i] *= weights_[i];
        }
        wells_.add(t, rates_);
      });
    }
    return rates_;
  }

  std::vector<std::string> const& remarks() const { return wells_.remarks(); }

private:
  RCP<const Communicator> communicator_;
  NodalFunction injection_;
  Wells wells_;
  bool depends_on_time_;
  NodalValues weights_, rates_;
};

class PorePressure : public FaultProcess
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning()
  {
    return "This list describes a fluid in the fault, whose pressure diffuses along it and "
           "reduces the normal stress. Permeability, Storage and Width are required with it.";
  }

  PorePressure(Teuchos::ParameterList const& parameters, FaultProcessContext const& context)
      : communicator_(context.surface.communicator())
      , inflow_(std::make_unique<Inflow>(parameters, context))
      , mesh_(context.mesh)
      , at_points_("asperity::dynamics::pressureAtPoints", mesh_->points().numPoints())
  {
    requireGiven(parameters, context.path);
    NodalValues permeability;
    Fixed fixed;
    onEveryRank(*communicator_, [&] {
      permeability = context.values("Permeability");
      permeability_.emplace(parameters, context, permeability);
      width_ = context.values("Width");
      viscosity_ = context.values("Fluid Viscosity");
      auto storage = context.values("Storage");
      auto const fixed_where = context.values("Fixed Where");
      for (std::size_t i = 0; i < storage.size(); ++i) {
        storage[i] *= width_[i] * context.surface[static_cast<int>(i)].weight;
        fixed.push_back(fixed_where[i] > 0);
      }
      storage_ = mesh_->points().sums(storage);
      start_ = mixed(context.values("Initial Pressure"), storage, fixed);
    });
    requireFixedNodes(fixed, parameters, context.path);
    is_fixed_ = atPoints(fixed);
    if (!permeability_->changes()) {
      diffusion_ = diffusionWith(permeability);
    }
  }

  std::vector<State::Added> fields(State const&) const override
  {
    constexpr bool is_guessed = true; // a step has found it before it is completed
    const NodeView p("asperity::dynamics::porePressure", start_.size());
    Kokkos::deep_copy(p, toDevice(start_, "asperity::dynamics::initialPressure"));
    auto all = permeability_->fields();
    all.push_back(
      {std::make_shared<FieldInfo>(FieldInfo{field_name, "pore pressure", "Pa", is_guessed}), p});
    return all;
  }

  // The pressure does not depend on the slip of the step, which has it from its beginning.
  std::vector<std::shared_ptr<StepUnknown>> unknowns() const override
  {
    auto all = permeability_->unknowns();
    all.push_back(std::make_shared<KnownField>(
      field_name, [this](StepStart const& start, NodeView const& p) { advance(start, p); }));
    return all;
  }

  std::vector<std::string> remarks() const override
  {
    auto lines = inflow_->remarks();
    if (const auto joints = mesh_->points().numJoints(); joints > 0) {
      lines.push_back("Pore fluid flows from one fault into another at " +
                      (joints == 1 ? "one place" : std::to_string(joints) + " places") +
                      " where they cross or join.");
    }
    return lines;
  }

  std::vector<ObservedField> observed() const override
  {
    return {
      {{"darcy_velocity", "volume of fluid that flows along the fault per time and area", "m/s"},
       mesh_->numCorners(),
       [this](State const& state) { return darcyVelocity(state); }},
      {{"permeability", "permeability along the fault", "m^2"}, 1, [this](State const& state) {
         return permeabilityOf(state);
       }}};
  }

  void act(State const& state, NodeView const&, NodeView const& sigma_n) const override
  {
    subtractPressure(sigma_n, state.at(field_name));
  }
  void addPressure(State const& state, NodeView const& p) const override
  {
    addToPressure(state.at(field_name), p);
  }

private:
  using Fixed = std::vector<bool>;

  static void requireGiven(Teuchos::ParameterList const& parameters, std::string const& path)
  {
    for (std::string const name : {"Permeability", "Storage", "Width"}) {
      ASPERITY_REQUIRE(parameters.isParameter(name) || parameters.isSublist(name),
                       joinPath(path, name) << " is missing: with Enabled = true it has to be "
                                               "given.");
    }
  }

  // The number 0, which is the default, says that there are none.
  void requireFixedNodes(Fixed const& fixed, Teuchos::ParameterList const& parameters,
                         std::string const& path) const
  {
    const auto mine = std::count(fixed.begin(), fixed.end(), true);
    const bool are_there = sumOverRanks(static_cast<std::int64_t>(mine), *communicator_) > 0;
    ASPERITY_REQUIRE(are_there || numberIn(parameters.getEntry("Fixed Where")),
                     joinPath(path, "Fixed Where")
                       << " = " << valueText(parameters.getEntry("Fixed Where"))
                       << " is above zero at no node of the fault, whose edges would all be "
                          "impermeable. Check its numbers against the places of the fault, allow "
                          "for rounding (abs(y + 40e3) < 1), or give 0.");
  }

  // A point is fixed if one of its nodes is.
  Fixed atPoints(Fixed const& of_nodes) const
  {
    auto const& points = mesh_->points();
    Fixed result(points.numPoints(), false);
    for (std::size_t node = 0; node < of_nodes.size(); ++node) {
      const int point = points[static_cast<int>(node)];
      result[point] = result[point] || of_nodes[node];
    }
    return result;
  }

  // (num_nodes) p after the fluid of all nodes of a point has mixed: the mean by their storage,
  // which keeps the volume. Where some of them are fixed, it is the mean of these.
  NodalValues mixed(NodalValues p, NodalValues weights, Fixed const& fixed) const
  {
    auto const& points = mesh_->points();
    auto const fixed_points = atPoints(fixed);
    for (std::size_t node = 0; node < p.size(); ++node) {
      if (fixed_points[points[static_cast<int>(node)]] && !fixed[node]) {
        weights[node] = 0;
      }
    }
    auto const means = points.means(p, weights);
    for (std::size_t node = 0; node < p.size(); ++node) {
      p[node] = means[points[static_cast<int>(node)]];
    }
    return p;
  }

  std::shared_ptr<DiffusionStep> diffusionWith(NodalValues const& permeability) const
  {
    auto conductivity = permeability; // k w / eta
    for (std::size_t i = 0; i < conductivity.size(); ++i) {
      conductivity[i] *= width_[i] / viscosity_[i];
    }
    return std::make_shared<DiffusionStep>(mesh_->stiffness(conductivity), storage_, is_fixed_);
  }

  // With the permeability in the middle of a step from a state. If that depends on the pressure,
  // the pressure there is the one after half a step with the permeability of the beginning;
  // `memory` is overwritten with it.
  std::shared_ptr<DiffusionStep> diffusionInMiddle(State const& from, double tau,
                                                   DiffusionStep::Sources const& q,
                                                   NodeView const& memory) const
  {
    auto const& before = from.at(field_name);
    if (!permeability_->dependsOnStress()) {
      return diffusionWith(permeability_->after(from, tau / 2, before));
    }
    diffuse(*diffusionWith(permeability_->after(from, 0, before)), tau / 2, before, q, memory);
    return diffusionWith(permeability_->after(from, tau / 2, memory));
  }

  // p1(num_nodes) from p0(num_nodes); q(num_points).
  void diffuse(DiffusionStep& step, double tau, ConstNodeView const& p0,
               DiffusionStep::Sources const& q, NodeView const& p1) const
  {
    mesh_->points().gather(p0, at_points_);
    step.advance(tau, at_points_, q, at_points_);
    mesh_->points().scatter(at_points_, p1);
  }

  void advance(StepStart const& start, NodeView const& p) const
  {
    ASPERITY_TIME_WORK("pore pressure");
    DiffusionStep::Sources q;
    for (int k = 0; k < DiffusionStep::num_times; ++k) {
      q[k] = mesh_->points().sums(inflow_->at(start.t + DiffusionStep::timeIn(k) * start.tau));
    }
    auto const diffusion = diffusion_ ? diffusion_ : diffusionInMiddle(start.from, start.tau, q, p);
    diffuse(*diffusion, start.tau, start.from.at(field_name), q, p);
  }

  NodalValues permeabilityOf(State const& state) const
  {
    return permeability_->after(state, 0, state.at(field_name));
  }

  // (num_nodes, dimension) along the axes.
  NodalValues darcyVelocity(State const& state) const
  {
    auto const gradient = mesh_->gradient(toVector(state.at(field_name)));
    auto const permeability = permeabilityOf(state);
    NodalValues velocity;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      if (static_cast<int>(i % 3) < mesh_->numCorners()) {
        velocity.push_back(-permeability[i / 3] / viscosity_[i / 3] * gradient[i]);
      }
    }
    return velocity;
  }

  RCP<const Communicator> communicator_;
  NodalValues start_, width_, viscosity_; // (num_nodes)
  NodalValues storage_;                   // (num_points) S w times the weight [m^3/Pa]
  Fixed is_fixed_;                        // (num_points)
  std::unique_ptr<Inflow> inflow_;
  std::shared_ptr<const fem::FaultMesh> mesh_;
  NodeView at_points_; // (num_points) of a step
  std::optional<Permeability> permeability_;
  std::shared_ptr<DiffusionStep> diffusion_; // where the permeability does not change
};

Teuchos::RCP<const Teuchos::ParameterList> PorePressure::validParameters()
{
  Declare declare;
  declare.boolean("Enabled", false, "If true, there is a fluid in the fault.")
    .field("Initial Pressure", 0., "Pa", Range::any(),
           "The fluid starts with this pressure. Where the normal stress of the deck is effective, "
           "it is 0, and pressures are those above the undisturbed one.")
    .field("Permeability", optional, "m^2", Range::openClosed(0, 1e-3), // an open crack of 0.1 m
           "The fault has this permeability along itself.")
    .hint("Fault zones have 1e-20 to 1e-12 m^2; a millidarcy is 1e-15 m^2.")
    .field("Storage", optional, "1/Pa", Range::positive(),
           "The fault takes up this share of its volume as fluid per pressure: the compressibility "
           "of pores and fluid times the porosity.")
    .hint("1e-8 / Pa times a porosity of 0.1 is 1e-9 / Pa.")
    .field("Width", optional, "m", Range::positive(),
           "The permeable zone has this thickness across the fault.")
    .field("Fluid Viscosity", 1e-3, "Pa s", Range::positive(), "The fluid has this viscosity.")
    .field("Fixed Where", 0., "-", Range::any(),
           "Where this is above zero, for example y < -39e3, the pressure keeps its initial value. "
           "No fluid passes the other edges of a fault, unless it ends there at another fault.")
    .field("Injection", 0., "m/s", Range::any(),
           "This volume flows into the fault per time and area, out of it if negative. It may "
           "depend on t.")
    .openSublist("Wells", Wells::validParameters(),
                 "Each list in here, of any name, is a well that meets the fault at a point.");
  Permeability::declare(declare);
  return declare.list();
}
} // namespace

ASPERITY_REGISTER(FaultProcessRegistry, "Pore Pressure", FaultProcessKindOf<PorePressure>)
} // namespace asperity::dynamics
