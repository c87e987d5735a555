#pragma once

#include "catalogue/receivers/ReceiverGroup.hpp"
#include "io/Output.hpp"
#include "io/WriteRule.hpp"
#include "io/series/SegmentedTable.hpp"
#include "parameters/Entries.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// What the deck's list `Receivers` says, but for the places and when rows are written.
struct ReceiverSettings
{
  bool is_enabled = true;
  std::optional<std::vector<std::string>> fault_fields; // empty: the usual ones
  std::vector<std::string> body_fields = {"displacement", "velocity"};

  static Entries<ReceiverSettings> entries();
  static ReceiverSettings from(ParameterList const& list);
};

// Time series at chosen places: DIR/receivers.h5.
class Receivers : public io::Output
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  static std::vector<std::string> files() { return {"receivers.h5"}; }

  Receivers(Teuchos::ParameterList const& parameters, io::OutputContext const& context);
  Receivers(Receivers const&) = delete; // the table refers to the groups
  Receivers& operator=(Receivers const&) = delete;

  void write(io::StepInfo const& step) override;
  void closeSegment(int index) override;
  void finish() override {}
  std::vector<std::string> notes() const override;
  std::vector<Warning> warnings() const override;
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;

private:
  std::string signature() const;

  io::WriteRule rule_;
  std::map<std::string, ReceiverGroup> groups_; // "off_fault", "on_fault"; those in use
  std::unique_ptr<io::SegmentedTable> table_;   // null without receivers
};
} // namespace asperity::catalogue
