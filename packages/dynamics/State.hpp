#pragma once

#include "base/Types.hpp"
#include "dynamics/Body.hpp"
#include "dynamics/DyadicTime.hpp"
#include "portability/Views.hpp"

#include <Tpetra_Vector.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::dynamics
{
// What is to be known of a field of the state by all that treat its fields alike: copies, guesses,
// checkpoints, other meshes, condensation, the search for values that are not finite.
struct FieldInfo
{
  std::string name;     // in a checkpoint: "sigma_n"
  std::string quantity; // in a message: "normal stress"
  std::string unit;
  // Whether a step starts from a guess of it. These are the fields that a step has found as soon as
  // it is solved at the fault; the others follow.
  bool is_guessed = false;
  // Whether a new mesh adds its change since the start to the start of its own, and does not take
  // over the value.
  bool counts_from_start = false;
};

// Everything that the future of a run depends on, at one time.
struct State
{
  DyadicTime::Ticks time = 0;
  RCP<Vector> u, v, a;
  RCP<Vector> jerk;                  // of the last step, see RateUpdate; zero at the start
  std::vector<RCP<Vector>> branches; // d_k of the body's Maxwell branches; u at the start
  NodeView alpha, sigma_n;
  NodeView alpha_of_rate; // of the last rate problem, with which v was computed
  // What the fixed point of the last step has left in alpha, which friction of the next step takes
  // back (StateUpdate).
  NodeView alpha_defect;
  std::optional<fem::InelasticStrain> inelastic; // of the body's cells, if any may yield

  // A field at the nodes of the fault that a model declares in addition to those above.
  struct Added
  {
    std::shared_ptr<const FieldInfo> info;
    NodeView values;
  };
  std::vector<Added> added;

  // The list of fields: visit(info, field of the first state, field of the second, ...) for each.
  // All states have the same fields. A field of the body is an RCP<Vector> on the owned dofs, in
  // nodal frames; a field of the fault is a NodeView on its nodes; a field of cells is a TensorView
  // with a row for each of the body's fem::InelasticCells.
  template <class Visit, class First, class... Others>
  static void visitBody(Visit const& visit, First& first, Others&... others);
  template <class Visit, class First, class... Others>
  static void visitFault(Visit const& visit, First& first, Others&... others);
  template <class Visit, class First, class... Others>
  static void visitCells(Visit const& visit, First& first, Others&... others);
  template <class Visit, class... States>
  static void visitFields(Visit const& visit, States&... states)
  {
    visitBody(visit, states...);
    visitFault(visit, states...);
    visitCells(visit, states...);
  }

  // How many fields visitBody() visits.
  std::size_t numBodyFields() const;
  // The values of an added field.
  NodeView const& at(std::string const& name) const;

  Motion motion() const { return {*u, *v, *a, branches, inelastic ? &inelastic->strain : nullptr}; }
  State sameShape() const; // values are not set
  State clone() const;
};

// The values of a field on the device; those of a vector are valid while it is.
ConstNodeView valuesOf(RCP<Vector> const& field);
inline ConstNodeView valuesOf(NodeView const& field) { return field; }
NodeView overwritten(RCP<Vector> const& field);
inline NodeView overwritten(NodeView const& field) { return field; }
inline ConstNodeView valuesOf(fem::TensorView const& field)
{
  return ConstNodeView(field.data(), field.size());
}
inline NodeView overwritten(fem::TensorView const& field)
{
  return NodeView(field.data(), field.size());
}

template <class Visit, class First, class... Others>
void State::visitBody(Visit const& visit, First& first, Others&... others)
{
  static const FieldInfo u_info = {"u", "displacement", "m", false, true};
  static const FieldInfo v_info = {"v", "velocity", "m/s", true};
  static const FieldInfo a_info = {"a", "acceleration", "m/s^2"};
  static const FieldInfo jerk_info = {"jerk", "jerk", "m/s^3"};
  visit(u_info, first.u, others.u...);
  visit(v_info, first.v, others.v...);
  visit(a_info, first.a, others.a...);
  visit(jerk_info, first.jerk, others.jerk...);
  for (std::size_t k = 0; k < first.branches.size(); ++k) {
    const FieldInfo branch_info = {"branch_" + std::to_string(k + 1),
                                   "displacement of a Maxwell branch", "m", false, true};
    visit(branch_info, first.branches[k], others.branches[k]...);
  }
}

template <class Visit, class First, class... Others>
void State::visitFault(Visit const& visit, First& first, Others&... others)
{
  static const FieldInfo alpha_info = {"alpha", "alpha", "-", true};
  static const FieldInfo sigma_n_info = {"sigma_n", "normal stress", "Pa", true, true};
  static const FieldInfo rate_info = {"alpha_of_rate", "alpha of the last rate problem", "-"};
  static const FieldInfo defect_info = {"alpha_defect", "defect of alpha", "-"};
  visit(alpha_info, first.alpha, others.alpha...);
  visit(sigma_n_info, first.sigma_n, others.sigma_n...);
  visit(rate_info, first.alpha_of_rate, others.alpha_of_rate...);
  visit(defect_info, first.alpha_defect, others.alpha_defect...);
  for (std::size_t i = 0; i < first.added.size(); ++i) {
    visit(*first.added[i].info, first.added[i].values, others.added[i].values...);
  }
}

template <class Visit, class First, class... Others>
void State::visitCells(Visit const& visit, First& first, Others&... others)
{
  static const FieldInfo strain_info = {"inelastic_strain", "inelastic strain", "-", true};
  static const FieldInfo shear_info = {"inelastic_shear", "accumulated inelastic shear", "-"};
  static const FieldInfo history_info = {"inelastic_history", "internal variables of rock", "SI"};
  if (first.inelastic) {
    visit(strain_info, first.inelastic->strain, others.inelastic->strain...);
    visit(shear_info, first.inelastic->shear, others.inelastic->shear...);
    if (first.inelastic->history.extent(1) > 0) {
      visit(history_info, first.inelastic->history, others.inelastic->history...);
    }
  }
}
} // namespace asperity::dynamics
