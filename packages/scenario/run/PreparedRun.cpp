#include "scenario/run/PreparedRun.hpp"

#include "catalogue/receivers/OnFault.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/Fingerprint.hpp"
#include "scenario/fields/OutputFields.hpp"
#include "scenario/report/RunReport.hpp"
#include "scenario/run/OtherRun.hpp"
#include "scenario/setup/TimeSetup.hpp"

namespace asperity::scenario
{
namespace
{
std::filesystem::path directoryOfResults(CommandLine const& command_line)
{
  if (!command_line.output.empty()) {
    return command_line.output;
  }
  return std::filesystem::path("results") / std::filesystem::path(command_line.deck).stem();
}
} // namespace

template <int Dim>
PreparedRun<Dim>::PreparedRun(RCP<ParameterList> const& deck_, CommandLine const& command_line,
                              RCP<const Communicator> const& communicator_)
    : deck(deck_)
    , communicator(communicator_)
    , directory(directoryOfResults(command_line))
    , evolution(*deck, communicator)
    , domains(makeDomains(evolution.problem()))
    , unread(warnOfUnreadEntries(command_line, *deck))
    , checkpoints(
        directory, deck->sublist("Output"), command_line.plugins,
        fingerprint(completeDirections(*deck, Dim, evolution.problem().discretisation.upright),
                    evolution.problem().mesh(), *communicator),
        communicator)
{
  auto const& problem = evolution.problem();
  auto const& output = deck->sublist("Output");
  registerFields(registry, problem, evolution.view(), domains, *deck);
  outputs = std::make_unique<io::OutputSet>(
    output, io::OutputContext{
              directory, communicator, registry, domains, {0, 1, 0}, evolution.finalTime()});
  if (!command_line.restart_from.empty()) {
    state_of_other_run =
      stateOfOtherRun(command_line.restart_from, problem, domains, *deck, evolution.clock(),
                      TimeSettings::from(deck->sublist("Time Stepping")).final_time);
  }
}

template <int Dim>
Description PreparedRun<Dim>::description() const
{
  auto result = describe(evolution.problem(), *deck);
  if (unread) {
    result.warnings.push_back(*unread);
  }
  auto const fault = domains.find("fault");
  if (fault == domains.end()) {
    return result;
  }
  if (auto const warning = catalogue::warnOfReceiversOnFault(
        deck->sublist("Output").sublist("Receivers"), domains.at("volume"), fault->second,
        evolution.problem().mesh().splits)) {
    result.warnings.push_back(*warning);
  }
  return result;
}

template struct PreparedRun<2>;
template struct PreparedRun<3>;
} // namespace asperity::scenario
