#pragma once

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_XMLObject.hpp>

#include <iosfwd>
#include <string>

// XML to ParameterList and back, with strict reading: a list has a name; a parameter has name, type
// and value; no two entries of a list have the same name; and a value has exactly the given type.
namespace asperity
{
// The root element of a file. InputError if the file is missing, empty or malformed.
Teuchos::XMLObject parseXml(std::string const& file_name);

// Adds the element's entries to the list and replaces those that are there, list by list; what
// <Remove name="..."/> names is taken out before what follows it is read.
// InputError with `file_name` and the path of the entry.
void readList(Teuchos::XMLObject const& element, std::string const& file_name,
              std::string const& path, Teuchos::ParameterList& list);

// With & < > " replaced for use in an attribute.
std::string xmlEscaped(std::string const& text);

// <Parameter name="..." type="..." value="..."/>, with isDefault="true" where the entry says so.
std::string xmlParameter(std::string const& name, Teuchos::ParameterEntry const& entry);

// The list as <ParameterList>, indented by `depth` steps.
void writeXml(Teuchos::ParameterList const& list, std::string const& name, std::ostream& out,
              int depth);
} // namespace asperity
