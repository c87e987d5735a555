#include "scenario/setup/CheckpointSetup.hpp"

#include "parameters/Entries.hpp"
#include "scenario/setup/DeckPaths.hpp"

namespace asperity::scenario
{
namespace
{
Entries<CheckpointIntervals> entriesIn(ParameterList& output)
{
  using S = CheckpointIntervals;
  Entries<S> entries({}, output);
  entries
    .integer("Checkpoint Every n Steps", &S::num_steps, Range::atLeast(1),
             "A checkpoint is written after this number of accepted steps.")
    .real("Checkpoint Every Minutes", &S::minutes, "min", Range::positive(),
          "A checkpoint is also written when this much wall time has passed since the last one. A "
          "killed run loses at most this time. Each checkpoint closes one file of every history: "
          "a few hundred checkpoints in a run are enough.");
  return entries;
}
} // namespace

void CheckpointIntervals::declare(ParameterList& output) { entriesIn(output); }

CheckpointIntervals CheckpointIntervals::from(ParameterList const& output)
{
  ParameterList declared;
  return entriesIn(declared).read(output, output_path);
}
} // namespace asperity::scenario
