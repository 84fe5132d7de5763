#include "layoutbox/serve/page.h"

#include <array>

#include "layoutbox/base/files.h"
#include "layoutbox/embedded/page.h"

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

std::string_view type_of(const std::filesystem::path& file) {
  for (const EndingType& row : kServed) {
    if (file.extension() == row.ending) return row.type;
  }
  return {};
}

}  // namespace

bool page_is_embedded() { return !embedded::page_files().empty(); }

Page::Page(std::filesystem::path folder) : folder_(std::move(folder)) {
  auto files = std::make_shared<Files>();
  if (folder_.empty()) {
    for (const auto& [name, bytes] : embedded::page_files()) {
      (*files)[std::string(name)] = {200, std::string(type_of(name)), std::string(bytes)};
    }
  }
  files_ = std::move(files);
  start();
}

std::shared_ptr<const Page::Files> Page::files() const {
  const std::lock_guard lock(mutex_);
  return files_;
}

Answer Page::start() {
  Stamps stamps;
  std::error_code ignored;
  for (const auto& file : std::filesystem::directory_iterator(folder_, ignored)) {
    if (!type_of(file.path()).empty()) stamps[file.path().filename().string()] = file.last_write_time(ignored);
  }
  const std::lock_guard lock(mutex_);
  if (stamps != stamps_) {
    auto files = std::make_shared<Files>();
    for (const auto& [name, stamp] : stamps) {
      if (auto bytes = read_file(folder_ / name)) (*files)[name] = {200, std::string(type_of(name)), *std::move(bytes)};
    }
    stamps_ = std::move(stamps);
    files_ = std::move(files);
  }
  if (const auto found = files_->find("index.html"); found != files_->end()) return found->second;
  return {200, "text/html; charset=utf-8", std::string(kNoPage)};
}

std::optional<Answer> Page::file(const std::string& name) const {
  const auto files = this->files();
  const auto found = files->find(name);
  return found == files->end() ? std::nullopt : std::optional(found->second);
}

}  // namespace layoutbox::serve
