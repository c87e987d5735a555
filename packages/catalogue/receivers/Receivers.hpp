#pragma once

#include "catalogue/receivers/ReceiverGroup.hpp"
#include "io/Output.hpp"
#include "io/WriteRule.hpp"
#include "io/series/SegmentedTable.hpp"
#include "parameters/Parameters.hpp"

#include <map>
#include <memory>
#include <string>

namespace asperity::catalogue
{
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
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;

private:
  std::string signature() const;

  io::WriteRule rule_;
  std::map<std::string, ReceiverGroup> groups_; // "off_fault", "on_fault"; those in use
  std::unique_ptr<io::SegmentedTable> table_;   // null without receivers
};
} // namespace asperity::catalogue
