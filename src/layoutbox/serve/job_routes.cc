// Jobs: started, looked at, followed by server-sent events, cancelled, their files.
#include <chrono>
#include <nlohmann/json.hpp>

#include "layoutbox/serve/http.h"
#include "layoutbox/serve/site.h"

namespace layoutbox::serve {
namespace {

constexpr const char* kJob = R"(/api/jobs/([0-9a-f]{16}))";
constexpr auto kLongestEvent = std::chrono::seconds(15);

// Answers with the job, where there is one.
void put_job(httplib::Response& response, const Result<std::optional<JobView>>& job) {
  if (!job) {
    put_error(response, job.error());
  } else if (!*job) {
    put_nothing_there(response);
  } else {
    put(response, {200, "application/json", write_job(**job)});
  }
}

void start_job(Site& site, const httplib::Request& request, httplib::Response& response) {
  const auto body = site.read_body("startJob", request, response);
  if (!body) return;
  const auto job = site.jobs.start(*body, request.remote_addr);
  if (job) {
    put(response, {202, "application/json", write_job(*job)});
  } else if (job.error().code == ErrorCode::kTooLarge && job.error().pointer.empty()) {
    put_error(response, 429, job.error());
  } else {
    put_error(response, job.error());
  }
}

void stream_events(Site& site, const std::string& id, httplib::Response& response) {
  const auto job = site.jobs.find(id);
  if (!job || !*job) return put_job(response, job);
  response.set_header("Cache-Control", "no-store");
  response.set_chunked_content_provider("text/event-stream", [&site, id, seen = 0](std::size_t, httplib::DataSink& sink) mutable {
    const auto now = site.jobs.wait(id, seen, kLongestEvent);
    if (!now || !*now || site.ending()) {
      sink.done();
      return true;
    }
    const JobView& view = **now;
    const std::string text = view.version == seen ? ": still here\n\n" : "data: " + write_job(view) + "\n\n";
    seen = view.version;
    if (!sink.write(text.data(), text.size())) return false;
    if (view.record.state != JobState::kWaiting && view.record.state != JobState::kRunning) sink.done();
    return true;
  });
}

void put_file(const Site& site, const httplib::Request& request, httplib::Response& response) {
  const std::string name = request.matches[2];
  const auto bytes = site.jobs.file(request.matches[1], name);
  if (!bytes) return put_nothing_there(response);
  put(response, {200, name.ends_with(".png") ? "image/png" : "application/octet-stream", *bytes});
}

}  // namespace

void add_job_routes(httplib::Server& server, Site& site) {
  server.Post("/api/jobs", [&site](const httplib::Request& request, httplib::Response& response) { start_job(site, request, response); });
  server.Get(kJob, [&site](const httplib::Request& request, httplib::Response& response) {
    put_job(response, site.jobs.find(request.matches[1]));
  });
  server.Delete(kJob, [&site](const httplib::Request& request, httplib::Response& response) {
    put_job(response, site.jobs.cancel(request.matches[1]));
  });
  server.Get(std::string(kJob) + "/events",
             [&site](const httplib::Request& request, httplib::Response& response) { stream_events(site, request.matches[1], response); });
  server.Get(std::string(kJob) + R"(/files/([a-z0-9.-]{1,64}))",
             [&site](const httplib::Request& request, httplib::Response& response) { put_file(site, request, response); });
}

}  // namespace layoutbox::serve
