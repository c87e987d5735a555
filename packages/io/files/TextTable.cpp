#include "io/files/TextTable.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/WriteFailure.hpp"
#include "base/parallel/Agreement.hpp"
#include "io/files/DurableFile.hpp"

#include <utility>

namespace asperity::io
{
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

void TextTable::flush()
{
  onRoot(*comm_, [&] {
    open();
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
  ASPERITY_REQUIRE(header == header_, file_.string()
                                        << " is not the table that the checkpoint continues: its "
                                           "header is '"
                                        << header << "', that of this run '" << header_
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
