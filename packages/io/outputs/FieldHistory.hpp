#pragma once

#include "base/parameters/Parameters.hpp"
#include "io/Output.hpp"
#include "io/WriteRule.hpp"
#include "io/series/SegmentedSeries.hpp"

#include <string>
#include <vector>

namespace asperity::io
{
// Some fields of one location over time, in DIR/<location>.h5 and .xdmf.
class FieldHistory : public Output
{
public:
  FieldHistory(std::string const& location, Teuchos::ParameterList const& parameters,
               OutputContext const& context);

  void write(StepInfo const& step) override;
  void closeSegment(int index) override;
  void finish() override {}
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;

protected:
  struct Defaults
  {
    bool enabled = true;
    std::vector<std::string> fields;
    int every_n_steps = 0;
    double rate_change_factor = 0;
  };
  static Teuchos::RCP<const Teuchos::ParameterList> parametersWith(Defaults const& defaults);

  // After each step with a row.
  virtual void rowWritten(StepInfo const&) {}

private:
  WriteRule rule_;
  SegmentedSeries series_;
};
} // namespace asperity::io
