#pragma once

#include "commands/Command.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::geometry
{
std::unique_ptr<Command> buildCommand();
std::unique_ptr<Command> convertCommand();
std::unique_ptr<Command> wedgeCommand();
std::unique_ptr<Command> rectangleCommand();
std::unique_ptr<Command> boxCommand();
std::unique_ptr<Command> partitionCommand();
std::unique_ptr<Command> infoCommand();

// Runs the command of the first word with the others. InputError also if there is no such command.
void runCommand(std::vector<std::string> const& words);
void printHelp(); // of all commands
} // namespace asperity::geometry
