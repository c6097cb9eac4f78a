// SPDX-License-Identifier: BSD-3-Clause
// What fuzz targets of file readers share: the input as a file, and a reader's errors kept off the screen.
#ifndef FuzzFile_h
#define FuzzFile_h

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkObject.h"

namespace fuzz
{
/// A folder of this process, in memory where there is such.
inline std::filesystem::path folder()
{
  static const std::filesystem::path path = [] {
    const char* base = std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : "/tmp";
    std::string name = std::string(base) + "/kalos-fuzz-XXXXXX";
    if (!mkdtemp(name.data()))
      std::abort();
    static const struct Remover
    {
      std::string Name;
      ~Remover() { std::filesystem::remove_all(this->Name); }
    } remover{name};
    return std::filesystem::path(name);
  }();
  return path;
}

inline std::string write(const std::string& name, const void* data, std::size_t size)
{
  const std::string path = (folder() / name).string();
  std::ofstream(path, std::ios::binary).write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  return path;
}

inline void write(const std::string& name, const std::string& text)
{
  write(name, text.data(), text.size());
}

/// Counts events and keeps them off the screen; with OneLine, a text of several lines ends the run.
struct Listener : vtkCommand
{
  static Listener* New() { return new Listener; }
  void Execute(vtkObject*, unsigned long, void* data) override
  {
    ++this->Count;
    const std::string text = data ? static_cast<const char*>(data) : "";
    const std::size_t start = text.find("): ");
    const std::string message = start == std::string::npos ? text : text.substr(start + 3);
    // VTK ends its events with blank lines.
    if (this->OneLine && message.find('\n') < message.find_last_not_of("\n "))
      std::abort();
  }
  int Count = 0;
  bool OneLine = false;
};

/// A reader that serves all inputs, as making one takes VTK longer than reading: what an input leaves behind in it
/// shows too.
template <class Reader>
class Reading
{
public:
  Reading()
  {
    this->Errors->OneLine = true;
    this->Subject->AddObserver(vtkCommand::ErrorEvent, this->Errors.Get());
    this->Subject->AddObserver(vtkCommand::WarningEvent, this->Echo.Get());
    this->Subject->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Echo.Get());
  }

  Reader* operator->() const { return this->Subject.Get(); }

  /// Reads a file; whether that gave an error, which must be of one line.
  bool fails(const std::string& path)
  {
    this->Errors->Count = 0;
    this->Subject->SetFileName(path.c_str());
    this->Subject->Modified();  // another file, even of the same name
    this->Subject->Update();
    return this->Errors->Count > 0;
  }

private:
  vtkNew<Reader> Subject;
  vtkNew<Listener> Errors, Echo;  // the executive repeats in many lines what the reader said
};

inline void require(bool condition)
{
  if (!condition)
    std::abort();
}
}  // namespace fuzz

#endif
