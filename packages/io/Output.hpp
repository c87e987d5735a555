#pragma once

#include "base/Archive.hpp"
#include "base/Types.hpp"
#include "base/Warning.hpp"
#include "io/FieldRegistry.hpp"
#include "io/OutputDomain.hpp"
#include "parameters/Kind.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::io
{
// An accepted step, or the initial state as step 0. The same on every rank.
struct StepInfo
{
  std::int64_t step = 0;
  double time = 0;           // at the end of the step [s]
  double step_size = 0;      // [s]
  double peak_slip_rate = 0; // over the fault, where friction decides on it [m/s]
  bool is_last = false;      // the run ends with it
  double wall_time = 0;      // of this rank's processes of the run [s]; not the same on every rank
};

// What an output may use. Registry and domains must outlive the outputs.
struct OutputContext
{
  std::filesystem::path directory;
  RCP<const Communicator> comm;
  FieldRegistry const& fields;
  std::map<std::string, OutputDomain> const& domains; // by name
  std::array<double, 3> up{0, 1, 0}; // direction, in three dimensions; OutputSet sets it
  double final_time = 0;             // of the run [s]; 0 if unknown

  // Throws InputError, which says what to change in the deck, if there is no such domain.
  OutputDomain const& domain(std::string const& name) const;
};

// One kind of result that a run writes to disk. All functions are collective.
class Output
{
public:
  virtual ~Output() = default;

  // Called after every accepted step, and once before the first one.
  virtual void write(StepInfo const& step) = 0;

  // Afterwards everything written so far is complete and readable on disk. Called before a
  // checkpoint; `index` counts the checkpoints from 0.
  virtual void closeSegment(int index) = 0;

  // Called at the end of the run, after the last closeSegment and the last checkpoint.
  virtual void finish() = 0;

  // Save and restore what write needs from the past. restore also brings the files back to their
  // state at the checkpoint.
  virtual void save(Archive& archive) const = 0;
  virtual void restore(Archive const& archive) = 0;

  // Whether the run is to end with the last step written, and whether that may happen at all. The
  // same on all ranks.
  virtual bool endsRun() const { return false; }
  virtual bool mayEndRun() const { return false; }

  // How many events there are so far, with the one in progress, of an output that counts them; and
  // a paragraph for the report at the end of the run.
  virtual std::optional<std::int64_t> numEvents() const { return {}; }
  virtual std::string report() const { return ""; }

  // Lines and warnings for the log at the start of the run. Called once, after the construction.
  virtual std::vector<std::string> notes() const { return {}; }
  virtual std::vector<Warning> warnings() const { return {}; }

  // Defaults for a kind of output, which a class replaces by static functions of the same names:
  // the domain without which the output is left out ("" means it is never left out), and its files,
  // relative to the folder of the run. A file name may have one '*' for any text; segments need not
  // be named.
  static std::string neededDomain() { return ""; }
  static std::vector<std::string> files() { return {}; }
};

// Registered under the name of its list in the deck's list `Output`, at the bottom of the file of
// the output, whose parameters have `Enabled`; neededDomain() and files() are those of Output:
//   ASPERITY_REGISTER(OutputRegistry, "Fault History", OutputKindOf<FaultHistory>)
struct OutputKind : Kind<Output, OutputContext>
{
  static constexpr char const* registered_as = "output";
  virtual std::string neededDomain() const = 0;
  virtual std::vector<std::string> files() const = 0;
};
template <class Type>
struct OutputKindOf : KindOf<OutputKind, Type>
{
  std::string neededDomain() const override { return Type::neededDomain(); }
  std::vector<std::string> files() const override { return Type::files(); }
};
using OutputRegistry = Registry<OutputKind>;
} // namespace asperity::io
