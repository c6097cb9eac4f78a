// SPDX-License-Identifier: BSD-3-Clause
// A main for fuzz targets where there is no libFuzzer: TARGET CHANGES FOLDER gives the target every file of the folder
// as it is, and CHANGES times with up to eight bytes changed, cut short or with a piece repeated. The same every time.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size);

namespace
{
void give(const std::string& bytes)
{
  LLVMFuzzerTestOneInput(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

std::string changed(std::string bytes, std::mt19937& random)
{
  const auto draw = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  switch (random() % 4)
  {
    case 0:
      bytes.resize(draw(bytes.size()));
      break;
    case 1:
      bytes.insert(draw(bytes.size()), bytes.substr(draw(bytes.size()), draw(64)));
      break;
    default:
      for (std::size_t k = 1 + draw(8); k > 0 && !bytes.empty(); --k)
        bytes[draw(bytes.size())] = static_cast<char>(random() % 256);
  }
  return bytes;
}
}  // namespace

int main(int count, char** arguments)
{
  if (count != 3)
  {
    std::fprintf(stderr, "usage: %s CHANGES FOLDER\n", arguments[0]);
    return 2;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(arguments[2]))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::mt19937 random(1);
  std::size_t inputs = 0;
  for (const auto& path : files)
  {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    give(bytes);
    for (int i = std::atoi(arguments[1]); i > 0; --i)
      give(changed(bytes, random));
    inputs += 1 + std::atoi(arguments[1]);
  }
  std::printf("%zu inputs\n", inputs);
  return inputs > 0 ? 0 : 1;
}
