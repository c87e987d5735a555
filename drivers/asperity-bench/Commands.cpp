#include "Commands.hpp"

#include "base/Errors.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/WorkTimers.hpp"
#include "compare/Compare.hpp"
#include "mesh/MeshCounts.hpp"
#include "scaling/Scaling.hpp"
#include "scenario/DeckReader.hpp"
#include "steps/Steps.hpp"
#include "stiffness/FaultStiffness.hpp"

#include <fstream>
#include <iostream>
#include <sstream>

namespace
{
void write(std::string const& file_name, std::string const& text)
{
  std::ofstream file(file_name);
  file << text;
  file.close();
  ASPERITY_REQUIRE(file.good(), "Cannot write '" << file_name << "'.");
}

int measureStretch(BenchArguments const& arguments,
                   asperity::RCP<const asperity::Communicator> const& communicator)
{
  auto const deck = asperity::scenario::readCompleteDeck(arguments.deck);
  auto const sample = measureSteps(*deck, arguments.steps, communicator);
  auto const work = asperity::tableOfWork(*communicator);
  if (communicator->getRank() == 0) {
    std::cout << stepsTable(sample, communicator->getSize()) << "\n" << work;
    if (!arguments.output.empty()) {
      write(arguments.output, stepsJson(sample, communicator->getSize()));
    }
  }
  return asperity::exit_done;
}

int compareStretch(BenchArguments const& arguments,
                   asperity::RCP<const asperity::Communicator> const& communicator)
{
  auto const deck = asperity::scenario::readCompleteDeck(arguments.deck);
  auto const comparison = compareWithLinear(*deck, arguments.compare, communicator);
  if (communicator->getRank() == 0) {
    std::cout << comparisonTable(comparison, communicator->getSize()) << std::flush;
    if (!arguments.output.empty()) {
      write(arguments.output, comparisonJson(comparison, communicator->getSize()));
    }
  }
  return asperity::exit_done;
}

int measureScaling(BenchArguments const& arguments,
                   asperity::RCP<const asperity::Communicator> const& communicator)
{
  // Measure one mesh after the other, from coarse to fine.
  const bool speaks = communicator->getRank() == 0;
  std::vector<MeshSample> samples;
  for (double size : arguments.scaling.sizes) {
    auto command_line = arguments.deck;
    std::ostringstream assignment;
    assignment << arguments.scaling.cell_size << '=' << size;
    command_line.overrides.push_back(assignment.str());
    auto const deck = asperity::scenario::readCompleteDeck(command_line);
    samples.push_back(measureMesh(*deck, arguments.scaling, size, communicator));
    if (speaks) {
      std::cout << scalingTable({samples.back()}, communicator->getSize()) << std::flush;
    }
  }
  // Write the same numbers as JSON.
  if (speaks && !arguments.output.empty()) {
    write(arguments.output, scalingJson(samples, communicator->getSize()));
  }
  return asperity::exit_done;
}

int writeStiffness(BenchArguments const& arguments,
                   asperity::RCP<const asperity::Communicator> const& communicator)
{
  auto const deck = asperity::scenario::readCompleteDeck(arguments.deck);
  auto const stiffness = stiffnessOfFault(*deck, communicator);
  std::cout << stiffnessTable(stiffness) << std::flush;
  if (!arguments.output.empty()) {
    write(arguments.output, stiffnessText(stiffness));
  }
  return asperity::exit_done;
}

int countMesh(BenchArguments const& arguments,
              asperity::RCP<const asperity::Communicator> const& communicator)
{
  auto const deck = asperity::scenario::readCompleteDeck(arguments.deck);
  auto const text = meshCounts(*deck, communicator);
  if (communicator->getRank() == 0) {
    std::cout << text << std::flush;
  }
  return asperity::exit_done;
}
} // namespace

int measure(BenchArguments const& arguments,
            asperity::RCP<const asperity::Communicator> const& communicator)
{
  if (arguments.counts_mesh) {
    return countMesh(arguments, communicator);
  }
  if (arguments.writes_stiffness) {
    return writeStiffness(arguments, communicator);
  }
  if (arguments.compare.num_steps > 0) {
    return compareStretch(arguments, communicator);
  }
  return arguments.steps.num_steps > 0 ? measureStretch(arguments, communicator)
                                       : measureScaling(arguments, communicator);
}
