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
  io::Archive steps;
  steps_.save(steps);
  archive.insert("steps", steps);
  for (auto const& [name, part] : parts_) {
    io::Archive of_part;
    part->save(of_part);
    archive.insert(name, of_part);
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
