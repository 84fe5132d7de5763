#include "layoutbox/chat/curl_library.h"

#include <dlfcn.h>

namespace layoutbox::chat {
namespace {

constexpr const char* kNames[] = {"libcurl.so.4", "libcurl-gnutls.so.4"};
constexpr const char* kHint = "install the package libcurl4, or leave out --planner llm";

template <class Function>
bool look_up(void* handle, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(handle, name));
  return function != nullptr;
}

Result<CurlLibrary> open() {
  void* handle = nullptr;
  for (const char* name : kNames) {
    handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (handle != nullptr) break;
  }
  if (handle == nullptr) return fail(ErrorCode::kNetwork, "libcurl, by which a model is asked, is not installed", {}, kHint);
  CurlLibrary curl;
  const bool complete =
      look_up(handle, "curl_global_init", curl.global_init) && look_up(handle, "curl_version", curl.version) &&
      look_up(handle, "curl_easy_init", curl.easy_init) && look_up(handle, "curl_easy_cleanup", curl.easy_cleanup) &&
      look_up(handle, "curl_easy_reset", curl.easy_reset) && look_up(handle, "curl_easy_setopt", curl.easy_setopt) &&
      look_up(handle, "curl_easy_getinfo", curl.easy_getinfo) && look_up(handle, "curl_easy_strerror", curl.easy_strerror) &&
      look_up(handle, "curl_multi_init", curl.multi_init) && look_up(handle, "curl_multi_cleanup", curl.multi_cleanup) &&
      look_up(handle, "curl_multi_add_handle", curl.multi_add_handle) &&
      look_up(handle, "curl_multi_remove_handle", curl.multi_remove_handle) && look_up(handle, "curl_multi_perform", curl.multi_perform) &&
      look_up(handle, "curl_multi_poll", curl.multi_poll) && look_up(handle, "curl_multi_info_read", curl.multi_info_read) &&
      look_up(handle, "curl_slist_append", curl.slist_append) && look_up(handle, "curl_slist_free_all", curl.slist_free_all);
  if (!complete || curl.global_init(CURL_GLOBAL_DEFAULT) != CURLE_OK) {
    return fail(ErrorCode::kNetwork, "libcurl is too old: 7.85 or newer is needed", {}, kHint);
  }
  return curl;
}

}  // namespace

Result<const CurlLibrary*> CurlLibrary::get() {
  static const Result<CurlLibrary> library = open();
  if (!library) return Failure(library.error());
  return &*library;
}

}  // namespace layoutbox::chat
