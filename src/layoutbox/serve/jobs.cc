#include "layoutbox/serve/jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "layoutbox/base/files.h"
#include "layoutbox/furnish/furnish.h"
#include "layoutbox/render/render.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/serve/call_parts.h"

namespace layoutbox::serve {
namespace {

constexpr int kKeptJobs = 500;
constexpr std::ptrdiff_t kMostOfOne = 16;  // that wait for one client

// What changes while a job waits and runs; the rest is in the store.
struct Live {
  JobRecord record;
  std::string client;  // who asked this service for it
  double progress = 0;
  int version = 1;
  std::atomic<bool> stop{false};
  bool cancelled = false;
};

RenderOptions options_of(const Json& request) {
  RenderOptions options;
  const std::string quality = request.value("quality", "draft");
  options.quality = quality == "final" ? Quality::kFinal : quality == "preview" ? Quality::kPreview : Quality::kDraft;
  options.width = request.value("width", 1280);
  options.height = request.value("height", 720);
  if (request.contains("views")) {
    options.views.clear();
    for (const Json& name : request.at("views")) {
      if (const auto view = view_from_name(name.get<std::string>())) options.views.push_back(*view);
    }
  }
  options.save_blend = false;
  return options;
}

}  // namespace

std::string write_job(const JobView& job) {
  const JobRecord& record = job.record;
  JsonText text;
  text.add("id", record.id).add("kind", record.kind).add("state", name_of(record.state)).add("progress", job.progress);
  text.add("files", record.files).add("created", record.created);
  if (!record.error.empty()) text.add_written("error", record.error);
  return text.text();
}

struct Jobs::State {
  Store& store;
  const Catalog& catalog;
  std::filesystem::path folder;
  std::size_t longest_queue;
  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  std::map<std::string, std::shared_ptr<Live>> live;
  std::deque<std::string> queue;
  JobCounts ended;
  int running = 0;
  bool ending = false;
  std::optional<BlenderServer> blender;  // of the worker alone
  std::thread worker;

  State(Store& s, const Catalog& c, std::filesystem::path f, int longest)
      : store(s), catalog(c), folder(std::move(f)), longest_queue(static_cast<std::size_t>(longest)) {}

  static JobView view_of(const Live& job) { return {job.record, job.progress, job.version}; }

  void touch(Live& job) {
    ++job.version;
    changed.notify_all();
  }

  Result<RenderOutputs> draw(Live& job) {
    const Json request = Json::parse(job.record.request);
    LAYOUTBOX_ASSIGN(const Layout layout, layout_of(request));
    RenderOptions options = options_of(request);
    options.stop = &job.stop;
    options.progress = [&](double share) {
      const std::lock_guard lock(mutex);
      job.progress = share;
      touch(job);
    };
    LAYOUTBOX_ASSIGN(const Model model, furnish(layout, catalog));
    const std::filesystem::path place = folder / job.record.id;
    LAYOUTBOX_CHECK(make_folder(place));
    LAYOUTBOX_CHECK(write_file(place / "blender.py", write_blender_script(model, layout, catalog, options)));
    if (!blender) {
      LAYOUTBOX_ASSIGN(Blender found, find_blender());
      blender.emplace(std::move(found));
    }
    return blender->render(place / "blender.py", place, options);
  }

  void run(const std::shared_ptr<Live>& job) {
    const auto drawn = draw(*job);
    const std::lock_guard lock(mutex);
    JobRecord& record = job->record;
    if (drawn) {
      record.state = JobState::kDone;
      record.files = {"blender.py"};
      for (const auto& file : drawn->files()) record.files.push_back(file.filename().string());
      job->progress = 1;
      ++ended.done;
    } else if (job->cancelled) {
      record.state = JobState::kCancelled;
      ++ended.cancelled;
    } else if (ending) {
      record.state = JobState::kWaiting;  // the next service does it
    } else {
      record.state = JobState::kFailed;
      record.error = write_error(drawn.error());
      ++ended.failed;
    }
    finish(*job);
  }

  // REQUIRES: the lock is held.
  void finish(Live& job) {
    if (const Status kept = store.put_job(job.record); !kept && job.record.error.empty()) job.record.error = write_error(kept.error());
    touch(job);
    const auto old = store.forget_old_jobs(kKeptJobs);
    if (!old) return;
    for (const std::string& id : *old) {
      std::error_code ignored;
      std::filesystem::remove_all(folder / id, ignored);
      live.erase(id);
    }
  }

