// SPDX-License-Identifier: BSD-3-Clause
#include "CheckpointFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace
{
// A file of another name beside the checkpoint: on the same file system, so that it can take the place of the old one.
std::string Beside(const std::string& name)
{
  return name + ".part" + std::to_string(getpid());
}

// Brings what happened to a file's name to the disk; on file systems that cannot, the name is as safe as they make it.
void SyncFolderOf(const std::string& name)
{
  const auto slash = name.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "." : name.substr(0, slash + 1);
  const int handle = open(folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (handle < 0)
    return;
  fsync(handle);
  close(handle);
}

// Returns 0 or the error.
int WriteThrough(const std::string& name, const std::string& bytes)
{
  const int handle = open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (handle < 0)
    return errno;
  int error = 0;
  for (std::size_t written = 0; written < bytes.size() && !error;)
  {
    const ssize_t part = write(handle, bytes.data() + written, bytes.size() - written);
    if (part >= 0)
      written += static_cast<std::size_t>(part);
    else if (errno != EINTR)
      error = errno;
  }
  if (!error && fsync(handle) != 0)
    error = errno;
  if (close(handle) != 0 && !error)
    error = errno;
  return error;
}
}  // namespace

std::string CheckpointFile::load()
{
  auto refuse = [this](const char* what, const char* expected) {
    throw std::invalid_argument(this->Name + ": checkpoint: " + what + " (" + std::strerror(errno) + "), expected " +
                                expected);
  };
  const std::string trial = Beside(this->Name);
  const int error = WriteThrough(trial, "");
  unlink(trial.c_str());
  if (error)
  {
    errno = error;
    refuse("cannot be written", "a file in a folder that is there and writable");
  }
  errno = 0;
  std::ifstream file(this->Name, std::ios::binary);
  std::ostringstream bytes;
  if (!file)
  {
    if (errno != ENOENT)
      refuse("cannot be read", "a file of kalos, or none");
    return {};
  }
  if (file.peek() == std::ifstream::traits_type::eof())
    throw std::invalid_argument(this->Name +
                                ": checkpoint: cannot be read or is empty; expected a file of kalos, or none");
  bytes << file.rdbuf();
  return bytes.str();
}

void CheckpointFile::save(const std::string& bytes)
{
  const std::string fresh = Beside(this->Name);
  int error = WriteThrough(fresh, bytes);
  if (!error && std::rename(fresh.c_str(), this->Name.c_str()) != 0)
    error = errno;
  if (!error)
  {
    SyncFolderOf(this->Name);
    return;
  }
  unlink(fresh.c_str());
  if (!this->Warned)
    this->Warn(this->Name + ": checkpoint: cannot be written (" + std::strerror(error) +
               "); the solve goes on, with the checkpoint of before, if any");
  this->Warned = true;
}
