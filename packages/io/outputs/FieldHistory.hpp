#pragma once

#include "io/Output.hpp"
#include "io/WriteRule.hpp"
#include "io/series/SegmentedSeries.hpp"
#include "parameters/Parameters.hpp"

#include <string>
#include <vector>

namespace asperity::io
{
// Some fields of one domain over time, in DIR/<domain>.h5 and .xdmf.
class FieldHistory : public Output
{
public:
  FieldHistory(std::string const& domain, Teuchos::ParameterList const& parameters,
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

private:
  WriteRule rule_;
  SegmentedSeries series_;
};

class FaultHistory : public FieldHistory
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  static std::string neededDomain() { return "fault"; }
  static std::vector<std::string> files() { return {"fault.h5", "fault.xdmf"}; }

  FaultHistory(Teuchos::ParameterList const& parameters, OutputContext const& context);
};

class SurfaceHistory : public FieldHistory
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  static std::string neededDomain() { return "surface"; }
  static std::vector<std::string> files() { return {"surface.h5", "surface.xdmf"}; }

  SurfaceHistory(Teuchos::ParameterList const& parameters, OutputContext const& context);
};

class VolumeSnapshots : public FieldHistory
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  static std::string neededDomain() { return "volume"; }
  static std::vector<std::string> files() { return {"volume.h5", "volume.xdmf"}; }

  VolumeSnapshots(Teuchos::ParameterList const& parameters, OutputContext const& context);
};
} // namespace asperity::io
