#pragma once

#include "parameters/Parameters.hpp"

#include <iosfwd>
#include <string>

namespace asperity
{
// Reads a deck, an XML file with the root list `Asperity`. A missing or malformed file, or one with
// another root, is an InputError with the file's name and, where known, the line.
Teuchos::RCP<ParameterList> readDeck(std::string const& file_name);

// Entries of the file replace or extend those of the list, list by list; <Remove name="..."/> takes
// out what has that name.
void overlayDeck(ParameterList& list, std::string const& file_name);

// Applies "Path/To/Parameter=value"; the path starts below the root list, "Asperity/" may stand
// before it. The value takes the declared type (a field accepts numbers and expressions, an array
// {1, 2, 3}); below open and foreign lists the type is that of the value there, or guessed: bool,
// int, double, string. An unknown path or a value of another type is an InputError, but a text for
// a number is left to resolveNames. Call it before completeAndValidate.
void applyOverride(ParameterList& list, ParameterList const& valid, std::string const& assignment);

// Removes the entry or list at "Path/To/Entry". InputError if the deck itself does not have it.
void removeEntry(ParameterList& list, std::string const& path);

// Writes a completed list as XML that readDeck accepts. OutputError if the file cannot be written.
void writeParameters(ParameterList const& list, std::string const& file_name);

enum class ParameterFormat
{
  text,
  xml
};

// Every declared parameter with default, unit, range and meaning; as XML it is a deck with
// comments.
void printParameters(ParameterList const& valid, std::ostream& out, ParameterFormat format);
} // namespace asperity
