#include "io/files/RunJournal.hpp"

#include "base/Text.hpp"

#include <chrono>
#include <cmath>

namespace asperity::io
{
namespace
{
// A string of JSON. Bytes that are not UTF-8, as in the name of a file, are written unchanged.
std::string quoted(std::string const& text)
{
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') {
      result += '\\';
    }
    if (static_cast<unsigned char>(letter) < 0x20) {
      result += formatted("\\u%04x", static_cast<unsigned>(letter));
    } else {
      result += letter;
    }
  }
  return result + '"';
}

std::string member(std::string const& name, std::string const& json)
{
  return ", " + quoted(name) + ": " + json;
}
// A number, or an array of several; of JSON, which has no inf and nan.
std::string number(double value) { return std::isfinite(value) ? formatNumber(value) : "null"; }

std::string numbers(std::vector<double> const& values)
{
  if (values.size() == 1) {
    return number(values.front());
  }
  std::string text;
  for (const double value : values) {
    text += (text.empty() ? "[" : ", ") + number(value);
  }
  return text + ']';
}
} // namespace

RunJournal::RunJournal(std::filesystem::path const& file, bool append, Communicator const& comm)
{
  if (comm.getRank() == 0) {
    file_.open(file, append ? std::ios::app : std::ios::trunc);
  }
  const std::chrono::duration<double> clock = std::chrono::system_clock::now().time_since_epoch();
  write("begin", member("clock", formatNumber(clock.count())));
}

void RunJournal::at(std::int64_t step, double time)
{
  step_ = step;
  time_ = time;
}

void RunJournal::fault(Facts const& facts)
{
  std::string more;
  for (auto const& [name, values] : facts) {
    more += member(name, numbers(values));
  }
  write("fault", more);
}

void RunJournal::restart() { write("restart", ""); }

void RunJournal::warn(Warning const& warning)
{
  recorded_[warning.topic] = {warning.text, step_, time_};
  write("warning", member("topic", quoted(warning.topic)) + member("text", quoted(warning.text)));
}

std::set<std::string> RunJournal::topics() const
{
  std::set<std::string> topics;
  for (auto const& [topic, recorded] : recorded_) {
    topics.insert(topic);
  }
  return topics;
}

void RunJournal::save(Archive& archive) const
{
  archive.set("number", recorded_.size());
  int i = 0;
  for (auto const& [topic, recorded] : recorded_) {
    const std::string path = std::to_string(i++);
    archive.set(path + "/topic", topic);
    archive.set(path + "/text", recorded.text);
    archive.set(path + "/step", recorded.step);
    archive.set(path + "/time", recorded.time);
  }
}

std::vector<Warning> RunJournal::repeat(Archive const& archive)
{
  std::vector<Warning> repeated;
  const auto number = archive.getInteger("number");
  const auto step = step_;
  const double time = time_;
  for (std::int64_t i = 0; i < number; ++i) {
    const std::string path = std::to_string(i);
    const Warning warning{archive.get<std::string>(path + "/topic"),
                          archive.get<std::string>(path + "/text")};
    if (recorded_.count(warning.topic) == 0) {
      at(archive.getInteger(path + "/step"), archive.getDouble(path + "/time"));
      warn(warning);
      repeated.push_back(warning);
    }
  }
  at(step, time);
  return repeated;
}

void RunJournal::progress(Progress const& progress)
{
  std::string more = member("wall_time", formatShort(progress.wall_time)) +
                     member("peak_slip_rate", formatShort(progress.peak_slip_rate));
  if (progress.num_events) {
    more += member("events", std::to_string(*progress.num_events));
  }
  if (auto const& left = progress.left) {
    more += member("seconds_left", formatShort(left->seconds)) +
            member("knows_cycles", left->knows_cycles ? "true" : "false");
  }
  write("progress", more);
}

void RunJournal::end(std::string const& how, int exit_status, std::string const& message,
                     double wall_time, std::string const& kind)
{
  write("end", member("how", quoted(how)) + member("exit_status", std::to_string(exit_status)) +
                 member("message", quoted(message)) + member("wall_time", formatShort(wall_time)) +
                 (kind.empty() ? "" : member("kind", quoted(kind))));
}

void RunJournal::write(std::string const& event, std::string const& more)
{
  if (file_.is_open()) {
    file_.clear(); // after a failure the next line may succeed
    file_ << "{\"event\": " << quoted(event) << member("step", std::to_string(step_))
          << member("time", formatNumber(time_)) << more << '}' << std::endl;
  }
}
} // namespace asperity::io
