#include "io/files/RunLog.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"

#include <algorithm>
#include <fcntl.h>
#include <iostream>
#include <sstream>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace asperity::io
{
namespace
{
double fractionDone(Progress const& progress)
{
  return progress.final_time > 0 ? std::clamp(progress.time / progress.final_time, 0.0, 1.0) : 0;
}

// ", about 1 h 6 min left", or ", 3 min left at this speed" before a whole cycle is known.
std::string describe(TimeLeft::Estimate const& left)
{
  auto const duration = formatDuration(left.seconds);
  return left.knows_cycles ? ", about " + duration + " left"
                           : ", " + duration + " left at this speed";
}

// "t = 612.4 s of 1800 s (34 %), step 12034, dt 0.0313 s, V 5.1e-05 m/s, 3 iterations, 31 events,
// wall 745.2 s, about 24 min left"
std::string describe(Progress const& progress)
{
  std::ostringstream text;
  text << "t = " << formatShort(progress.time) << " s";
  if (progress.final_time > 0) {
    text << " of " << formatShort(progress.final_time) << " s ("
         << static_cast<int>(100 * fractionDone(progress)) << " %)";
  }
  text << ", step " << progress.step << ", dt " << formatShort(progress.step_size) << " s, V "
       << formatted("%.1e", progress.peak_slip_rate) << " m/s, " << progress.fixed_point_iterations
       << " iterations";
  if (progress.num_events) {
    text << ", " << *progress.num_events << (*progress.num_events == 1 ? " event" : " events");
  }
  text << ", wall " << formatShort(progress.wall_time) << " s";
  return text.str() + (progress.left ? describe(*progress.left) : "");
}

// The same for one line of a terminal, which may cut it: the most important values come first.
std::string describeShort(Progress const& progress)
{
  std::string line = formatted(
    "%3d%% t=%.6g s dt=%.3g V=%.1e it=%d", static_cast<int>(100 * fractionDone(progress)),
    progress.time, progress.step_size, progress.peak_slip_rate, progress.fixed_point_iterations);
  if (progress.num_events) {
    line += " events=" + std::to_string(*progress.num_events);
  }
  return line + (progress.left ? " left " + formatDuration(progress.left->seconds) : "");
}

// Reserves space beyond the end of the file, whose size does not change. A failure does no harm.
void keepSpace(std::filesystem::path const& file)
{
  constexpr off_t bytes = 16384;
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor >= 0) {
    struct stat status = {};
    if (::fstat(descriptor, &status) == 0) {
      static_cast<void>(::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, status.st_size, bytes));
    }
    ::close(descriptor);
  }
}
} // namespace

RunLog::Style RunLog::detectStyle()
{
  Style style;
  // mpirun gives a rank a terminal of its own as standard output, even if that goes to a file.
  style.in_place = ::isatty(STDOUT_FILENO) == 1 && ::isatty(STDERR_FILENO) == 1;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    style.width = size.ws_col;
  }
  return style;
}

RunLog::RunLog(std::filesystem::path const& file, bool append, Communicator const& comm)
    : RunLog(file, append, comm, std::cout, detectStyle())
{
}

RunLog::RunLog(std::filesystem::path const& file, bool append, Communicator const& comm,
               std::ostream& terminal, Style const& style)
    : active_(comm.getRank() == 0)
    , path_(file)
    , terminal_(terminal)
    , style_(style)
{
  onRoot(comm, [&] {
    file_.open(file, append ? std::ios::app : std::ios::trunc);
    ASPERITY_REQUIRE(file_, file.string() << " cannot be written. Check the permissions of the "
                                             "output directory.");
  });
}

RunLog::~RunLog()
{
  if (active_) {
    clearLine();
  }
}

void RunLog::message(std::string const& text)
{
  if (!active_) {
    return;
  }
  clearLine();
  terminal_ << text << std::endl;
  write(text);
}

void RunLog::note(std::string const& text)
{
  if (active_) {
    write(text);
  }
}

void RunLog::write(std::string const& line)
{
  file_.clear(); // after a failure the next line may succeed
  file_ << line << std::endl;
  keepSpace(path_);
}

bool RunLog::progress(Progress const& progress)
{
  if (!active_) {
    return false;
  }
  const bool is_due = isDue(progress);
  if (is_due) {
    const std::string line = describe(progress);
    write(line);
    if (!style_.in_place) {
      terminal_ << line << std::endl;
    }
  }
  const bool is_fresh =
    line_is_open_ && progress.wall_time - last_update_ < style_.seconds_per_update;
  if (style_.in_place && !is_fresh) {
    updateLine(describeShort(progress));
    last_update_ = progress.wall_time;
  }
  return is_due;
}

bool RunLog::isDue(Progress const& progress)
{
  const int twentieth = static_cast<int>(20 * fractionDone(progress));
  last_twentieth_ = last_twentieth_ < 0 ? twentieth : last_twentieth_;
  const bool is_due =
    twentieth > last_twentieth_ || progress.wall_time - last_line_ >= style_.seconds_per_line;
  if (is_due) {
    last_twentieth_ = twentieth;
    last_line_ = progress.wall_time;
  }
  return is_due;
}

// One column stays free: some terminals wrap when the last one is used.
void RunLog::updateLine(std::string line)
{
  line.resize(std::max(1, style_.width - 1), ' ');
  terminal_ << '\r' << line << std::flush;
  line_is_open_ = true;
}

void RunLog::clearLine()
{
  if (line_is_open_) {
    terminal_ << '\r' << std::string(std::max(1, style_.width - 1), ' ') << '\r' << std::flush;
    line_is_open_ = false;
  }
}
} // namespace asperity::io
