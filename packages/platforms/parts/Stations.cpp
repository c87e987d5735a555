#include "platforms/parts/Stations.hpp"

#include "base/Text.hpp"

namespace asperity::platforms
{
namespace
{
FileContent contentOf(Stations::Kind const& kind, catalogue::ReceiverGroup const& group,
                      std::size_t station)
{
  FileContent content;
  content.name = kind.prefix + group.name(station);
  content.place = kind.where + ", " + group.placeText(station);
  std::vector<std::string> descriptions{"Time (s)"};
  content.fields = "t";
  for (auto const& column : kind.columns) {
    descriptions.emplace_back(column.description);
    content.fields += std::string(" ") + column.name;
  }
  content.remarks = columnRemarks(descriptions);
  return content;
}
} // namespace

Stations::Stations(Platform const& platform, io::OutputContext const& context, Kind kind,
                   catalogue::Receivers const& receivers, catalogue::ReceiverGroup const& group)
    : platform_(platform.name)
    , kind_(std::move(kind))
    , receivers_(receivers)
    , group_(group)
{
  for (auto const& name : fieldsOf(kind_.columns)) {
    fields_.push_back(&context.fields.field(group.domain().name, name));
  }
  for (std::size_t station = 0; station < group.size(); ++station) {
    files_.emplace_back(platform, contentOf(kind_, group, station), context);
  }
}

Stations::Rows Stations::sample() const
{
  std::map<std::string, std::vector<double>> sampled;
  for (auto const* field : fields_) {
    sampled[field->name] = group_.sample(*field);
  }
  Rows rows;
  for (std::size_t station = 0; station < files_.size(); ++station) {
    const auto row = rowOf(kind_.columns, sampled, station, files_.size());
    rows.insert(rows.end(), row.begin(), row.end());
  }
  return rows;
}

void Stations::write(io::StepInfo const& step)
{
  if (kind_.row_distance > 0) {
    writeRowsUntil(step.time, sample());
  } else if (receivers_.hasRow()) {
    writeRows(step.time, sample());
  }
}

void Stations::writeRowsUntil(double time, Rows const& now)
{
  const auto next = [this] { return static_cast<double>(num_rows_) * kind_.row_distance; };
  for (; next() <= time; ++num_rows_) {
    const double row_time = next();
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

void Stations::writeRows(double time, Rows const& rows)
{
  const std::size_t num_columns = kind_.columns.size();
  for (std::size_t station = 0; station < files_.size(); ++station) {
    files_[station].writeRow(time, &rows[station * num_columns], num_columns);
  }
}

void Stations::flush(StepFacts const& steps)
{
  StepFacts facts = steps;
  if (kind_.row_distance > 0) {
    facts.count = num_rows_;
  }
  for (auto& file : files_) {
    file.flush(facts);
  }
}

void Stations::save(io::Archive& archive) const
{
  archive.set("row_distance", kind_.row_distance);
  archive.set("num_rows", num_rows_);
  archive.set("previous_time", previous_time_);
  archive.set("previous", previous_);
  for (std::size_t i = 0; i < files_.size(); ++i) {
    archive.insert("file_" + std::to_string(i), files_[i]);
  }
}

void Stations::restore(io::Archive const& archive)
{
  const double earlier = archive.getDouble("row_distance");
  ASPERITY_REQUIRE(earlier == kind_.row_distance,
                   "Asperity / Output: `" << platform_ << " / Time Step` is "
                                          << formatNumber(kind_.row_distance) << " s, but it was "
                                          << formatNumber(earlier)
                                          << " s in the run that wrote the checkpoint. Restart "
                                             "with the Time Step of that run.");
  num_rows_ = archive.getInteger("num_rows");
  previous_time_ = archive.getDouble("previous_time");
  previous_ = archive.get<std::vector<double>>("previous");
  for (std::size_t i = 0; i < files_.size(); ++i) {
    files_[i].restore(archive.child("file_" + std::to_string(i)));
  }
}

void addStations(PlatformFiles& files, Platform const& platform, io::OutputContext const& context,
                 catalogue::Receivers const& receivers, KindOf const& on_fault,
                 KindOf const& in_body)
{
  const auto add = [&](std::string const& name, catalogue::ReceiverGroup const* group,
                       KindOf const& kind) {
    if (group != nullptr) {
      files.add(name, std::make_unique<Stations>(platform, context, kind(ModelView::of(context)),
                                                 receivers, *group));
    }
  };
  add("on_fault", receivers.onFault(), on_fault);
  add("off_fault", receivers.inBody(), in_body);
}
} // namespace asperity::platforms
