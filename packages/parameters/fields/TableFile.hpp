#pragma once

#include "parameters/fields/TableFunction.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity
{
// A text file with columns between commas, as Asperity writes them: a line of names, each with its
// unit in brackets, "depth [km], vp [km/s]", and a line of the same number of pieces for each row.
// Lines that begin with # and empty lines do not count.
class TableFile
{
public:
  // InputError, with `path` of the entry that names it, unless there is such a file, and each row
  // has as many pieces as the first line.
  TableFile(std::string const& file_name, std::string const& path);

  struct Column
  {
    std::string name, name_path; // as the deck names it, and the path of that entry
    std::string unit, unit_path; // likewise; empty if the deck names none
  };
  // Two columns, in SI units: their unit is that in brackets, else that of the deck, else SI.
  // InputError unless there is one column of each name, for a unit that is unknown or not that of
  // the deck, and for pieces that are no finite number.
  TableRows rows(Column const& argument, Column const& value) const;

private:
  struct Heading
  {
    std::string name, unit;
    bool has_unit;
  };
  std::size_t indexOf(Column const& column) const;
  std::string unitOf(Column const& column, Heading const& heading) const;
  double number(std::size_t row, std::size_t column) const;

  std::string file_name_, path_;
  std::vector<Heading> headings_;
  std::vector<std::vector<std::string>> pieces_; // (num rows, num columns)
  std::vector<std::string> places_;              // (num rows)
};

// The checksum of the bytes of a file. InputError with `path` if it cannot be read.
std::uint64_t checksumOfFile(std::string const& file_name, std::string const& path);
} // namespace asperity
