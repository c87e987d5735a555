#include "scenario/watches/TensionWatch.hpp"

#include "base/Text.hpp"
#include "base/parallel/FirstRank.hpp"
#include "base/parallel/Reductions.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
namespace
{
constexpr double of_normal_stress = 0.01, of_shear_stress = 0.1;
constexpr char const* topic = "fault in tension";

// The largest traction of forces(owned dofs) along the fault at this rank's nodes that slide [Pa];
// 0 without nodes.
double largestShear(fem::FaultSurface const& surface, Vector const& all)
{
  auto const forces = all.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const dofs = surface.dofs();
  auto const weights = surface.weights();
  auto const slides = surface.slidingNodes();
  const int size = surface.numTangents();
  double result = 0;
  Kokkos::parallel_reduce(
    "asperity::scenario::largestShearStress", RangePolicy(0, surface.numNodes()),
    KOKKOS_LAMBDA(int node, double& largest) {
      double square = 0;
      for (int k = 0; k < size; ++k) {
        const double tau = forces(dofs(node, k), 0) / weights(node);
        square += tau * tau;
      }
      const double tau = slides(node) ? math::sqrt(square) : 0;
      largest = tau > largest ? tau : largest;
    },
    Kokkos::Max<double>(result));
  return std::max(result, 0.);
}

// tension := tension + start - sigma_0 where the node slides, else 0; it has -R before.
void setTension(fem::FaultSurface const& surface, ConstNodeView const& start,
                ConstNodeView const& sigma_0, NodeView const& tension)
{
  auto const slides = surface.slidingNodes();
  Kokkos::parallel_for(
    "asperity::scenario::tension", RangePolicy(0, surface.numNodes()), KOKKOS_LAMBDA(int node) {
      tension(node) = slides(node) ? tension(node) + start(node) - sigma_0(node) : 0;
    });
}

// The measure of this rank's nodes with a tension of more than `least`.
double measureAbove(fem::FaultSurface const& surface, ConstNodeView const& tension, double least)
{
  auto const weights = surface.weights();
  double measure = 0;
  Kokkos::parallel_reduce(
    "asperity::scenario::inTension", RangePolicy(0, surface.numNodes()),
    KOKKOS_LAMBDA(int node, double& sum) { sum += tension(node) > least ? weights(node) : 0; },
    measure);
  return measure;
}

// The first node of this rank with this value; the number of nodes if there is none.
int firstWith(ConstNodeView const& values, double value)
{
  const int none = values.extent_int(0);
  int first = none;
  Kokkos::parallel_reduce(
    "asperity::scenario::placeOfTension", RangePolicy(0, none),
    KOKKOS_LAMBDA(int node, int& least) {
      least = values(node) == value && node < least ? node : least;
    },
    Kokkos::Min<int>(first));
  return std::min(first, none);
}
} // namespace

TensionWatch::TensionWatch(ParameterList const&, dynamics::WatchContext const& context)
    : fault_(context.fault)
    , since_start_(context.since_start)
    , sigma_0_("asperity::scenario::sigma0", fault_.surface().numNodes())
    , R_("asperity::scenario::compression", fault_.surface().numNodes())
{
  auto const& surface = fault_.surface();
  auto const load = context.body.vector();
  context.body.load(0, *load);
  loads_ = maxOverRanks(largestShear(surface, *load), *surface.communicator());
  for (int node = 0; node < surface.numNodes(); ++node) {
    sliding_ += surface.slides(node) ? surface[node].weight : 0;
  }
  sliding_ = sumOverRanks(sliding_, *surface.communicator());
}

TensionWatch::Tension TensionWatch::tensionAt(Vector const& force, double time)
{
  auto const& surface = fault_.surface();
  auto const& communicator = *surface.communicator();
  fault_.normalStress().at(time, sigma_0_);
  auto const& reaction = *since_start_.reaction;
  reaction.gather(force, R_); // l - M a - C v - K u, against which the reaction of the body acts
  reaction.compression(R_, R_);
  setTension(surface, since_start_.at_start, sigma_0_, R_);
  const std::array<double, 3> mine = {dynamics::largestOf(sigma_0_), largestShear(surface, force),
                                      dynamics::largestOf(R_)};
  auto const all = maxOverRanks(mine, communicator);
  const double least =
    std::max(of_normal_stress * all[0], of_shear_stress * std::max(all[1], loads_));
  Tension found;
  if (!(all[2] > least)) {
    return found;
  }
  const int first = firstWith(R_, all[2]);
  const bool is_here = first < surface.numNodes();
  found.share = sumOverRanks(measureAbove(surface, R_, least), communicator) / sliding_;
  found.largest = all[2];
  found.time = time;
  found.place = *ofFirstRank<3>(is_here ? std::optional(surface[first].place) : std::nullopt,
                                communicator); // a rank has the largest tension
  return found;
}

void TensionWatch::note(dynamics::WatchedState const& watched, dynamics::Notes& notes)
{
  if (!since_start_.reaction || !(sliding_ > 0) || fault_.surface().mayOpen()) {
    return;
  }
  auto const now = tensionAt(watched.force, watched.time);
  most_.share = std::max(most_.share, now.share);
  if (now.share > 0 && now.largest > most_.largest) {
    most_.largest = now.largest;
    most_.time = now.time;
    most_.place = now.place;
  }
  if (now.share > 2 * warned_share_) {
    warned_share_ = now.share;
    notes.add(Warning{topic, "At t = " + formatShort(watched.time) + " s the body " + text(now)});
  }
}

std::optional<Warning> TensionWatch::warningOfRun() const
{
  if (!(most_.share > 0)) {
    return std::nullopt;
  }
  return Warning{topic, "In this run the body " + text(most_) +
                          " That was at t = " + formatShort(most_.time) + " s."};
}

std::string TensionWatch::text(Tension const& tension) const
{
  std::vector<double> place(tension.place.begin(), tension.place.end());
  auto const& stress = fault_.normalStress();
  const bool is_fixed = stress.change() == dynamics::NormalStressChange::fixed;
  return "pulls at " + formatShort(std::round(1000 * tension.share) / 10) +
         " % of the fault, most with " + formatShort(tension.largest) + " Pa of tension at " +
         formatPoint(place) + " m. A fault would open there, but the model holds it shut" +
         (is_fixed ? ", and friction keeps the Normal Stress of the deck, since Normal Stress "
                     "Change is Fixed. "
                   : ", and the normal stress of friction is at its floor of " +
                       formatShort(stress.floor()) + " Pa. ") +
         "Check the signs of loads and velocities, and the Normal Stress at the start.";
}

void TensionWatch::save(Archive& archive) const
{
  archive.set("share", most_.share);
  archive.set("largest", most_.largest);
  archive.set("time", most_.time);
  archive.set("warned_share", warned_share_);
  for (int d = 0; d < 3; ++d) {
    archive.set("place_" + std::to_string(d), most_.place[d]);
  }
}

void TensionWatch::restore(Archive const& archive, Restart const&)
{
  most_.share = archive.getDouble("share");
  most_.largest = archive.getDouble("largest");
  most_.time = archive.getDouble("time");
  warned_share_ = archive.getDouble("warned_share");
  for (int d = 0; d < 3; ++d) {
    most_.place[d] = archive.getDouble("place_" + std::to_string(d));
  }
}
} // namespace asperity::scenario

ASPERITY_REGISTER(asperity::dynamics::WatchRegistry, "tension_watch",
                  asperity::dynamics::WatchKindOf<asperity::scenario::TensionWatch>)
