#include "io/platforms/TextFormat.hpp"

#include <ctime>

namespace asperity::io
{
namespace
{
Declare aboutTheRun(std::string const& problem)
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
          "shortest "
          "one.");
  return parameters;
}

std::string today()
{
  const std::time_t now = std::time(nullptr);
  std::tm calendar{};
  gmtime_r(&now, &calendar);
  char text[16];
  std::strftime(text, sizeof text, "%Y/%m/%d", &calendar);
  return text;
}
} // namespace

char const* platformName(Platform platform)
{
  static constexpr char const* names[] = {"None", "SEAS", "SCEC"};
  return names[static_cast<int>(platform)];
}

std::filesystem::path TextFormat::folder() const
{
  return platform == Platform::seas ? "seas" : "scec";
}

void TextFormat::declare(Declare& parameters)
{
  auto scec = aboutTheRun("TPV");
  scec.real("Time Step", 0.01, "s", Range::positive(),
            "Two rows are this time apart, as the platform demands.");
  parameters.choiceOfLists(
    "Text Format", std::string("None"),
    {{"None", Declare().list()},
     {"SEAS", aboutTheRun("SEAS Benchmark").list()},
     {"SCEC", scec.list()}},
    "Selects the platform for comparing codes for which additional text files are written: time "
    "series of the receivers and rupture times; for SEAS also slip profiles and the moment rate.");
}

TextFormat TextFormat::from(Teuchos::ParameterList const& output)
{
  ParameterList list;
  for (char const* name : {"None", "SEAS", "SCEC"}) {
    if (output.isSublist(name)) {
      list.sublist(name) = output.sublist(name);
    }
  }
  if (output.isParameter("Text Format")) {
    list.setEntry("Text Format", output.getEntry("Text Format"));
  }
  Declare valid;
  declare(valid);
  completeAndValidate(list, *valid.list(), "Asperity / Output");

  TextFormat format;
  auto const name = list.get<std::string>("Text Format");
  if (name == "None") {
    return format;
  }
  auto const& about = list.sublist(name);
  format.platform = name == "SEAS" ? Platform::seas : Platform::scec;
  format.problem = about.get<std::string>("Problem");
  format.author = about.get<std::string>("Author");
  format.date = about.get<std::string>("Date").empty() ? today() : about.get<std::string>("Date");
  format.code_version = about.get<std::string>("Code Version");
  format.element_size = about.get<double>("Element Size");
  format.time_step = name == "SCEC" ? about.get<double>("Time Step") : 0;
  return format;
}
} // namespace asperity::io
