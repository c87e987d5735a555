#include "io/files/TextTable.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/WriteFailure.hpp"
#include "base/parallel/Agreement.hpp"
#include "io/files/DurableFile.hpp"

#include <sstream>
#include <utility>

namespace asperity::io
{
namespace
{
// The first lines of different length of two headers, or the last ones.
std::pair<std::string, std::string> difference(std::string const& earlier, std::string const& now)
{
  std::istringstream ours(earlier), theirs(now);
  std::string our_line, their_line;
  while (our_line.size() == their_line.size() && !(ours.eof() && theirs.eof())) {
    our_line.clear();
    their_line.clear();
    std::getline(ours, our_line);
    std::getline(theirs, their_line);
  }
  return {our_line, their_line};
}

std::string lastLine(std::string const& text) { return text.substr(text.find_last_of('\n') + 1); }
} // namespace

TextTable::TextTable(std::filesystem::path file, std::string header, RCP<const Communicator> comm)
    : file_(std::move(file))
    , header_(std::move(header))
    , comm_(std::move(comm))
{
}

void TextTable::open()
{
  if (!stream_.is_open()) {
    std::error_code ignored; // without the folder the file cannot be opened: flush() reports it
    std::filesystem::create_directory(file_.parent_path(), ignored);
    stream_.open(file_, std::ios::binary | std::ios::trunc);
    writeLine(header_);
  }
}

void TextTable::writeLine(std::string const& line)
{
  stream_ << line << '\n';
  num_bytes_ += static_cast<std::int64_t>(line.size()) + 1;
}

void TextTable::writeRow(std::string const& row)
{
  if (comm_->getRank() == 0) {
    open();
    writeLine(row);
    rows_.add(row);
  }
}

void TextTable::setHeader(std::string const& header)
{
  ASPERITY_ASSERT(header.size() == header_.size());
  header_ = header;
}

void TextTable::flush()
{
  onRoot(*comm_, [&] {
    open();
    stream_.seekp(0);
    stream_ << header_;
    stream_.seekp(num_bytes_);
    requireWritten(stream_, file_);
    detail::synchronise(file_);
  });
}

void TextTable::save(Archive& archive) const
{
  archive.set("num_bytes", num_bytes_);
  archive.set("header_bytes", header_.size());
  archive.set("rows", hexadecimal(rows_.value()));
}

void TextTable::requireEarlierRows(Archive const& archive)
{
  std::ifstream file(file_, std::ios::binary);
  const auto num_bytes = archive.getInteger("num_bytes");
  auto position = archive.getInteger("header_bytes") + 1;
  file.seekg(position);
  for (std::string row; position < num_bytes && std::getline(file, row);) {
    rows_.add(row);
    position += static_cast<std::int64_t>(row.size()) + 1;
  }
  ASPERITY_REQUIRE(hexadecimal(rows_.value()) == archive.get<std::string>("rows"),
                   file_.string() << " is not the table that the checkpoint continues: a row that "
                                     "the run had written has been changed. Put the file back as "
                                     "it was, or begin a new run from the checkpoint with "
                                     "--restart-from.");
}

void TextTable::requireEarlierTable(Archive const& archive) const
{
  std::error_code error;
  const auto size = std::filesystem::file_size(file_, error);
  ASPERITY_REQUIRE(!error, file_.string() << " cannot be continued: " << error.message()
                                          << ". Restart in the directory of the earlier run.");
  const auto num_bytes = archive.getInteger("num_bytes");
  ASPERITY_REQUIRE(static_cast<std::int64_t>(size) >= num_bytes,
                   file_.string() << " is not the table that the checkpoint continues: it has "
                                  << size << " bytes, but had " << num_bytes
                                  << " at the checkpoint. Put the file back as it was, or begin a "
                                     "new run from the checkpoint with --restart-from.");
  std::string header(archive.getInteger("header_bytes"), '\0');
  std::ifstream(file_, std::ios::binary)
    .read(header.data(), static_cast<std::streamsize>(header.size()));
  const bool is_same = header.size() == header_.size() && lastLine(header) == lastLine(header_);
  const auto [earlier, now] = difference(header, header_);
  ASPERITY_REQUIRE(is_same, file_.string()
                              << " is not the table that the checkpoint continues: its "
                                 "header has the line '"
                              << earlier << "', where that of this run has '" << now
                              << "'. Restart with the deck of the earlier run.");
}

void TextTable::restore(Archive const& archive)
{
  onRoot(*comm_, [&] {
    requireEarlierTable(archive);
    requireEarlierRows(archive);
    num_bytes_ = archive.getInteger("num_bytes");
    std::error_code error;
    std::filesystem::resize_file(file_, num_bytes_, error);
    if (error) {
      throw OutputError(file_.string() + " cannot be cut: " + error.message() + ".");
    }
    stream_.open(file_, std::ios::binary | std::ios::in | std::ios::out);
    stream_.seekp(num_bytes_);
  });
}

std::string exactNumber(double value) { return formatted("%.17g", value); }

std::string shortNumber(double value) { return formatted("%.8g", value); }

std::string columnName(std::string const& name, std::string const& unit)
{
  return unit.empty() || unit == "-" ? name : name + " [" + unit + "]";
}
} // namespace asperity::io
