// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target for checkpoints. The first byte says what the others are: a file as it is; or edits (two bytes for a
// place, one for what stands there then) of a good checkpoint, of its state sealed anew, or of its identity sealed
// anew. Whatever is not the good one is refused with a reason, unless only the values of the sums differ.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"

#include "../kernels/Rooms.h"
#include "CheckpointFile.h"
#include "estimator/methods/EstimatorFactory.h"
#include "estimator/solve/Checkpoint.h"

using namespace kalos;

namespace
{
void require(bool condition)
{
  if (!condition)
    std::abort();
}

struct Memory : CheckpointStore
{
  std::string Bytes;
  std::string load() override { return this->Bytes; }
  void save(const std::string& bytes) override { this->Bytes = bytes; }
  std::string name() const override { return "memory"; }
};

// A small solve, and its checkpoint after a round.
struct Subject
{
  static constexpr int replicates = 2;
  Scene scene{rooms::litRoom(0.5)};
  Receivers receivers;
  Settings settings;
  Identity identity;
  std::unique_ptr<Estimator> estimator;
  Memory good;
  std::string state;

  Subject()
  {
    this->receivers.points = {{2, 2, 0}, {0.1, 2, 0}};
    this->receivers.normals.assign(2, {0, 0, 1});
    this->settings.threads = 1;
    this->identity = identify(this->scene, this->receivers, this->settings, false);
    this->estimator = makeEstimator(this->scene, this->receivers, this->settings);
    const Ranks alone;
    Workers workers(1, {}, alone);
    Tally tally(this->scene, this->receivers.points.size(), replicates);
    require(this->estimator->prepare(workers, tally) && this->estimator->addRound(0, 2, workers, tally));
    Checkpoint checkpoint(&this->good, alone);
    Done none;
    checkpoint.resume(this->identity, none, tally, *this->estimator);
    checkpoint.keep({2, 0.5, 0.5, 100}, tally, *this->estimator);
    checkpoint.save();
    this->state = unseal(this->good.Bytes, this->identity);
  }

  // Whether the solve goes on from there.
  bool resumes(CheckpointStore& store) const
  {
    const Ranks alone;
    Tally tally(this->scene, this->receivers.points.size(), replicates);
    Done done;
    try
    {
      Checkpoint(&store, alone).resume(this->identity, done, tally, *this->estimator);
    }
    catch (const std::invalid_argument& reason)
    {
      const std::string text = reason.what();
      require(text.compare(0, store.name().size(), store.name()) == 0 && text.find("expected") != std::string::npos &&
              text.find('\n') == std::string::npos);
      return false;
    }
    require(done.trajectories >= 0 && done.seconds >= 0);
    return true;
  }
};

std::string edited(std::string bytes, const unsigned char* edits, std::size_t size)
{
  for (; size >= 3; size -= 3, edits += 3)
  {
    const std::size_t place = edits[0] + 256u * edits[1];
    if (place < bytes.size())
      bytes[place] = static_cast<char>(edits[2]);
    else
      bytes.resize(std::min<std::size_t>(bytes.size(), place - bytes.size()));  // cut
  }
  return bytes;
}

std::string textOf(const Identity& identity)
{
  std::string text;
  for (const auto& [name, value] : identity)
    text += name + '\t' + value + '\n';
  return text;
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  static const Subject subject;
  if (size == 0)
    return 0;
  const unsigned char kind = *data++ % 4;
  --size;
  if (kind == 0)
  {
    static const std::string path =
        (std::filesystem::exists("/dev/shm") ? "/dev/shm/kalos-fuzz-checkpoint-" : "/tmp/kalos-fuzz-checkpoint-") +
        std::to_string(getpid());
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    CheckpointFile file(path, 0, [](const std::string&) {});
    require(!subject.resumes(file));
    std::filesystem::remove(path);
    return 0;
  }
  Memory memory;
  if (kind == 1)
  {
    memory.Bytes = edited(subject.good.Bytes, data, size);
    require(memory.Bytes.empty() || subject.resumes(memory) == (memory.Bytes == subject.good.Bytes));
  }
  else if (kind == 2)
  {
    const std::string state = edited(subject.state, data, size);
    memory.Bytes = seal(subject.identity, state);
    require(subject.resumes(memory) ? state.size() == subject.state.size() || state.empty() : state != subject.state);
  }
  else
  {
    const std::string text = textOf(subject.identity), other = edited(text, data, size);
    const Identity one{{other.substr(0, other.find('\t')), other.substr(std::min(other.size(), other.find('\t') + 1))}};
    memory.Bytes = seal(one, subject.state);
    require(subject.resumes(memory) == (textOf(one).compare(0, text.size(), text) == 0));
  }
  return 0;
}
