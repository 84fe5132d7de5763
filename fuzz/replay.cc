// A fuzz target without libFuzzer, for every build: all inputs of its corpus, then for some seconds the same with bytes changed, cut and
// joined by a seeded generator. What breaks it ends the process; the input is then in the file that is named first.
//   fuzz_replay_plan fuzz/corpus/plan [SECONDS]
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::string mutated(const std::vector<std::string>& inputs, std::mt19937_64& random) {
  const auto below = [&](std::size_t bound) { return bound == 0 ? std::size_t{0} : static_cast<std::size_t>(random() % bound); };
  std::string text = inputs[below(inputs.size())];
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(text.size() + 1), length = below(std::min<std::size_t>(text.size() - at, 40) + 1);
    switch (below(4)) {
      case 0: text.erase(at, length); break;
      case 1: text.insert(at, std::string(1 + below(3), static_cast<char>(below(256)))); break;
      case 2: text.insert(at, text.substr(at, length)); break;
      default: {
        const std::string& other = inputs[below(inputs.size())];
        text.replace(at, length, other.substr(below(other.size()), length));
      }
    }
  }
  return text;
}

// `note` is kept open: closing a file that was emptied waits for the disk.
bool run(const std::string& text, int note) {
  const bool noted = ::ftruncate(note, 0) == 0 && ::pwrite(note, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
  if (!noted) std::perror("cannot keep the input");
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  return noted;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return 2;
  const double seconds = count > 2 ? std::stod(arguments[2]) : 2;
  const std::string name = std::filesystem::path(arguments[0]).filename().string() + ".input";
  const int note = ::open(name.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  std::vector<std::string> inputs;
  for (const auto& entry : std::filesystem::directory_iterator(arguments[1])) {
    std::ifstream file(entry.path(), std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  if (inputs.empty()) return 2;
  std::sort(inputs.begin(), inputs.end());  // the same order on every disk
  std::printf("an input that breaks it is left in %s\n", name.c_str());
  if (!std::all_of(inputs.begin(), inputs.end(), [note](const std::string& input) { return run(input, note); })) return 3;
  std::mt19937_64 random(1);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::size_t runs = 0;
  for (; std::chrono::steady_clock::now() < end; ++runs) {
    if (!run(mutated(inputs, random), note)) return 3;
  }
  ::close(note);
  std::filesystem::remove(name);
  std::printf("%zu inputs of the corpus and %zu made from them\n", inputs.size(), runs);
  return 0;
}
