#include "platforms/PlatformFiles.hpp"

namespace asperity::platforms
{
void PlatformFiles::write(io::StepInfo const& step)
{
  steps_.add(step);
  for (auto& [name, part] : parts_) {
    part->write(step);
  }
}

void PlatformFiles::closeSegment(int)
{
  for (auto& [name, part] : parts_) {
    part->flush(steps_);
  }
}

void PlatformFiles::save(io::Archive& archive) const
{
  archive.insert("steps", steps_);
  for (auto const& [name, part] : parts_) {
    archive.insert(name, *part);
  }
}

void PlatformFiles::restore(io::Archive const& archive)
{
  steps_.restore(archive.child("steps"));
  for (auto& [name, part] : parts_) {
    part->restore(archive.child(name));
  }
}
} // namespace asperity::platforms
