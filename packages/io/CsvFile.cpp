#include "io/CsvFile.hpp"

#include "base/Errors.hpp"
#include "io/detail/DurableFile.hpp"
#include "io/detail/Gather.hpp"

#include <cstdio>

namespace asperity::io
{
CsvFile::CsvFile(std::filesystem::path file, std::string header, RCP<const Communicator> comm)
  : file_(std::move(file)), header_(std::move(header)), comm_(std::move(comm))
{
}

void CsvFile::open()
{
  if (!stream_.is_open()) {
    stream_.open(file_, std::ios::binary | std::ios::trunc);
    writeLine(header_);
  }
}

void CsvFile::writeLine(std::string const& line)
{
  stream_ << line << '\n';
  num_bytes_ += static_cast<std::int64_t>(line.size()) + 1;
}

void CsvFile::writeRow(std::string const& row)
{
  if (comm_->getRank() == 0) {
    open();
    writeLine(row);
  }
}

void CsvFile::flush()
{
  detail::onRoot(*comm_, [&] {
    open();
    stream_.flush();
    ASPERITY_REQUIRE(stream_, file_.string() << " cannot be written. Is the disk full?");
    detail::synchronise(file_);
  });
}

void CsvFile::save(Archive& archive) const { archive.set("num_bytes", num_bytes_); }

void CsvFile::restore(Archive const& archive)
{
  detail::onRoot(*comm_, [&] {
    num_bytes_ = archive.getInteger("num_bytes");
    std::error_code error;
    const auto size = std::filesystem::file_size(file_, error);
    ASPERITY_REQUIRE(!error, file_.string() << " cannot be continued: " << error.message()
                               << ". Restart in the directory of the earlier run.");
    std::ifstream earlier(file_);
    std::string header;
    std::getline(earlier, header);
    ASPERITY_REQUIRE(header == header_ && static_cast<std::int64_t>(size) >= num_bytes_,
                     file_.string() << " is not the table that the checkpoint continues: it has "
                       << size << " bytes, of which the checkpoint knows " << num_bytes_
                       << ", and the columns " << header << ".");
    std::filesystem::resize_file(file_, num_bytes_, error);
    ASPERITY_REQUIRE(!error, file_.string() << " cannot be cut: " << error.message() << ".");
    stream_.open(file_, std::ios::binary | std::ios::app);
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
