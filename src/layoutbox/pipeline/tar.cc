#include "layoutbox/pipeline/tar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace layoutbox {
namespace {

constexpr std::size_t kBlock = 512;

}  // namespace

void add_to_tar(std::string& tar, std::string_view name, std::string_view bytes) {
  std::array<char, kBlock> header{};
  const auto put = [&header](std::size_t at, std::string_view text) { std::copy(text.begin(), text.end(), header.begin() + at); };
  put(0, name.substr(0, 100));
  put(100, "0000644");
  put(108, "0000000");
  put(116, "0000000");
  put(124, fmt::format("{:011o}", bytes.size()));
  put(136, "00000000000");
  put(148, "        ");
  put(156, "0");
  put(257, std::string_view("ustar\0"
                            "00",
                            8));
  const unsigned sum =
      std::accumulate(header.begin(), header.end(), 0u, [](unsigned all, char c) { return all + static_cast<unsigned char>(c); });
  put(148, fmt::format("{:06o}", sum));
  header[154] = '\0';
  tar.append(header.data(), header.size());
  tar.append(bytes);
  tar.append((kBlock - bytes.size() % kBlock) % kBlock, '\0');
}

}  // namespace layoutbox
