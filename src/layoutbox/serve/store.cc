#include "layoutbox/serve/store.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <array>
#include <chrono>
#include <mutex>
#include <random>

namespace layoutbox::serve {
namespace {

constexpr std::array<std::string_view, 5> kStates{"waiting", "running", "done", "failed", "cancelled"};  // in the order of JobState

constexpr const char* kSchema = R"(
  PRAGMA journal_mode = WAL;
  PRAGMA synchronous = FULL;
  CREATE TABLE IF NOT EXISTS jobs (id TEXT PRIMARY KEY, number INTEGER UNIQUE, kind TEXT, request TEXT, state TEXT, files TEXT, error TEXT, created TEXT);
  CREATE TABLE IF NOT EXISTS rooms (id TEXT PRIMARY KEY, number INTEGER UNIQUE, name TEXT, prompt TEXT, created TEXT, layout TEXT);
  UPDATE jobs SET state = 'waiting' WHERE state = 'running';
)";

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
};
struct EndStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;

Failure failure(sqlite3* database) {
  return fail(ErrorCode::kIo, fmt::format("the service's database: {}", sqlite3_errmsg(database)), {},
              "is the disk full, or the file somebody else's?");
}

// One statement with its values bound; step() until there is no row.
class Query {
 public:
  Query(sqlite3* database, const char* text) : database_(database) {
    sqlite3_stmt* statement = nullptr;
    good_ = sqlite3_prepare_v2(database, text, -1, &statement, nullptr) == SQLITE_OK;
    statement_.reset(statement);
  }
  Query& bind(std::string_view text) {
    good_ =
        good_ && sqlite3_bind_text(statement_.get(), ++bound_, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT) == SQLITE_OK;
    return *this;
  }
  Query& bind(int number) {
    good_ = good_ && sqlite3_bind_int(statement_.get(), ++bound_, number) == SQLITE_OK;
    return *this;
  }
  // True: there is a row. Errors: kIo.
  Result<bool> step() {
    const int code = good_ ? sqlite3_step(statement_.get()) : SQLITE_ERROR;
    if (code == SQLITE_ROW) return true;
    if (code == SQLITE_DONE) return false;
    return failure(database_);
  }
  std::string text(int column) const {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    return bytes == nullptr ? std::string() : std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)));
  }

 private:
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, EndStatement> statement_;
  bool good_ = false;
  int bound_ = 0;
};

JobState state_from(std::string_view name) {
  for (std::size_t i = 0; i < kStates.size(); ++i) {
    if (kStates[i] == name) return static_cast<JobState>(i);
  }
  return JobState::kFailed;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += name + "\n";
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    lines.push_back(text.substr(begin, end - begin));
  }
  return lines;
}

constexpr const char* kJobColumns = "SELECT id, kind, request, state, files, error, created FROM jobs ";

JobRecord job_of(const Query& row) {
  return {row.text(0), row.text(1), row.text(2), state_from(row.text(3)), lines_of(row.text(4)), row.text(5), row.text(6)};
}

}  // namespace

std::string_view name_of(JobState state) { return kStates.at(static_cast<std::size_t>(state)); }

struct Store::State {
  Database database;
  std::mutex mutex;
};

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Result<Store> Store::open(const std::filesystem::path& file) {
  auto state = std::make_unique<State>();
  sqlite3* database = nullptr;
  const int opened = sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_FULLMUTEX, nullptr);
  state->database.reset(database);
  if (opened != SQLITE_OK) return failure(database);
  sqlite3_busy_timeout(database, 5000);
  if (sqlite3_exec(database, kSchema, nullptr, nullptr, nullptr) != SQLITE_OK) return failure(database);
  return Store(std::move(state));
}

Status Store::put_job(const JobRecord& job) {
  const std::lock_guard lock(state_->mutex);
  Query query(state_->database.get(),
              "INSERT INTO jobs VALUES (?1, (SELECT ifnull(max(number), 0) + 1 FROM jobs), ?2, ?3, ?4, ?5, ?6, ?7) "
              "ON CONFLICT (id) DO UPDATE SET state = ?4, files = ?5, error = ?6");
  query.bind(job.id).bind(job.kind).bind(job.request).bind(name_of(job.state)).bind(joined(job.files)).bind(job.error).bind(job.created);
  LAYOUTBOX_CHECK(query.step());
  return {};
}

Result<std::optional<JobRecord>> Store::job(const std::string& id) const {
  const std::lock_guard lock(state_->mutex);
  Query query(state_->database.get(), (std::string(kJobColumns) + "WHERE id = ?").c_str());
  query.bind(id);
  LAYOUTBOX_ASSIGN(const bool found, query.step());
  return found ? std::optional(job_of(query)) : std::nullopt;
}

Result<std::vector<JobRecord>> Store::waiting_jobs() const {
  const std::lock_guard lock(state_->mutex);
  Query query(state_->database.get(), (std::string(kJobColumns) + "WHERE state = 'waiting' ORDER BY number").c_str());
  std::vector<JobRecord> jobs;
  while (true) {
    LAYOUTBOX_ASSIGN(const bool more, query.step());
    if (!more) return jobs;
    jobs.push_back(job_of(query));
  }
}

Result<std::vector<std::string>> Store::forget_old_jobs(int keep) {
  const std::lock_guard lock(state_->mutex);
  Query query(state_->database.get(),
              "DELETE FROM jobs WHERE state NOT IN ('waiting', 'running') AND id NOT IN "
              "(SELECT id FROM jobs ORDER BY number DESC LIMIT ?) RETURNING id");
  query.bind(keep);
  std::vector<std::string> ids;
  while (true) {
    LAYOUTBOX_ASSIGN(const bool more, query.step());
    if (!more) return ids;
    ids.push_back(query.text(0));
  }
}

Status Store::put_room(const RoomRecord& room) {
  const std::lock_guard lock(state_->mutex);
  Query query(state_->database.get(), "INSERT INTO rooms VALUES (?1, (SELECT ifnull(max(number), 0) + 1 FROM rooms), ?2, ?3, ?4, ?5)");
  query.bind(room.id).bind(room.name).bind(room.prompt).bind(room.created).bind(room.layout);
  LAYOUTBOX_CHECK(query.step());
  return {};
}

Result<std::vector<RoomRecord>> Store::rooms() const {
  const std::lock_guard lock(state_->mutex);
  Query query(state_->database.get(), "SELECT id, name, prompt, created FROM rooms ORDER BY number DESC LIMIT 1000");
  std::vector<RoomRecord> rooms;
  while (true) {
    LAYOUTBOX_ASSIGN(const bool more, query.step());
    if (!more) return rooms;
    rooms.push_back({query.text(0), query.text(1), query.text(2), query.text(3), {}});
  }
}

Result<std::optional<RoomRecord>> Store::room(const std::string& id) const {
  const std::lock_guard lock(state_->mutex);
  Query query(state_->database.get(), "SELECT id, name, prompt, created, layout FROM rooms WHERE id = ?");
  query.bind(id);
  LAYOUTBOX_ASSIGN(const bool found, query.step());
  if (!found) return std::nullopt;
  return RoomRecord{query.text(0), query.text(1), query.text(2), query.text(3), query.text(4)};
}

Result<bool> Store::remove_room(const std::string& id) {
  const std::lock_guard lock(state_->mutex);
  Query query(state_->database.get(), "DELETE FROM rooms WHERE id = ? RETURNING id");
  query.bind(id);
  return query.step();
}

std::string new_id() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

std::string time_text() {
  return fmt::format("{:%FT%TZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

}  // namespace layoutbox::serve
