#pragma once

#include "base/Types.hpp"
#include "io/checkpoint/Archive.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace asperity::io
{
// A table in text, written by rank 0, that a restart cuts back to where the checkpoint was made.
class TextTable
{
public:
  // Nothing is touched before the first row or flush; then the folder is made and the file begins
  // with the header: any number of lines, of which the last one names the columns.
  TextTable(std::filesystem::path file, std::string header, RCP<const Communicator> comm);

  // Without the end of the line. Ignored on other ranks.
  void writeRow(std::string const& row);

  // Replaces the header by one of the same length, on disk after the next flush.
  void setHeader(std::string const& header);

  // On disk afterwards. Collective; InputError on every rank if writing has failed.
  void flush();

  // How much has been written; call flush first.
  void save(Archive& archive) const;

  // Removes what was written after the archive. InputError if the file is shorter, has other
  // columns or a header of another length; one of the same length is replaced. Collective.
  void restore(Archive const& archive);

private:
  void open();
  void requireEarlierTable(Archive const& archive) const;
  void writeLine(std::string const& line);

  std::filesystem::path file_;
  std::string header_;
  RCP<const Communicator> comm_;
  std::ofstream stream_;
  std::int64_t num_bytes_ = 0;
};

// Numbers as the tables have them: times so that they read back exactly, others with 8 digits.
std::string exactNumber(double value); // %.17g
std::string shortNumber(double value); // %.8g

// "slip [m]", or the name alone if there is no unit ("" or "-").
std::string columnName(std::string const& name, std::string const& unit);
} // namespace asperity::io