  void work() {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [&] { return ending || !queue.empty(); });
      if (ending) return;
      const auto job = live.at(queue.front());
      queue.pop_front();
      job->record.state = JobState::kRunning;
      running = 1;
      touch(*job);
      lock.unlock();
      run(job);
      lock.lock();
      running = 0;
    }
  }
};

Jobs::Jobs(Store& store, const Catalog& catalog, std::filesystem::path folder, int longest_queue)
    : state_(std::make_unique<State>(store, catalog, std::move(folder), longest_queue)) {
  if (const auto left = store.waiting_jobs()) {
    for (const JobRecord& record : *left) {
      auto job = std::make_shared<Live>();
      job->record = record;
      state_->live.emplace(record.id, std::move(job));
      state_->queue.push_back(record.id);
    }
  }
  state_->worker = std::thread([state = state_.get()] { state->work(); });
}

Jobs::~Jobs() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->ending = true;
    for (const auto& [id, job] : state_->live) job->stop = true;
    state_->changed.notify_all();
  }
  state_->worker.join();
}

Result<JobView> Jobs::start(const Json& request, const std::string& client) {
  LAYOUTBOX_CHECK(layout_of(request));
  auto job = std::make_shared<Live>();
  job->client = client;
  job->record = {new_id(), request.at("kind").get<std::string>(), request.dump(), JobState::kWaiting, {}, {}, time_text()};
  const std::lock_guard lock(state_->mutex);
  if (state_->queue.size() >= state_->longest_queue) {
    return fail(ErrorCode::kTooLarge, fmt::format("{} pictures wait already", state_->queue.size()), {}, "ask again later");
  }
  const auto is_theirs = [&](const std::string& id) { return state_->live.at(id)->client == client; };
  if (std::ranges::count_if(state_->queue, is_theirs) >= kMostOfOne) {
    return fail(ErrorCode::kTooLarge, fmt::format("{} pictures of yours wait already", kMostOfOne), {}, "ask again later, or cancel some");
  }
  LAYOUTBOX_CHECK(state_->store.put_job(job->record));
  state_->live.emplace(job->record.id, job);
  state_->queue.push_back(job->record.id);
  state_->changed.notify_all();
  return State::view_of(*job);
}

Result<std::optional<JobView>> Jobs::find(const std::string& id) const {
  {
    const std::lock_guard lock(state_->mutex);
    if (const auto found = state_->live.find(id); found != state_->live.end()) return State::view_of(*found->second);
  }
  LAYOUTBOX_ASSIGN(const std::optional<JobRecord> record, state_->store.job(id));
  if (!record) return std::nullopt;
  return JobView{*record, record->state == JobState::kDone ? 1.0 : 0.0, 1};
}

Result<std::optional<JobView>> Jobs::cancel(const std::string& id) {
  {
    const std::lock_guard lock(state_->mutex);
    const auto found = state_->live.find(id);
    if (found != state_->live.end()) {
      Live& job = *found->second;
      const auto waits = std::find(state_->queue.begin(), state_->queue.end(), id);
      if (waits != state_->queue.end()) {
        state_->queue.erase(waits);
        job.record.state = JobState::kCancelled;
        ++state_->ended.cancelled;
        state_->finish(job);
      } else if (job.record.state == JobState::kRunning) {
        job.cancelled = true;
        job.stop = true;
      }
    }
  }
  return find(id);
}

Result<std::optional<JobView>> Jobs::wait(const std::string& id, int seen, std::chrono::milliseconds patience) const {
  {
    std::unique_lock lock(state_->mutex);
    const auto found = state_->live.find(id);
    if (found != state_->live.end()) {
      const auto job = found->second;
      state_->changed.wait_for(lock, patience, [&] { return job->version != seen || state_->ending; });
    }
  }
  return find(id);
}

std::optional<std::string> Jobs::file(const std::string& id, const std::string& name) const {
  const auto job = find(id);
  if (!job || !*job) return std::nullopt;
  const auto& files = (*job)->record.files;
  if (std::find(files.begin(), files.end(), name) == files.end()) return std::nullopt;
  auto bytes = read_file(state_->folder / id / name);
  return bytes ? std::optional(*std::move(bytes)) : std::nullopt;
}

JobCounts Jobs::counts() const {
  const std::lock_guard lock(state_->mutex);
  JobCounts counts = state_->ended;
  counts.waiting = static_cast<int>(state_->queue.size());
  counts.running = state_->running;
  return counts;
}

}  // namespace layoutbox::serve
