#include "layoutbox/serve/page.h"

#include <array>

#include "layoutbox/base/files.h"

namespace layoutbox::serve {
namespace {

struct EndingType {
  std::string_view ending, type;
};

// Other files of the folder are not served.
constexpr std::array kServed{EndingType{".html", "text/html; charset=utf-8"},
                             EndingType{".js", "text/javascript; charset=utf-8"},
                             EndingType{".css", "text/css; charset=utf-8"},
                             EndingType{".svg", "image/svg+xml"},
                             EndingType{".png", "image/png"},
                             EndingType{".woff2", "font/woff2"},
                             EndingType{".webmanifest", "application/manifest+json"}};

constexpr std::string_view kNoPage =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Layout-in-a-Box</title>"
    "<h1>Layout-in-a-Box</h1><p>The service runs; its page was left out of this build. "
    "<a href=\"/api/openapi.json\">What the service answers</a>.</p></html>\n";

}  // namespace

Page::Page(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const auto& file : std::filesystem::directory_iterator(folder, ignored)) {
    for (const EndingType& row : kServed) {
      if (file.path().extension() != row.ending) continue;
      if (auto bytes = read_file(file.path())) {
        files_[file.path().filename().string()] = {200, std::string(row.type), *std::move(bytes)};
      }
    }
  }
}

Answer Page::start() const {
  if (const auto found = files_.find("index.html"); found != files_.end()) return found->second;
  return {200, "text/html; charset=utf-8", std::string(kNoPage)};
}

std::optional<Answer> Page::file(const std::string& name) const {
  const auto found = files_.find(name);
  return found == files_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace layoutbox::serve
