#pragma once

#include "io/Output.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::io
{
// The entry `Up` of the deck's list `Output`.
struct DirectionUp
{
  static constexpr char const* entry = "Up";
  std::optional<std::vector<double>> up; // as the deck gives it

  static DirectionUp from(Teuchos::ParameterList const& output);
  // +y if it is not given; InputError if it is no direction.
  std::array<double, 3> orDefault() const;
};

// All outputs of a run, made from the deck's list `Output`: one sublist for every registered kind,
// each with the bool `Enabled`, and the direction `Up`. An output is left out, whatever the deck
// says, if the run does not have the domain that it needs.
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
  // One sublist for every registered kind, and `Up`; declare adds them to the caller's list
  // `Output`.
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static void declare(Teuchos::ParameterList& list);
  // `Times` [s] of all enabled outputs of a list as above, in no order.
  static std::vector<double> times(Teuchos::ParameterList const& parameters);

  // Completes and validates the entries that declare adds, in a copy; reads no other entry.
  OutputSet(Teuchos::ParameterList const& parameters, OutputContext const& context);
  ~OutputSet();

  void write(StepInfo const& step);
  void closeSegment();
  Archive save() const;
  void restore(Archive const& archive);
  void finish();

  bool endsRun() const; // whether one of the outputs does

  // An output of which the deck gives an entry, and the domain that it lacks.
  struct LeftOut
  {
    std::string name, domain;
  };
  std::vector<LeftOut> const& leftOut() const { return left_out_; }

  // The events of the first output that counts them, and the reports, notes and warnings of all
  // outputs, see Output.
  std::optional<std::int64_t> numEvents() const;
  std::string report() const;
  std::vector<std::string> notes() const;
  std::vector<Warning> warnings() const;

private:
  struct Entry
  {
    std::string name;
    std::unique_ptr<Output> output;
  };
  void makeOutputs(Teuchos::ParameterList const& parameters, OutputContext const& context);

  std::vector<Entry> entries_;
  std::vector<LeftOut> left_out_;
  int num_closed_segments_ = 0;
};
} // namespace asperity::io
