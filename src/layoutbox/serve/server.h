// `layoutbox serve`: the calls over HTTP, the page, and the jobs.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "layoutbox/base/result.h"
#include "layoutbox/serve/calls.h"

namespace layoutbox::serve {

struct ServeOptions {
  std::string address = "127.0.0.1";
  int port = 8080;                      // 0: any that is free
  std::string token;                    // who asks must know it; empty: nobody need. Needed for every address but this machine's own.
  std::filesystem::path folder;         // of the database and the pictures
  std::filesystem::path page;           // folder of the built page; empty or missing: the service alone
  int workers = 0;                      // calls that work at a time; 0: one a core
  int longest_queue = 64;               // calls that wait, and pictures
  std::size_t largest_body = 8u << 20;  // bytes
  // Called once it listens, with its address ("http://127.0.0.1:8080/").
  std::function<void(const std::string& url)> on_ready;
};

// Serves until `around.stop` is set; work that runs is finished or put back. Errors: kUsage (an address without a token), kIo (the port is
// taken, the folder cannot be written, the database is damaged).
Status serve(const Surroundings& around, const ServeOptions& options);

}  // namespace layoutbox::serve
