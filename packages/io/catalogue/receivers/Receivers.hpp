#pragma once

#include "base/parameters/Parameters.hpp"
#include "io/Output.hpp"
#include "io/WriteRule.hpp"
#include "io/catalogue/receivers/ReceiverGroup.hpp"
#include "io/platforms/PlatformFile.hpp"
#include "io/series/SegmentedTable.hpp"

#include <map>
#include <memory>
#include <string>

namespace asperity::io
{
// Time series at chosen places: DIR/receivers.h5 and, if the deck names a platform, its text files.
class Receivers : public Output
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();

  Receivers(Teuchos::ParameterList const& parameters, OutputContext const& context);
  Receivers(Receivers const&) = delete; // the table describes itself with the groups
  Receivers& operator=(Receivers const&) = delete;

  void write(StepInfo const& step) override;
  void closeSegment(int index) override;
  void finish() override {}
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;

private:
  void writeTexts(OutputContext const& context);
  std::string signature() const;

  WriteRule rule_;
  bool resamples_; // the text files take every accepted step
  detail::StepFacts steps_;
  std::map<std::string, detail::ReceiverGroup> groups_; // "off_fault", "on_fault"; those in use
  std::unique_ptr<detail::SegmentedTable> table_;       // null without receivers
};
} // namespace asperity::io
