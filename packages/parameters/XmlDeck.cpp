#include "parameters/XmlDeck.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/Parameters.hpp"

#include <Teuchos_ParameterEntryXMLConverterDB.hpp>
#include <Teuchos_StringInputSource.hpp>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <ostream>
#include <set>

namespace asperity
{
using Teuchos::ParameterEntry;
using Teuchos::XMLObject;

namespace
{
// Teuchos's message is the last paragraph, after source line, throw number and failed test.
std::string lastParagraph(std::string const& text)
{
  const std::string body = trimmed(text);
  const auto blank = body.rfind("\n\n");
  return blank == std::string::npos ? body : trimmed(body.substr(blank));
}

std::string attribute(XMLObject const& element, std::string const& name, std::string const& where)
{
  ASPERITY_REQUIRE(element.hasAttribute(name),
                   where << ": a <" << element.getTag() << "> has no attribute '" << name << "'.");
  return element.getAttribute(name);
}

// Teuchos reads other types, which foreign lists may use.
ParameterEntry readForeign(XMLObject const& element, std::string const& where)
{
  try {
    return Teuchos::ParameterEntryXMLConverterDB::convertXML(element);
  } catch (std::exception const& error) {
    throw InputError(where + ": " + lastParagraph(error.what()));
  }
}

// nullopt if the value is not of the type.
std::optional<ParameterEntry> readAs(std::string const& type, std::string const& value)
{
  const auto entry = [](auto const& read) {
    return read ? std::optional(ParameterEntry(*read)) : std::nullopt;
  };
  if (type == "bool") {
    const std::string word = trimmed(value);
    return entry(word == "true"    ? std::optional(true)
                 : word == "false" ? std::optional(false)
                                   : std::nullopt);
  }
  if (type == "int") {
    return entry(readInteger(value));
  }
  if (type == "Array(double)" || type == "Array(int)") {
    const auto inside = insideBraces(value);
    return !inside                ? std::nullopt
           : type == "Array(int)" ? readArray(*inside, readInteger)
                                  : readArray(*inside, readNumber);
  }
  if (const auto number = readNumber(value)) {
    return ParameterEntry(*number);
  }
  const bool may_be_formula = !value.empty() && value != "nan" && value != "inf";
  return may_be_formula ? std::optional(ParameterEntry(value)) : std::nullopt;
}

ParameterEntry readValue(XMLObject const& element, std::string const& where)
{
  const std::string type = attribute(element, "type", where);
  const std::string value = attribute(element, "value", where);
  if (type == "string") {
    return ParameterEntry(value);
  }
  static const std::set<std::string> known_types = {"bool",       "int",    "Array(double)",
                                                    "Array(int)", "double", "float"};
  if (known_types.count(type) == 0) {
    return readForeign(element, where);
  }
  const auto entry = readAs(type, value);
  ASPERITY_REQUIRE(entry, where << ": the value '" << excerpt(value) << "' is not of the type '"
                                << type << "' given with it.");
  return *entry;
}

// <Remove name="..."/> in an overlay.
void removeEntry(ParameterList& list, std::string const& name, std::string const& where)
{
  ASPERITY_REQUIRE(list.isParameter(name), where << ": <Remove> finds no such entry in the deck."
                                                 << didYouMean(name, namesIn(list)));
  list.remove(name);
}

std::string contentOf(std::string const& file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// A deck in UTF-8. Editors may begin a file with a byte-order mark, which Teuchos does not know.
std::string withoutMark(std::string text, std::string const& file_name)
{
  const std::string begin = text.substr(0, 2);
  const bool is_utf16 = begin == "\xFF\xFE" || begin == "\xFE\xFF" ||
                        begin == std::string("<\0", 2) || begin == std::string("\0<", 2);
  ASPERITY_REQUIRE(!is_utf16, "The deck '" << file_name
                                           << "' is in UTF-16. Save it in UTF-8, or convert it: "
                                              "iconv -f UTF-16 -t UTF-8 OLD.xml > NEW.xml");
  return text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? text.substr(3) : text;
}

// Teuchos builds and destroys its tree recursively: deeply nested lists would overflow the stack.
void refuseDeepLists(std::string const& text, std::string const& file_name)
{
  constexpr int deepest = 100;
  const auto begins = [&](std::size_t i, char const* with) {
    return text.compare(i, std::strlen(with), with) == 0;
  };
  int depth = 0;
  for (std::size_t i = text.find_first_of("</"); i < text.size();
       i = text.find_first_of("</", i + 1)) {
    if (begins(i, "<!--")) {
      i = std::min(text.find("-->", i), text.size() - 1);
    } else if (begins(i, "</") || begins(i, "/>")) {
      --depth;
    } else if (text[i] == '<' && std::isalpha(static_cast<unsigned char>(text[i + 1])) != 0) {
      ++depth;
    }
    ASPERITY_REQUIRE(depth <= deepest, "The deck '" << file_name << "' has lists nested more than "
                                                    << deepest
                                                    << " deep. Use fewer levels of lists.");
  }
}
} // namespace

XMLObject parseXml(std::string const& file_name)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  ASPERITY_REQUIRE(fs::exists(file_name, ignored), "There is no deck '" << file_name << "'.");
  ASPERITY_REQUIRE(!fs::is_directory(file_name, ignored),
                   "The deck '" << file_name
                                << "' is a directory; the name of an XML file is wanted.");
  const std::string text = withoutMark(contentOf(file_name), file_name);
  refuseDeepLists(text, file_name);
  try {
    return Teuchos::StringInputSource(text).getObject();
  } catch (std::exception const& error) {
    const std::string reason = lastParagraph(error.what());
    std::string hint;
    if (reason.find("attribute value") != std::string::npos) {
      hint = " In a value write &lt; for < and &amp; for &.";
    } else if (reason.find("comment") != std::string::npos) {
      hint = " A comment must not contain '--'.";
    }
    throw InputError("The deck '" + file_name + "' cannot be read: " + reason + "." + hint);
  }
}

void readList(XMLObject const& element, std::string const& file_name, std::string const& path,
              Teuchos::ParameterList& list)
{
  std::set<std::string> names;
  for (int i = 0; i < element.numChildren(); ++i) {
    XMLObject const& child = element.getChild(i);
    std::string const& tag = child.getTag();
    const std::string here = file_name + ": " + path;
    ASPERITY_REQUIRE(tag == "Parameter" || tag == "ParameterList" || tag == "Remove",
                     here << ": <" << tag
                          << "> is unknown; only <Parameter>, <ParameterList> and, in overlays, "
                             "<Remove> are allowed.");
    const std::string name = attribute(child, "name", here);
    const std::string entry_path = joinPath(path, name);
    if (tag == "Remove") {
      removeEntry(list, name, file_name + ": " + entry_path);
      continue;
    }
    ASPERITY_REQUIRE(names.insert(name).second,
                     file_name << ": " << entry_path << " is given twice.");
    if (tag == "Parameter") {
      list.setEntry(name, readValue(child, file_name + ": " + entry_path));
    } else {
      if (list.isParameter(name) && !list.isSublist(name)) {
        list.remove(name);
      }
      readList(child, file_name, entry_path, list.sublist(name));
    }
  }
}

std::string xmlEscaped(std::string const& text)
{
  std::string escaped;
  for (const char letter : text) {
    switch (letter) {
    case '&': escaped += "&amp;"; break;
    case '<': escaped += "&lt;"; break;
    case '>': escaped += "&gt;"; break;
    case '"': escaped += "&quot;"; break;
    default: escaped += letter;
    }
  }
  return escaped;
}

std::string xmlParameter(std::string const& name, ParameterEntry const& entry)
{
  return "<Parameter name=\"" + xmlEscaped(name) + "\" type=\"" + xmlType(entry) + "\" value=\"" +
         xmlEscaped(plainText(entry)) + "\"" + (entry.isDefault() ? " isDefault=\"true\"" : "") +
         "/>";
}

void writeXml(Teuchos::ParameterList const& list, std::string const& name, std::ostream& out,
              int depth)
{
  const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  out << indent << "<ParameterList name=\"" << xmlEscaped(name) << "\">\n";
  for (auto const& item : list) {
    if (item.second.isList()) {
      writeXml(get<Teuchos::ParameterList>(item.second), item.first, out, depth + 1);
    } else {
      out << indent << "  " << xmlParameter(item.first, item.second) << '\n';
    }
  }
  out << indent << "</ParameterList>\n";
}
} // namespace asperity
