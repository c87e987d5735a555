#include "scenario/run/PreparedRun.hpp"

#include "catalogue/receivers/ReceiversOnFault.hpp"
#include "catalogue/stress/CoulombPlanes.hpp"
#include "scenario/DeckRemarks.hpp"
#include "scenario/Fingerprint.hpp"
#include "scenario/fields/OutputFields.hpp"
#include "scenario/report/RunReport.hpp"
#include "scenario/run/OtherRun.hpp"
#include "scenario/setup/DeckPaths.hpp"

#include <utility>

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

template <int Dim>
Beginning beginningOf(CommandLine const& command_line, Problem<Dim> const& problem,
                      Domains const& domains, Checkpoints const& checkpoints)
{
  if (!command_line.restart.empty()) {
    return {Beginning::From::checkpoint,
            checkpoints.read(command_line.restart, nodeSets(problem, domains))};
  }
  if (!command_line.restart_from.empty()) {
    return {Beginning::From::other_run,
            stateOfOtherRun(command_line.restart_from, problem, domains, clockOf(problem),
                            problem.settings.time.final_time)};
  }
  return {};
}
} // namespace

template <int Dim>
PreparedRun<Dim>::PreparedRun(RCP<const ParameterList> deck_, Problem<Dim> problem_,
                              CommandLine const& command_line)
    : deck(std::move(deck_)) // the order is that of the members, see the header
    , communicator(problem_.communicator)
    , directory(directoryOfResults(command_line))
    , problem(std::move(problem_))
    , domains(makeDomains(problem))
    , checkpoints(directory, problem.settings.checkpoints, command_line.plugins,
                  fingerprint(*deck, problem.mesh(), *communicator), communicator)
    , beginning(beginningOf(command_line, problem, domains, checkpoints))
    , evolution(problem, *deck, beginning)
    , unread(warnOfUnreadEntries(command_line, *deck))
{
  auto const& output = deck->sublist(deck_lists::output);
  registerFields(registry, problem, evolution.view(), domains,
                 catalogue::coulombPlanes(output, Dim));
  outputs = std::make_unique<io::OutputSet>(
    output, io::OutputContext{
              directory, communicator, registry, domains, {0, 1, 0}, evolution.finalTime()});
}

template <int Dim>
Description PreparedRun<Dim>::description() const
{
  auto result = describe(problem);
  if (unread) {
    result.warnings.push_back(*unread);
  }
  result.add(outputs->notes());
  result.add(outputs->warnings());
  auto const fault = domains.find("fault");
  if (fault == domains.end()) {
    return result;
  }
  auto const& output = deck->sublist(deck_lists::output);
  auto const ground = catalogue::groundOf(domains, io::DirectionUp::from(output).orDefault());
  if (auto const warning = catalogue::warnOfReceiversOnFault(
        output.sublist("Receivers"),
        {domains.at("volume"), fault->second, ground ? &*ground : nullptr},
        problem.mesh().splits)) {
    result.warnings.push_back(*warning);
  }
  return result;
}

template struct PreparedRun<2>;
template struct PreparedRun<3>;
} // namespace asperity::scenario
