#include "scenario/setup/friction/FrictionSetup.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "dynamics/FaultProcess.hpp"
#include "parameters/Entries.hpp"
#include "scenario/setup/DeckPaths.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace asperity::scenario
{
namespace
{
char const* const change_choice = "Normal Stress Change";

// The words of that choice.
struct ChangeWord
{
  char const* word;
  dynamics::NormalStressChange change;
};
constexpr ChangeWord change_words[] = {
  {"Fixed", dynamics::NormalStressChange::fixed},
  {"Lagged", dynamics::NormalStressChange::lagged},
  {"Coupled", dynamics::NormalStressChange::coupled},
  {regularisation_list, dynamics::NormalStressChange::coupled}};

RCP<const ParameterList> regularisationParameters()
{
  return Declare()
    .field(regularisation_slip, optional, "m", Range::positive(),
           "Friction comes nearer to the effective normal stress by a factor e within this slip. "
           "If it is left out, slip has no such effect.")
    .field(regularisation_time, optional, "s", Range::positive(),
           "It does so within this time, too, whether the fault slips or not. If it is left out, "
           "time has no such effect. One of the two has to be given.")
    .hint("A rate V_ref beside the slip rate is a time of Slip Distance / V_ref.")
    .list();
}

// The list of each word; only one has entries.
std::vector<Declare::NamedList> listsOfChange()
{
  std::vector<Declare::NamedList> lists;
  for (auto const& [word, change] : change_words) {
    lists.emplace_back(word, Declare().list());
    if (lists.back().first == regularisation_list) {
      lists.back().second = regularisationParameters();
    }
  }
  return lists;
}

Entries<FrictionSettings> frictionEntries()
{
  using S = FrictionSettings;
  Entries<S> entries;
  auto& declare = entries.others();
  declareLaws(declare);
  declare
    .field(friction_entries::cohesion, 0., "Pa", Range::atLeast(0),
           "The fault bears this shear stress even without normal stress.")
    .field(friction_entries::normal_stress, optional, "Pa", Range::any(),
           "The fault is under this normal stress, positive in compression. If it is left out, it "
           "follows from the static solution under gravity. Values that become negative after the "
           "start count as zero.");
  entries
    .real("Normal Stress Factor", &S::normal_stress_factor, "-", Range::atLeast(0),
          "This factor multiplies the normal stress.")
    .choiceOfLists(
      change_choice, &S::change, listsOfChange(),
      "Selects whether the change of the compression across the fault since the start of the run "
      "is added to the normal stress. Fixed: it is not. Lagged: the change up to the beginning of "
      "each step is added, with an error of first order in the step size. Coupled: the change up "
      "to its end, solved together with the state of the fault. Prakash-Clifton: as Coupled, and "
      "friction follows the effective normal stress with slip and time in place of at once.")
    .real("Normal Stress Floor", &S::floor, "Pa", Range::atLeast(0),
          "The normal stress takes this value where it would fall below.")
    .others()
    .field(friction_entries::shear_traction, 0., "Pa", Range::any(),
           "This shear traction acts on the fault in addition to that of the deformation. It "
           "points along the tangent of the fault's frame, which is +x on a fault below the body, "
           "and in three dimensions along the slip direction.");
  entries.realArray(
    friction_entries::slip_direction, &S::slip_direction, "-", Range::any(),
    "In three dimensions the shear traction points along this vector, projected onto "
    "the fault. The length of the vector has no effect.");
  auto const& processes = dynamics::FaultProcessRegistry::instance();
  for (auto const& name : processes.names()) {
    declare.sublist(name, processes.at(name).validParameters(), processes.at(name).meaning());
  }
  return entries;
}
} // namespace

RCP<const ParameterList> frictionParameters() { return frictionEntries().list(); }

FrictionSettings FrictionSettings::from(ParameterList const& list)
{
  auto settings = frictionEntries().read(list, friction_path);
  settings.laws = LawChoice::from(list);
  settings.gives_normal_stress = isGiven(list, friction_entries::normal_stress);
  return settings;
}

dynamics::NormalStressChange FrictionSettings::normalStressChange() const
{
  auto const* const found = std::find_if(std::begin(change_words), std::end(change_words),
                                         [this](auto const& each) { return change == each.word; });
  ASPERITY_ASSERT(found != std::end(change_words)); // the deck is complete
  return found->change;
}

bool FrictionSettings::followsAtOnce() const
{
  return normalStressChange() != dynamics::NormalStressChange::fixed &&
         change != regularisation_list;
}

std::vector<Warning> warnOfImplausibleFriction(ParameterList const& list, FieldNodes const& nodes,
                                               Communicator const& communicator)
{
  // Rubber on a rough surface has 2 to 4. Barriers may have any, so that the smallest counts.
  constexpr double largest_coefficient = 5;
  // Projectiles that strike rock.
  constexpr double largest_rate = 1000; // m/s
  const auto question = [&](char const* name, char const* unit, double largest,
                            char const* advice) -> std::vector<Warning> {
    if (!isGiven(list, name)) {
      return {};
    }
    double smallest = std::numeric_limits<double>::infinity();
    for (const double value : nodalValues(list, name, friction_path, nodes)) {
      smallest = std::min(smallest, value);
    }
    smallest = minOverRanks(smallest, communicator);
    if (!(smallest > largest) || smallest == std::numeric_limits<double>::infinity()) {
      return {};
    }
    return {{"friction coefficient", joinPath(friction_path, name) + " is " +
                                       formatShort(smallest) + unit +
                                       " or more everywhere on the fault. " + advice}};
  };
  auto warnings = question("Reference Friction Coefficient", "", largest_coefficient,
                           "It is the tangent of an angle, not an angle.");
  auto const of_rate =
    question("Reference Slip Rate", " m/s", largest_rate, "It is a slip rate in m/s.");
  warnings.insert(warnings.end(), of_rate.begin(), of_rate.end());
  return warnings;
}
} // namespace asperity::scenario
