#include "layoutbox/pipeline/shards.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "layoutbox/base/bytes.h"
#include "layoutbox/base/files.h"
#include "layoutbox/pipeline/folder_lock.h"
#include "layoutbox/pipeline/room_pack.h"
#include "layoutbox/pipeline/tar.h"

namespace layoutbox {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using OrderedJson = nlohmann::ordered_json;

double passed_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::string line_of(const OrderedJson& json) { return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n"; }

// A file that grows under another name and gets its own when it is whole.
class GrowingFile {
 public:
  explicit GrowingFile(fs::path part) : part_(std::move(part)), file_(part_, std::ios::binary | std::ios::trunc) {}
  void add(std::string_view bytes) { file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size())); }
  std::size_t size() { return static_cast<std::size_t>(file_.tellp()); }

  // Errors: kIo.
  Status finish(const fs::path& target) {
    file_.close();
    const int descriptor = file_.fail() ? -1 : ::open(part_.c_str(), O_RDWR | O_CLOEXEC);
    const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
    if (descriptor >= 0) ::close(descriptor);
    std::error_code error;
    if (synced) fs::rename(part_, target, error);
    if (synced && !error) return {};
    fs::remove(part_, error);
    return fail(ErrorCode::kIo, fmt::format("the shard {} cannot be written", target.filename().string()), target.string(),
                "is the disk full, or the size of files limited (ulimit -f)?");
  }

 private:
  fs::path part_;
  std::ofstream file_;
};

// The rooms of one shard: made by several threads, written in their order.
class ShardMaker {
 public:
  ShardMaker(std::vector<Expected> rooms, const Planner& planner, const Catalog& catalog, const BatchOptions& options, GrowingFile& tar,
             std::function<void(Packed&, std::size_t offset)> on_room)
      : rooms_(std::move(rooms)), planner_(planner), catalog_(catalog), options_(options), tar_(tar), on_room_(std::move(on_room)) {}

  // Errors: those of the surroundings, of the first room in order that met one.
  Status run() {
    std::vector<std::thread> others;
    const auto wanted = std::min(static_cast<std::size_t>(std::max(options_.jobs, 1)), rooms_.size());
    for (std::size_t i = 1; i < wanted; ++i) others.emplace_back([this] { work(); });
    work();
    for (std::thread& other : others) other.join();
    if (error_) return Failure(*error_);
    return {};
  }

 private:
  void work() {
    const auto ahead = static_cast<std::size_t>(8 * std::max(options_.jobs, 1));  // rooms that wait to be written are held in memory
    for (std::size_t i = next_++; i < rooms_.size(); i = next_++) {
      {
        std::unique_lock lock(mutex_);
        written_.wait(lock, [&] { return error_ || i < count_ + ahead; });
        if (error_) return;
      }
      const auto* stop = options_.generate.stop;
      Packed packed;
      if (stop != nullptr && stop->load()) {
        packed.surroundings = Error{ErrorCode::kInterrupted, "stopped", {}, {}, {}};
      } else {
        packed = pack_room(rooms_[i], planner_, catalog_);
      }
      const std::lock_guard lock(mutex_);
      ready_.emplace(i, std::move(packed));
      write_ready();
      written_.notify_all();
    }
  }

  void write_ready() {
    for (auto first = ready_.find(count_); !error_ && first != ready_.end(); first = ready_.find(count_)) {
      if (first->second.surroundings) {
        error_ = first->second.surroundings;
        return;
      }
      const std::size_t offset = tar_.size();
      tar_.add(first->second.tar);
      on_room_(first->second, offset);
      ready_.erase(first);
      ++count_;
    }
  }

  std::vector<Expected> rooms_;
  const Planner& planner_;
  const Catalog& catalog_;
  const BatchOptions& options_;
  GrowingFile& tar_;
  std::function<void(Packed&, std::size_t)> on_room_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::condition_variable written_;
  std::map<std::size_t, Packed> ready_;
  std::size_t count_ = 0;
  std::optional<Error> error_;
};

std::optional<BatchState> state_named(std::string_view name) {
  for (const BatchState state : {BatchState::kDone, BatchState::kNotAsAsked, BatchState::kFailed}) {
    if (name_of(state) == name) return state;
  }
  return std::nullopt;
}

// Is the shard there, whole, and of just these rooms? What became of each; empty where it is not.
std::optional<std::vector<BatchItem>> check_shard(const fs::path& tar, const fs::path& manifest, const std::vector<Expected>& rooms) {
  const auto text = read_file(manifest);
  std::ifstream file(tar, std::ios::binary);
  if (!text || !file) return std::nullopt;
  std::istringstream lines(*text);
  std::vector<BatchItem> items;
  std::size_t end = 0;
  std::string line, bytes;
  while (std::getline(lines, line)) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_object() || items.size() >= rooms.size()) return std::nullopt;
    const Expected& room = rooms[items.size()];
    const auto state = state_named(json.value("state", ""));
    const std::size_t length = json.value("bytes", std::size_t{0});
    if (!state || json.value("id", "") != room.line->id || json.value("made", "") != room.made || json.value("offset", end + 1) != end)
      return std::nullopt;
    std::error_code error;
    if (end + length > fs::file_size(tar, error) || error) return std::nullopt;
    bytes.resize(length);
    file.read(bytes.data(), static_cast<std::streamsize>(length));
    if (!file || content_key(bytes) != json.value("hash", "")) return std::nullopt;
    end += length;
    BatchItem item{.id = room.line->id, .line = room.line->line, .state = *state, .kept = true, .seconds = 0, .error = {}};
    if (*state == BatchState::kFailed) {
      item.error = Error{ErrorCode::kNotFound, json.value(nlohmann::json::json_pointer("/error/message"), std::string()), {}, {}, {}};
      if (room.line->error) item.error = room.line->error;
    }
    items.push_back(std::move(item));
  }
  std::error_code error;
  if (items.size() != rooms.size() || fs::file_size(tar, error) != end + kTarEndBytes || error) return std::nullopt;
  return items;
}

