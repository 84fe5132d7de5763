// What the service says of itself.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/pipeline/generate.h"
#include "layoutbox/serve/call_parts.h"
#include "layoutbox/serve/http.h"
#include "layoutbox/serve/site.h"

namespace layoutbox::serve {
namespace {

std::string job_metrics(const JobCounts& counts) {
  std::string text = "# TYPE layoutbox_jobs gauge\n";
  text += fmt::format("layoutbox_jobs{{state=\"waiting\"}} {}\nlayoutbox_jobs{{state=\"running\"}} {}\n", counts.waiting, counts.running);
  text += fmt::format("# TYPE layoutbox_jobs_ended_total counter\nlayoutbox_jobs_ended_total{{state=\"done\"}} {}\n", counts.done);
  text += fmt::format("layoutbox_jobs_ended_total{{state=\"failed\"}} {}\n", counts.failed);
  text += fmt::format("layoutbox_jobs_ended_total{{state=\"cancelled\"}} {}\n", counts.cancelled);
  return text;
}

}  // namespace

void add_status_routes(httplib::Server& server, Site& site) {
  server.Get("/api/openapi.json", [](const httplib::Request&, httplib::Response& response) {
    put(response, {200, "application/json", std::string(openapi_text())});
  });
  server.Get("/api/health", [&site](const httplib::Request&, httplib::Response& response) {
    const JobCounts counts = site.jobs.counts();
    Json planners = Json::array({"offline"});
    if (site.around.by_model != nullptr) planners.push_back("llm");
    put(response, json_answer({{"status", "ok"},
                               {"version", program_version()},
                               {"planners", std::move(planners)},
                               {"waiting", counts.waiting + site.gate.waiting()},
                               {"running", counts.running}}));
  });
  server.Get("/metrics", [&site](const httplib::Request&, httplib::Response& response) {
    put(response, {200, "text/plain; version=0.0.4", site.metrics.text() + job_metrics(site.jobs.counts())});
  });
}

}  // namespace layoutbox::serve
