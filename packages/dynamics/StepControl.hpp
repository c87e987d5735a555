#pragma once

#include "dynamics/CoupledStep.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::dynamics
{
// A solved step that has not been accepted.
struct Trial
{
  State state;        // at its end
  int iterations = 0; // of the fixed point
};

struct AcceptedStep
{
  int level = 0;
  int iterations = 0;           // of the fixed point, in the step that was accepted
  double error = 0;             // of alpha, estimated, root mean square over the fault
  bool within_tolerance = true; // false: even the smallest step did not meet it
};

// What a control remembers from one step to the next, and a checkpoint has to keep.
struct ControlMemory
{
  int level = 0;
  std::int64_t num_steps = 0;
  std::optional<Trial> trial; // the next step, already solved
};

// Chooses step sizes. SolveError if the smallest step cannot be solved either.
class StepControl
{
public:
  virtual ~StepControl() = default;
  // Replaces `current` by the state after the next accepted step.
  virtual AcceptedStep advance(State& current, SolveCount& count) = 0;

  ControlMemory const& memory() const { return memory_; }
  void restore(ControlMemory memory) { memory_ = std::move(memory); }

protected:
  ControlMemory memory_;
};

// Steps of given levels, one after the other; the last one is repeated.
class PrescribedSteps final : public StepControl
{
public:
  PrescribedSteps(CoupledStep& step, DyadicTime const& clock, std::vector<int> levels);
  AcceptedStep advance(State& current, SolveCount& count) override;

private:
  CoupledStep& step_;
  DyadicTime clock_;
  std::vector<int> levels_;
};

struct StepDoublingSettings
{
  double tolerance = 1e-5; // of alpha, root mean square over the fault
  int coarsest_level = 0;  // of the largest step allowed
  int finest_level = 0;    // of the smallest step allowed
  int first_level = 0;
};

// Pipping 2014, A.3: a step is fine enough if two steps of half its size lead to nearly the same
// alpha. The coarsest such step is accepted, starting from twice the last size; the finer ones
// already computed become the next trials.
class StepDoubling final : public StepControl
{
public:
  StepDoubling(CoupledStep& step, Fault const& fault, DyadicTime const& clock,
               StepDoublingSettings const& settings);
  AcceptedStep advance(State& current, SolveCount& count) override;

private:
  std::optional<Trial> attempt(State const& from, int level, State const& guess, SolveCount& count);
  void findTrial(State const& current, SolveCount& count);
  bool coarsen(State const& current, std::optional<Trial>& next, double& error, SolveCount& count);
  bool refine(State const& current, std::optional<Trial>& next, double& error, SolveCount& count);

  CoupledStep& step_;
  Fault const& fault_;
  DyadicTime clock_;
  StepDoublingSettings settings_;
};
} // namespace asperity::dynamics
