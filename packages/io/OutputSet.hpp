#pragma once

#include "io/Output.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::io
{
class EventCatalogue;

// All outputs of a run, made from the deck's list `Output`: one sublist for every registered kind,
// each with the bool `Enabled`, and the choice `Text Format` of files for the platforms.
//
//   OutputSet outputs(deck.sublist("Output"), context);
//   outputs.write(initial);                        // not after a restart
//   ... every accepted step:  outputs.write(step);
//   ... every checkpoint:     outputs.closeSegment(); archive.insert("outputs", outputs.save());
//                             writeCheckpoint(...);
//   ... restart:              outputs.restore(archive.child("outputs"));
//   at the end:               the steps of a checkpoint, then outputs.finish();
class OutputSet
{
public:
  // One sublist for every registered kind, and the text format; declare adds them to the caller's
  // list `Output`.
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static void declare(Teuchos::ParameterList& list);

  // Completes and validates the entries that declare adds, in a copy; reads no other entry.
  OutputSet(Teuchos::ParameterList const& parameters, OutputContext const& context);
  ~OutputSet();

  void write(StepInfo const& step);
  void closeSegment();
  Archive save() const;
  void restore(Archive const& archive);
  void finish();

  // The catalogue, for tables and progress lines; null if the deck has switched it off.
  EventCatalogue const* events() const;

private:
  struct Entry
  {
    std::string name;
    std::unique_ptr<Output> output;
  };
  std::vector<Entry> entries_;
  int num_closed_segments_ = 0;
  Platform platform_;
};
} // namespace asperity::io
