#pragma once

#include "platforms/TextFile.hpp"

#include <map>
#include <memory>
#include <string>

namespace asperity::platforms
{
// Some files of a platform that belong together, such as the time series of all stations on the
// fault. All functions are collective.
class Part
{
public:
  virtual ~Part() = default;

  // After every accepted step, and once before the first one.
  virtual void write(io::StepInfo const& step) = 0;

  // Writes everything to disk. `steps` are those of the run.
  virtual void flush(StepFacts const& steps) = 0;

  virtual void save(io::Archive& archive) const = 0;
  virtual void restore(io::Archive const& archive) = 0;
};

// All files of a platform.
class PlatformFiles : public io::Output
{
public:
  void add(std::string const& name, std::unique_ptr<Part> part) { parts_[name] = std::move(part); }

  void write(io::StepInfo const& step) override;
  void closeSegment(int index) override;
  void finish() override {}
  void save(io::Archive& archive) const override;
  void restore(io::Archive const& archive) override;

private:
  StepFacts steps_;
  std::map<std::string, std::unique_ptr<Part>> parts_;
};

// InputError, which names the text format, unless the fault has the fields of friction.
void requireFriction(std::string const& format, io::FieldRegistry const& fields);
} // namespace asperity::platforms
