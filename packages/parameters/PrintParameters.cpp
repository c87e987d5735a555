#include "parameters/Alternatives.hpp"
#include "parameters/Deck.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/XmlDeck.hpp"

#include <ostream>
#include <sstream>

namespace asperity
{
namespace
{
// "default 0.015", "required", "optional"
std::string presenceText(Teuchos::ParameterEntry const& entry, ParameterInfo const& info)
{
  switch (info.presence) {
  case Presence::is_required: return "required";
  case Presence::is_optional: return "optional";
  default: return "default " + valueText(entry);
  }
}

std::string withSpaceBefore(std::string const& text) { return text.empty() ? "" : " " + text; }

// The text of a parameter, without its name.
std::string description(Teuchos::ParameterEntry const& entry, ParameterInfo const& info)
{
  std::string text = info.allowed() + "; " + presenceText(entry, info) + ".";
  if (info.isDimensionless()) {
    const bool is_number = info.kind == ParameterKind::real || info.kind == ParameterKind::field;
    text += is_number ? " Unit: 1." : "";
  } else {
    text += " Unit: " + info.unit + ".";
  }
  return text + withSpaceBefore(entry.docString()) + withSpaceBefore(info.hint);
}

// Alternatives come as lists of their own, headed "Asperity / Friction, with Law = Regularised".
void printText(ParameterList const& valid, std::string const& path, std::ostream& out)
{
  out << path << '\n';
  for (auto const& item : valid) {
    const auto info = parameterInfo(item.second);
    if (!item.second.isList() && !info.is_null()) {
      out << "  " << item.first << "\n      " << description(item.second, *info) << '\n';
    } else if (!item.second.isList()) {
      out << "  " << item.first << " = " << valueText(item.second) << '\n';
    }
  }
  for (auto const& item : valid) {
    if (item.second.isList()) {
      out << '\n';
      if (!item.second.docString().empty()) {
        out << "# " << item.second.docString() << '\n';
      }
      printText(get<ParameterList>(item.second),
                isAlternative(item.second) ? path + ", with " + item.first
                                           : joinPath(path, item.first),
                out);
    }
  }
}

// Two hyphens end a comment.
std::string commentText(std::string text)
{
  for (auto found = text.find("--"); found != std::string::npos; found = text.find("--")) {
    text.replace(found, 2, "- -");
  }
  return text;
}

// The lists that a deck has as the user names them are described, not written.
void describeOpenList(ParameterList const& content, std::string const& name,
                      std::string const& indent, std::ostream& out)
{
  std::ostringstream text;
  printText(content, name, text);
  out << indent << "<!-- A list with any number of entries, named by you:\n"
      << commentText(text.str()) << indent << "-->\n";
}

// The entries that other words of a choice bring instead of those written here.
void describeAlternatives(ParameterList const& with_all, std::string const& name,
                          std::string const& indent, std::ostream& out)
{
  for (auto const& item : with_all) {
    if (!isAlternative(item.second)) {
      continue;
    }
    const auto info = parameterInfo(item.second);
    if (get<std::string>(with_all.getEntry(info->chosen_by)) == info->words.front()) {
      continue;
    }
    std::ostringstream text;
    printText(get<ParameterList>(item.second), name + ", with " + item.first, text);
    out << indent << "<!--\n" << commentText(text.str()) << indent << "-->\n";
  }
}

void printXmlParameter(Teuchos::ParameterEntry const& entry, std::string const& name,
                       std::string const& indent, std::ostream& out)
{
  const auto info = parameterInfo(entry);
  if (!info.is_null()) {
    out << indent << "<!-- " << commentText(description(entry, *info)) << " -->\n";
  }
  const bool is_given = info.is_null() || info->presence == Presence::has_default;
  const std::string parameter = xmlParameter(name, entry);
  out << indent << (is_given ? parameter : "<!-- " + commentText(parameter) + " -->") << '\n';
}

// Prints the list together with the entries that the defaults of its choices bring.
void printXml(ParameterList const& with_all, std::string const& name, std::ostream& out, int depth)
{
  const auto chosen = withChosenEntries(with_all, ParameterList(), name);
  ParameterList const& valid = *chosen;
  const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  out << indent << "<ParameterList name=\"" << xmlEscaped(name) << "\">\n";
  for (auto const& item : valid) {
    auto const& entry = item.second;
    const auto info = parameterInfo(entry);
    if (!entry.isList()) {
      printXmlParameter(entry, item.first, indent + "  ", out);
      continue;
    }
    if (!entry.docString().empty()) {
      out << indent << "  <!-- " << commentText(entry.docString()) << " -->\n";
    }
    if (!info.is_null() && info->kind == ParameterKind::open_sublist) {
      describeOpenList(get<ParameterList>(entry), item.first, indent + "  ", out);
    } else {
      printXml(get<ParameterList>(entry), item.first, out, depth + 1);
    }
  }
  describeAlternatives(with_all, name, indent + "  ", out);
  out << indent << "</ParameterList>\n";
}
} // namespace

void printParameters(ParameterList const& valid, std::ostream& out, ParameterFormat format)
{
  if (format == ParameterFormat::xml) {
    printXml(valid, "Asperity", out, 0);
  } else {
    printText(valid, "Asperity", out);
  }
}
} // namespace asperity
