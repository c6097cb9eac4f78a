// SPDX-License-Identifier: BSD-3-Clause
// Serializes the state of a solve to bytes, and reads it back.
#ifndef kalos_estimator_control_Archive_h
#define kalos_estimator_control_Archive_h

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace kalos
{
/// Visits values in one order for both writing and reading, so that the two cannot disagree.
class Archive
{
public:
  /// An archive for writing.
  Archive() = default;

  /// An archive for reading.
  explicit Archive(std::string bytes) : Bytes(std::move(bytes)), Reading(true) {}

  const std::string& bytes() const { return this->Bytes; }

  template <class T>
  void value(T& v)
  {
    static_assert(std::is_trivially_copyable<T>::value, "bytes must be all there is to it");
    this->raw(&v, sizeof v);
  }

  /// Throws std::runtime_error when what was written has another length.
  template <class T>
  void array(std::vector<T>& values)
  {
    std::uint64_t size = values.size();
    this->value(size);
    if (size != values.size())
      throw std::runtime_error("has an array of " + std::to_string(size) + " values; expected " +
                               std::to_string(values.size()));
    this->raw(values.data(), size * sizeof(T));
  }

  /// Throws std::runtime_error when more was written than was put back.
  void finish() const
  {
    if (this->Next != this->Bytes.size())
      throw std::runtime_error("has " + std::to_string(this->Bytes.size() - this->Next) +
                               " bytes after the last value; expected none");
  }

private:
  void raw(void* data, std::size_t size)
  {
    if (size == 0)
      return;
    if (!this->Reading)
    {
      this->Bytes.append(static_cast<const char*>(data), size);
      return;
    }
    if (size > this->Bytes.size() - this->Next)
      throw std::runtime_error("ends before the last value; expected all of them");
    std::memcpy(data, this->Bytes.data() + this->Next, size);
    this->Next += size;
  }

  std::string Bytes;
  bool Reading = false;
  std::size_t Next = 0;
};
}  // namespace kalos

#endif
