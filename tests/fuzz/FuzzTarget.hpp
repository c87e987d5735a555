#pragma once

#include <string>

// What a fuzz target is: a function that takes any bytes for input. The main programs of libFuzzer
// and of the replay of the corpus call it in the same way.
namespace asperity::fuzz
{
// Called once, before the first input.
void start(int& argc, char**& argv);

// Each target has its own. What the input makes of itself is either right or an InputError.
void tryInput(std::string const& input);

// Calls tryInput, and returns the message of the InputError, or "". Nothing else gets through it
// unnoticed: any other exception does, and a message that is empty or has more than six lines of
// our own ends the program.
std::string checkInput(std::string const& input);
} // namespace asperity::fuzz
