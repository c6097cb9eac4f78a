// SPDX-License-Identifier: BSD-3-Clause
// A checkpoint as a file that is whole at every moment.
#ifndef CheckpointFile_h
#define CheckpointFile_h

#include <functional>
#include <string>

#include "estimator/solve/Checkpoint.h"

class CheckpointFile : public kalos::CheckpointStore
{
public:
  /// `warn` is called once with the reason when the file cannot be written; its content stays, and the solve goes on.
  CheckpointFile(std::string name, double interval, std::function<void(const std::string&)> warn)
      : Name(std::move(name)), Interval(interval), Warn(std::move(warn))
  {
  }

  /// Throws std::invalid_argument when the file is there and cannot be read, or its folder cannot be written to.
  std::string load() override;

  /// Writes a new file beside the old one, brings it to the disk and puts it in the old one's place.
  void save(const std::string& bytes) override;

  std::string name() const override { return this->Name; }
  double interval() const override { return this->Interval; }

private:
  std::string Name;
  double Interval;
  std::function<void(const std::string&)> Warn;
  bool Warned = false;
};

#endif
