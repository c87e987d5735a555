#include "platforms/RunFacts.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "catalogue/receivers/PointLocation.hpp"
#include "parameters/Parameters.hpp"

#include <algorithm>
#include <cctype>
#include <ctime>

namespace asperity::platforms
{
namespace
{
std::string today()
{
  const std::time_t now = std::time(nullptr);
  std::tm calendar{};
  gmtime_r(&now, &calendar);
  char text[16];
  std::strftime(text, sizeof text, "%Y/%m/%d", &calendar);
  return text;
}

// Every line of a header begins with '#': the text after a line end would stand among the data.
std::string oneLine(Teuchos::ParameterList const& parameters, std::string const& name)
{
  auto const& text = parameters.get<std::string>(name);
  const bool is_one_line = std::none_of(text.begin(), text.end(), [](char letter) {
    return std::iscntrl(static_cast<unsigned char>(letter)) != 0;
  });
  ASPERITY_REQUIRE(is_one_line, joinPath(parameters.name(), name)
                                  << " = '" << excerpt(text)
                                  << "' has a line end or another control character, and stands in "
                                     "the files' headers. Write it in one line.");
  return text;
}
} // namespace

Declare RunFacts::declare(std::string const& problem)
{
  Declare parameters;
  parameters.text("Problem", problem, "The platform knows the benchmark by this name.")
    .text("Author", std::string("unknown"),
          "The files give this as the name of the person who ran the benchmark.")
    .text("Date", std::string(""),
          "The files give this as the day of the run, in the form 2024/05/31. If it is empty, they "
          "give the day on which the run was started.")
    .text("Code Version", std::string(ASPERITY_VERSION),
          "The files give this as the version of the program.")
    .real("Element Size", 0.0, "m", Range::atLeast(0),
          "The files give this as the size of the elements on the fault; 0 means the size of the "
          "shortest one, in three dimensions the side of a square that two of them fill.")
    .real("Depth of Upper End", 0.0, "m", Range::any(),
          "The files of rupture times give this distance down dip for the upper end of the fault. "
          "It is not 0 where the model is the part of space below a plane of symmetry and the "
          "problem counts from the surface.");
  return parameters;
}

RunFacts RunFacts::from(Teuchos::ParameterList const& parameters, io::OutputContext const& context)
{
  RunFacts facts;
  facts.problem = oneLine(parameters, "Problem");
  facts.author = oneLine(parameters, "Author");
  facts.date = oneLine(parameters, "Date");
  if (facts.date.empty()) {
    facts.date = today();
  }
  facts.code_version = oneLine(parameters, "Code Version");
  facts.element_size = parameters.get<double>("Element Size");
  facts.depth_of_upper_end = parameters.get<double>("Depth of Upper End");
  if (facts.element_size == 0) {
    facts.element_size = catalogue::shortestElement(context.domain("fault"));
  }
  return facts;
}
} // namespace asperity::platforms
