#pragma once

#include "io/Output.hpp"
#include "io/WriteRule.hpp"
#include "io/files/TextTable.hpp"

#include <string>
#include <vector>

namespace asperity::catalogue
{
// DIR/global.csv: the fault as a whole over time, without the nodes whose slip rate is prescribed.
// Needs `slip_rate`, `slip` and `shear_modulus` on the fault.
class Global : public io::Output
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  static std::string neededDomain() { return "fault"; }
  static std::vector<std::string> files() { return {"global.csv"}; }

  Global(Teuchos::ParameterList const& parameters, io::OutputContext const& context);

  void write(io::StepInfo const& step) override;
  void closeSegment(int) override { file_.flush(); }
  void finish() override {}
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;

private:
  double moment(std::vector<double> const& values, int components) const;

  io::OutputDomain const& fault_;
  io::OutputField const& slip_rate_;
  io::OutputField const& slip_;
  std::vector<double> rigidity_; // (num_owned) [N/m] or [N] modulus times weight; 0: not counted
  io::WriteRule rule_;
  io::TextTable file_;
};
} // namespace asperity::catalogue
