#pragma once

#include "base/Types.hpp"
#include "io/files/Progress.hpp"

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

namespace asperity::io
{
// Tells the user how the run goes: on a terminal by one line that is updated in place, elsewhere by
// a line every 30 s of wall time and at each 5 % of simulated time. DIR/run.log always gets these
// lines, and all messages. The wall time of a Progress says whether a line is due. Some space on
// the disk is kept for the file, where the file system can, so that it says why a run has ended
// even if the disk is full. Only rank 0 writes; on other ranks every function returns at once.
class RunLog
{
public:
  struct Style
  {
    bool in_place = false;        // a terminal: one line, rewritten
    int width = 80;               // columns of the terminal
    double seconds_per_line = 30; // wall time between lines
    double seconds_per_update = 0.1;
  };
  // The style for standard output: in_place if that and standard error are terminals, with its
  // width.
  static Style detectStyle();

  // Appends to `file` if `append` is true (after a restart), otherwise starts a new file. Throws
  // InputError on every rank if the file cannot be opened.
  RunLog(std::filesystem::path const& file, bool append, Communicator const& comm);
  RunLog(std::filesystem::path const& file, bool append, Communicator const& comm,
         std::ostream& terminal, Style const& style);
  ~RunLog();

  // Whether a line has gone to the file.
  bool progress(Progress const& progress);
  void message(std::string const& text);
  // Writes to the file alone, for text that reaches the terminal in another way.
  void note(std::string const& text);

private:
  void write(std::string const& line);
  bool isDue(Progress const& progress);
  void updateLine(std::string line);
  void clearLine();

  bool active_;
  std::filesystem::path path_;
  std::ofstream file_;
  std::ostream& terminal_;
  Style style_;
  double last_line_ = 0, last_update_ = 0; // wall times [s]
  int last_twentieth_ = -1; // of the simulated time; -1 before the first progress of this process
  bool line_is_open_ = false;
};
} // namespace asperity::io
