// What the routes of a running service share, and the routes themselves: each folder of addresses is a file of its own.
#pragma once

#include <httplib.h>

#include <atomic>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "layoutbox/serve/calls.h"
#include "layoutbox/serve/gate.h"
#include "layoutbox/serve/guard.h"
#include "layoutbox/serve/jobs.h"
#include "layoutbox/serve/page.h"
#include "layoutbox/serve/server.h"
#include "layoutbox/serve/store.h"

namespace layoutbox::serve {

struct Site {
  Site(const Surroundings& surroundings, const ServeOptions& options, Store& kept, Jobs& work);

  // The body of a request, as the operation's schema wants it; else the answer says why not.
  std::optional<nlohmann::json> read_body(const std::string& operation, const httplib::Request& request, httplib::Response& response) const;
  bool ending() const;
  // The address that the service prints carries the token once; the page then has it as a cookie.
  bool gives_token(const httplib::Request& request) const;

  Surroundings around;
  Store& store;
  Jobs& jobs;
  Gate gate;
  Metrics metrics;
  GuardOptions guard;
  RequestSchemas schemas;
  Page page;
  std::atomic<bool> ended{false};
};

void add_call_routes(httplib::Server& server, Site& site);    // /api/generate … /api/export, /api/catalog, /api/relations
void add_job_routes(httplib::Server& server, Site& site);     // /api/jobs
void add_room_routes(httplib::Server& server, Site& site);    // /api/rooms
void add_status_routes(httplib::Server& server, Site& site);  // /api/health, /metrics, /api/openapi.json
void add_page_routes(httplib::Server& server, Site& site);    // /

}  // namespace layoutbox::serve
