#include "io/platforms/PlatformStations.hpp"

#include "base/Text.hpp"

namespace asperity::io::detail
{
namespace
{
PlatformContent contentOf(PlatformStations::Station const& station, PlatformColumns const& columns)
{
  PlatformContent content;
  content.name = station.file;
  content.location = station.location;
  std::vector<std::string> descriptions{"Time (s)"};
  content.fields = "t";
  for (auto const& column : columns) {
    descriptions.emplace_back(column.description);
    content.fields += std::string(" ") + column.name;
  }
  content.remarks = columnRemarks(descriptions);
  return content;
}
} // namespace

PlatformStations::PlatformStations(TextFormat const& format, std::filesystem::path const& directory,
                                   std::vector<Station> const& stations,
                                   PlatformColumns const& columns,
                                   RCP<const Communicator> const& comm)
    : format_(format)
    , columns_(columns)
{
  for (auto const& station : stations) {
    files_.emplace_back(format, directory, contentOf(station, columns), comm);
  }
}

void PlatformStations::write(double time, std::map<std::string, std::vector<double>> const& sampled)
{
  Rows now;
  for (std::size_t station = 0; station < files_.size(); ++station) {
    const auto row = rowOf(columns_, sampled, station, files_.size());
    now.insert(now.end(), row.begin(), row.end());
  }
  if (format_.platform == Platform::seas) {
    writeRows(time, now);
    return;
  }
  for (; num_rows_ * format_.time_step <= time; ++num_rows_) {
    const double row_time = num_rows_ * format_.time_step;
    Rows row = now;
    if (!previous_.empty() && time > previous_time_) {
      const double part = (row_time - previous_time_) / (time - previous_time_);
      for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] = previous_[i] + part * (now[i] - previous_[i]);
      }
    }
    writeRows(row_time, row);
  }
  previous_time_ = time;
  previous_ = now;
}

void PlatformStations::writeRows(double time, Rows const& rows)
{
  for (std::size_t station = 0; station < files_.size(); ++station) {
    files_[station].writeRow(time, &rows[station * columns_.size()], columns_.size());
  }
}

std::string PlatformStations::signature() const
{
  std::string text =
    std::string(platformName(format_.platform)) + ' ' + formatNumber(format_.time_step) + " s";
  for (auto const& column : columns_) {
    text += std::string(" ") + column.name;
  }
  return text + '\n';
}

void PlatformStations::flush(StepFacts const& steps)
{
  StepFacts facts = steps;
  if (format_.platform == Platform::scec) {
    facts.count = num_rows_;
  }
  for (auto& file : files_) {
    file.flush(facts);
  }
}

void PlatformStations::save(Archive& archive) const
{
  archive.set("num_rows", num_rows_);
  archive.set("previous_time", previous_time_);
  archive.set("previous", previous_);
  for (std::size_t i = 0; i < files_.size(); ++i) {
    Archive file;
    files_[i].save(file);
    archive.insert("file_" + std::to_string(i), file);
  }
}

void PlatformStations::restore(Archive const& archive)
{
  num_rows_ = archive.getInteger("num_rows");
  previous_time_ = archive.getDouble("previous_time");
  previous_ = archive.get<std::vector<double>>("previous");
  for (std::size_t i = 0; i < files_.size(); ++i) {
    files_[i].restore(archive.child("file_" + std::to_string(i)));
  }
}
} // namespace asperity::io::detail
