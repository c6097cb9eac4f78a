// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/solve/Checkpoint.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>
#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"

#include "estimator/control/Techniques.h"
#include "scene/Fingerprint.h"

namespace kalos
{
namespace
{
const std::string magic = "KALOSCP2";

std::string word(std::uint64_t value)
{
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string hexadecimal(const Fingerprint& sum)
{
  std::ostringstream text;
  text << std::hex << sum.value();
  return text.str();
}

std::string digits(double value)
{
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

// The bytes of the first rank, on all.
std::string broadcast(const Ranks& ranks, const std::string& bytes)
{
  if (ranks.size() == 1)
    return bytes;
  std::vector<double> packed;
  if (ranks.rank() == 0)
  {
    packed.assign(1 + (bytes.size() + sizeof(double) - 1) / sizeof(double), 0);
    packed[0] = static_cast<double>(bytes.size());
    std::memcpy(packed.data() + 1, bytes.data(), bytes.size());
  }
  packed = ranks.gather(packed);
  return {reinterpret_cast<const char*>(packed.data() + 1), static_cast<std::size_t>(packed[0])};
}

std::string describe(const MethodOptions& own)
{
  std::ostringstream text;
  text << own.photons << (own.coneFilter ? ", cone filter" : "") << (own.finalGather ? ", final gather" : "");
  return text.str();
}

void visit(Archive& archive, Done& done, Tally& tally, Estimator& estimator)
{
  archive.value(done.trajectories);
  archive.value(done.seconds);
  archive.value(done.cpuSeconds);
  archive.value(done.rays);
  archive.value(done.planned);
  tally.persist(archive);
  estimator.persist(archive);
}
// Makes any bytes printable in a one-line message.
std::string quotable(std::string text)
{
  text = text.substr(0, 60);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c > 126; }, '?');
  return text;
}

// Rejects a checkpoint with a valid checksum but impossible counts.
void check(const Done& done)
{
  constexpr long long most = std::numeric_limits<long long>::max() / 64;
  if (done.trajectories < 0 || done.trajectories > most || done.rays < 0 || !(done.seconds >= 0) ||
      !std::isfinite(done.seconds) || !(done.cpuSeconds >= 0) || !std::isfinite(done.cpuSeconds))
    throw std::runtime_error("has impossible counts; expected trajectories, rays and seconds from 0 on");
}
}  // namespace

const char* version()
{
  return KALOS_VERSION;
}

Identity identify(const Scene& scene, const Receivers& receivers, const Settings& s, bool shown)
{
  Fingerprint surfaces, points;
  surfaces.add(scene.data());
  surfaces.add(scene.origin());
  for (const std::vector<Vec3>* vectors : {&receivers.points, &receivers.normals, &receivers.outgoing})
    for (const Vec3& v : *vectors)
      points.add(v);
  for (const std::vector<Vec3>& cell : receivers.cells)
    for (const Vec3& v : cell)
      points.add(v);
  points.add(receivers.followsMirror.data(), receivers.followsMirror.size());
  return {{"version", version()},
          {"scene", hexadecimal(surfaces)},
          {"receivers", hexadecimal(points)},
          {"method", std::to_string(static_cast<int>(s.method))},
          {"method's options", describe(s.own)},
          {"trajectories", std::to_string(s.trajectories)},
          {"error", digits(s.relativeError)},
          {"error floor", digits(s.errorFloor)},
          {"time", digits(s.seconds)},
          {"seed", std::to_string(s.seed)},
          {"delta", digits(s.delta)},
          {"epsilon", digits(s.epsilon)},
          {"disabled techniques", s.disabled.names()},
          {"intermediate results", std::to_string(shown)}};
}

std::string seal(const Identity& identity, const std::string& state)
{
  std::string text;
  for (const auto& [name, value] : identity)
    text += name + '\t' + value + '\n';
  std::string bytes = magic + word(text.size()) + text + word(state.size()) + state;
  Fingerprint sum;
  sum.add(bytes.data(), bytes.size());
  return bytes + word(sum.value());
}

std::string unseal(const std::string& bytes, const Identity& expected)
{
  auto refuse = [](const std::string& reason) { throw std::invalid_argument(reason); };
  std::size_t next = 0;
  auto take = [&](std::uint64_t size) {
    if (size > bytes.size() - next)
      refuse("is cut short; expected a whole checkpoint");
    next += size;
    return bytes.substr(next - size, size);
  };
  auto takeWord = [&] {
    std::uint64_t value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  };
  if (bytes.compare(0, magic.size(), magic) != 0)
    refuse("is no checkpoint of Kalos; expected one, or no file");
  take(magic.size());
  const std::string identity = take(takeWord());
  std::string state = take(takeWord());
  Fingerprint sum;
  sum.add(bytes.data(), next);
  if (takeWord() != sum.value() || next != bytes.size())
    refuse("is damaged, its checksum is wrong; expected a whole checkpoint");

  std::istringstream lines(identity);
  std::string line;
  for (const auto& [name, value] : expected)
  {
    std::getline(lines, line);
    const std::string found = line.substr(std::min(line.size(), line.find('\t') + 1));
    if (line == name + '\t' + value)
      continue;
    if (name == "scene" || name == "receivers")
      refuse("belongs to another " + std::string(name == "scene" ? "scene" : "set of receivers") +
             "; expected one of this solve, or no file");
    refuse("was made with " + name + " " + quotable(found) + "; expected " + value + ", or no file");
  }
  return state;
}

void Checkpoint::resume(const Identity& identity, Done& done, Tally& tally, Estimator& estimator)
{
  if (!this->Store)
    return;
  this->Own = identity;
  std::string state;
  this->Sharing.together([&] {
    if (this->Sharing.rank() > 0)
      return true;
    const std::string bytes = this->Store->load();
    try
    {
      if (!bytes.empty())
        state = unseal(bytes, identity);
    }
    catch (const std::invalid_argument& reason)
    {
      throw std::invalid_argument(this->Store->name() + ": checkpoint: " + reason.what());
    }
    return true;
  });
  state = broadcast(this->Sharing, state);
  if (state.empty())
    return;
  try
  {
    Archive archive(std::move(state));
    visit(archive, done, tally, estimator);
    archive.finish();
    check(done);
  }
  catch (const std::runtime_error& reason)
  {
    throw std::invalid_argument(this->Store->name() + ": checkpoint: " + reason.what());
  }
  if (this->Sharing.rank() > 0)  // the first rank holds the totals
  {
    done.cpuSeconds = 0;
    done.rays = 0;
  }
}

void Checkpoint::keep(Done done, Tally& tally, Estimator& estimator)
{
  if (!this->Store)
    return;
  estimator.exchangeState(this->Sharing);
  done.cpuSeconds = this->Sharing.sum(done.cpuSeconds);
  done.rays = static_cast<long long>(this->Sharing.sum(static_cast<double>(done.rays)));
  if (this->Sharing.rank() > 0)
    return;
  Archive archive;
  visit(archive, done, tally, estimator);
  this->Noted = archive.bytes();
  if (std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Saved).count() >= this->Store->interval())
    this->save();
}

void Checkpoint::save()
{
  if (this->Noted.empty())
    return;
  this->Store->save(seal(this->Own, this->Noted));
  this->Noted.clear();
  this->Saved = std::chrono::steady_clock::now();
}
}  // namespace kalos