class Packing {
 public:
  Packing(const std::vector<BatchLine>& lines, const Planner& planner, const Catalog& catalog, fs::path folder, const BatchOptions& options,
          const ShardOptions& shards)
      : lines_(lines), planner_(planner), catalog_(catalog), folder_(std::move(folder)), options_(options), shards_(shards) {
    options_.generate.plan.stop = options_.generate.solve.stop = options_.generate.stop;
  }

  Result<BatchOutcome> operator()() {
    const Clock::time_point start = Clock::now();
    if (shards_.rooms == 0 || shards_.machine == 0 || shards_.machine > shards_.machines)
      return fail(ErrorCode::kUsage, "there is no such share of the shards", "--shard", "write --shard 1/4 for the first of four");
    LAYOUTBOX_CHECK(make_folder(workshop()));
    LAYOUTBOX_ASSIGN(const FolderLock lock, FolderLock::acquire(workshop()));
    const std::size_t count = (lines_.size() + shards_.rooms - 1) / shards_.rooms;
    for (std::size_t number = shards_.machine - 1; number < count; number += shards_.machines) mine_ += room_count(number);
    Status done;
    for (std::size_t number = shards_.machine - 1; done && number < count; number += shards_.machines) done = make_shard(number);
    std::error_code ignored;
    fs::remove_all(workshop(), ignored);
    outcome_.stopped = !done && done.error().code == ErrorCode::kInterrupted;
    if (!done && !outcome_.stopped) return Failure(done.error());
    outcome_.seconds = passed_since(start);
    LAYOUTBOX_CHECK(write_file(folder_ / (share_name("summary") + ".json"), write_batch_summary(outcome_)));
    return std::move(outcome_);
  }

 private:
  // "summary" where one machine makes all, else "summary-2-of-4".
  std::string share_name(std::string_view stem) const {
    return shards_.machines == 1 ? std::string(stem) : fmt::format("{}-{}-of-{}", stem, shards_.machine, shards_.machines);
  }
  fs::path workshop() const { return folder_ / share_name(".layoutbox-pack"); }
  std::size_t room_count(std::size_t number) const { return std::min(shards_.rooms, lines_.size() - number * shards_.rooms); }

  Status make_shard(std::size_t number) {
    const std::string name = fmt::format("shard-{:06}", number);
    std::vector<Expected> rooms;
    for (std::size_t i = 0; i < room_count(number); ++i)
      rooms.push_back(expected_of(lines_[number * shards_.rooms + i], options_.generate));
    const fs::path target = folder_ / (name + ".tar"), manifest = folder_ / (name + ".jsonl");
    if (!options_.force) {
      if (auto kept = check_shard(target, manifest, rooms)) {
        for (BatchItem& item : *kept) told(std::move(item));
        return {};
      }
    }
    std::error_code ignored;
    fs::remove(manifest, ignored);  // a shard without one is not whole
    GrowingFile tar(workshop() / (name + ".tar"));
    std::string described, times;
    ShardMaker maker(std::move(rooms), planner_, catalog_, options_, tar, [&](Packed& room, std::size_t offset) {
      room.manifest["shard"] = name + ".tar";
      room.manifest["offset"] = offset;
      described += line_of(room.manifest);
      times += line_of({{"id", room.item.id}, {"seconds", room.item.seconds}});
      told(std::move(room.item));
    });
    LAYOUTBOX_CHECK(maker.run());
    tar.add(std::string(kTarEndBytes, '\0'));
    LAYOUTBOX_CHECK(tar.finish(target));
    LAYOUTBOX_CHECK(write_file(folder_ / (name + ".times.jsonl"), times));
    return write_file(manifest, described);
  }

  void told(BatchItem item) {
    outcome_.items.push_back(std::move(item));
    if (options_.on_item) options_.on_item(outcome_.items.back(), outcome_.items.size(), mine_);
  }

  const std::vector<BatchLine>& lines_;
  const Planner& planner_;
  const Catalog& catalog_;
  fs::path folder_;
  BatchOptions options_;
  ShardOptions shards_;
  std::size_t mine_ = 0;
  BatchOutcome outcome_;
};

}  // namespace

Result<BatchOutcome> run_packed_batch(const std::vector<BatchLine>& lines, const Planner& planner, const Catalog& catalog,
                                      const fs::path& folder, const BatchOptions& options, const ShardOptions& shards) {
  return Packing(lines, planner, catalog, folder, options, shards)();
}

}  // namespace layoutbox
