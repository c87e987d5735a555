#pragma once

#include "base/Archive.hpp"
#include "base/Hashes.hpp"
#include "base/Types.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace asperity::io
{
// A table in text, written by rank 0; a restart cuts it back to its length at the checkpoint.
class TextTable
{
public:
  // The constructor touches no file. The first row or flush makes the folder and the file, which
  // begins with the header, a line that names the columns.
  TextTable(std::filesystem::path file, std::string header, RCP<const Communicator> comm);

  // `row` has no end of line. Ignored on ranks other than 0.
  void writeRow(std::string const& row);

  // Writes everything to disk. Collective; OutputError on every rank if writing has failed.
  void flush();

  // Stores how much has been written, and a checksum of it; call flush first.
  void save(Archive& archive) const;

  // Removes the rows written after the checkpoint. Throws InputError if the file is shorter than
  // then, or has other rows or another header. Collective.
  void restore(Archive const& archive);

private:
  void open();
  void requireEarlierTable(Archive const& archive) const;
  void requireEarlierRows(Archive const& archive);
  void writeLine(std::string const& line);

  std::filesystem::path file_;
  std::string header_;
  RCP<const Communicator> comm_;
  std::ofstream stream_;
  std::int64_t num_bytes_ = 0;
  Checksum rows_; // without the header
};

// Numbers as text for tables: times, which must read back exactly, and others with 8 digits.
std::string exactNumber(double value); // %.17g
std::string shortNumber(double value); // %.8g

// "slip [m]", or the name alone if there is no unit ("" or "-").
std::string columnName(std::string const& name, std::string const& unit);
} // namespace asperity::io
