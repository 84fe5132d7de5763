// What is kept between runs: answers of models, and what servers were found to understand. In $XDG_CACHE_HOME/layoutbox, else
// ~/.cache/layoutbox, readable by its owner alone.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/chat/chat.h"
#include "layoutbox/chat/provider.h"

namespace layoutbox::chat {

// Empty where there is neither XDG_CACHE_HOME nor HOME.
std::filesystem::path cache_folder();

struct CachedResponse {
  std::filesystem::path file;
  std::string model, begins;  // `begins`: the first words of the last message
  std::uintmax_t bytes = 0;
};

// Answers by what was asked: the address, the model and the whole request.
class ResponseCache {
 public:
  explicit ResponseCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // The body of the answer that this request had before. A file that is broken, or of another request, counts as none.
  std::optional<std::string> find(std::string_view base_url, std::string_view request) const;
  // A cache that cannot be written is no error: the next run asks again.
  void store(std::string_view base_url, std::string_view request, std::string_view body) const;

  std::vector<CachedResponse> list() const;  // newest first
  // How many files were removed; what is known of servers goes too. Errors: kIo.
  Result<std::size_t> clear() const;

 private:
  std::filesystem::path file_of(std::string_view base_url, std::string_view request) const;
  std::filesystem::path folder_;
};

// What is known of a server and a model from earlier runs, and its keeping. `modes`: those of the provider, best first, which outlive it.
Capabilities load_capabilities(const std::filesystem::path& folder, std::string_view base_url, std::string_view model,
                               std::span<const Mode> modes = kAllModes);
void save_capabilities(const std::filesystem::path& folder, std::string_view base_url, std::string_view model,
                       const Capabilities& capabilities);

}  // namespace layoutbox::chat
