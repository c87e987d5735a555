#include "io/TextTable.hpp"

#include "base/Errors.hpp"
#include "io/detail/DurableFile.hpp"
#include "io/detail/Gather.hpp"

#include <cstdio>

namespace asperity::io
{
namespace
{
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
    std::error_code ignored; // a folder that cannot be made is one that cannot be written to
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
  }
}

void TextTable::setHeader(std::string const& header)
{
  ASPERITY_ASSERT(header.size() == header_.size());
  header_ = header;
}

void TextTable::flush()
{
  detail::onRoot(*comm_, [&] {
    open();
    stream_.seekp(0);
    stream_ << header_;
    stream_.seekp(num_bytes_);
    stream_.flush();
    ASPERITY_REQUIRE(stream_, file_.string() << " cannot be written. Is the disk full?");
    detail::synchronise(file_);
  });
}

void TextTable::save(Archive& archive) const { archive.set("num_bytes", num_bytes_); }

void TextTable::restore(Archive const& archive)
{
  detail::onRoot(*comm_, [&] {
    num_bytes_ = archive.getInteger("num_bytes");
    std::error_code error;
    const auto size = std::filesystem::file_size(file_, error);
    ASPERITY_REQUIRE(!error, file_.string() << " cannot be continued: " << error.message()
                                            << ". Restart in the directory of the earlier run.");
    std::ifstream earlier(file_, std::ios::binary);
    std::string header(header_.size(), '\0');
    earlier.read(header.data(), static_cast<std::streamsize>(header.size()));
    ASPERITY_REQUIRE(
      lastLine(header) == lastLine(header_) && static_cast<std::int64_t>(size) >= num_bytes_,
      file_.string() << " is not the table that the checkpoint continues: it has " << size
                     << " bytes, of which the checkpoint knows " << num_bytes_
                     << ", and the columns " << lastLine(header) << ".");
    std::filesystem::resize_file(file_, num_bytes_, error);
    ASPERITY_REQUIRE(!error, file_.string() << " cannot be cut: " << error.message() << ".");
    stream_.open(file_, std::ios::binary | std::ios::in | std::ios::out);
    stream_.seekp(num_bytes_);
  });
}

namespace
{
std::string formatted(char const* format, double value)
{
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}
} // namespace

std::string exactNumber(double value) { return formatted("%.17g", value); }

std::string shortNumber(double value) { return formatted("%.8g", value); }

std::string columnName(std::string const& name, std::string const& unit)
{
  return unit.empty() || unit == "-" ? name : name + " [" + unit + "]";
}
} // namespace asperity::io
