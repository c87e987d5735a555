#include "platforms/PlatformFiles.hpp"

#include "base/Errors.hpp"

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

void requireFriction(std::string const& format, io::FieldRegistry const& fields)
{
  ASPERITY_REQUIRE(fields.hasField("fault", "normal_stress") || fields.hasField("fault", "theta"),
                   "Asperity / Output / Text Format = "
                     << format
                     << " needs a fault with friction, whose stresses and state its files of "
                        "receivers on the fault have. Leave out 'Text Format'; fault.h5 and "
                        "receivers.h5 have the slip.");
}
} // namespace asperity::platforms
