// SPDX-License-Identifier: BSD-3-Clause
/** A temporary file beside the target; removed unless it is moved into place. */
#ifndef KalosTemporaryFile_h
#define KalosTemporaryFile_h

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>

namespace kalos
{
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string& target) : Target(target)
  {
    // Unique among threads by the counter and among processes by the clock.
    static std::atomic<unsigned int> counter{0};
    const auto ticks = std::chrono::steady_clock::now().time_since_epoch().count();
    this->Name = target + "." + std::to_string(ticks) + "-" + std::to_string(counter++) + ".part";
  }
  ~TemporaryFile()
  {
    std::error_code ignored;
    std::filesystem::remove(this->Name, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  void operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return this->Name; }

  /** Replace the target in one step; throws std::filesystem::filesystem_error. */
  void moveIntoPlace() const { std::filesystem::rename(this->Name, this->Target); }

private:
  std::string Target;
  std::string Name;
};
}  // namespace kalos

#endif
