#include "layoutbox/cli/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "layoutbox/scene/json_text.h"

namespace layoutbox::cli {
namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void on_signal(int) { stop_requested.store(true); }

int lost_output = 0;                // the error number of a line that stdout did not take and nobody has been told of yet
bool stdout_takes_nothing = false;  // somebody has been told, and it is no use to write more

void print_line(std::FILE* stream, std::string_view line) {
  const bool written =
      std::fwrite(line.data(), 1, line.size(), stream) == line.size() && std::fputc('\n', stream) != EOF && std::fflush(stream) == 0;
  if (!written && stream == stdout && errno != EPIPE) lost_output = errno;  // who closes a pipe has read enough
}

Error stdout_error(int number) {
  return {ErrorCode::kIo, fmt::format("cannot write to stdout: {}", std::generic_category().message(number)), {}, {}, {}};
}

std::string time_text(double seconds) { return seconds < 1 ? fmt::format("{:.1f} ms", seconds * 1000) : fmt::format("{:.1f} s", seconds); }

// The place within a file: what follows "#", or "line 3" at the end.
std::string_view place_in_file(std::string_view pointer) {
  if (const std::size_t mark = pointer.find('#'); mark != std::string_view::npos) return pointer.substr(mark + 1);
  return pointer.substr(pointer.rfind(" line ") + 1);
}

std::string sentence_of(const Error& error) {
  std::string text = error.message;
  // Where the sentence begins with its place, that is said once.
  const std::string_view place = place_in_file(error.pointer);
  const std::string file = error.pointer.substr(0, error.pointer.size() - place.size());
  const bool says_place = !place.empty() && text.starts_with(place);
  if (says_place && !file.empty()) text = file + text;
  if (!says_place && !error.pointer.empty()) text = fmt::format("{}: {}", error.pointer, text);
  if (!error.hint.empty()) text += fmt::format(" ({})", error.hint);
  return text;
}

}  // namespace

int exit_status(const Error& error) {
  switch (error.code) {
    case ErrorCode::kUsage:
    case ErrorCode::kParse:
    case ErrorCode::kSchema:
    case ErrorCode::kReference:
    case ErrorCode::kGeometry:
    case ErrorCode::kEmpty:
    case ErrorCode::kTooLarge: return kWrongInput;
    case ErrorCode::kInfeasible:
    case ErrorCode::kNotFound:
    case ErrorCode::kCheckFailed: return kNotAsAsked;
    case ErrorCode::kInterrupted: return kStoppedByUser;
    case ErrorCode::kNoBlender:
    case ErrorCode::kRenderFailed:
    case ErrorCode::kNoSolver:
    case ErrorCode::kIo:
    case ErrorCode::kNetwork:
    case ErrorCode::kInternal: return kWrongSurroundings;
  }
  return kWrongSurroundings;
}

void Console::say(std::string_view line) const {
  if (!quiet) print_line(stderr, line);
}

void Console::warn(std::string_view line) const { print_line(stderr, fmt::format("layoutbox: warning: {}", line)); }

void Console::result(std::string_view text, std::string_view json_text) const {
  const std::string_view chosen = json ? json_text : text;
  if (!chosen.empty()) print_line(stdout, chosen);
}

Status write_stdout(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() && std::fflush(stdout) == 0) return {};
  stdout_takes_nothing = true;
  return Failure(stdout_error(errno));
}

void Console::stage(const StageTime& stage) const {
  say(fmt::format("{:<8}{:>9}  {}", stage.stage, time_text(stage.seconds), stage.summary));
}

void Console::gave_way(const Layout& layout) const {
  for (const Relaxation& item : layout.gave_way) say(fmt::format("gave way: {}", item.why.empty() ? item.relation : item.why));
}

void Console::notes(const std::vector<Note>& notes) const {
  for (const Note& note : notes) {
    const std::string line = note.pointer.empty() ? note.message : fmt::format("{} [{}]", note.message, note.pointer);
    if (note.code == "not-understood" || note.code == "contradiction" || note.code == "warning" || note.code == "left-out") {
      warn(line);
    } else if (note.code == "text-differs") {
      say(fmt::format("model: {}", line));
    } else if (verbosity > 0) {
      say(fmt::format("note: {}", line));
    }
  }
}

int Console::fail(const Error& error) const {
  if (json && !stdout_takes_nothing) print_line(stdout, write_error(error));
  print_line(stderr, fmt::format("layoutbox: {}", sentence_of(error)));
  for (const Error& detail : error.details) {
    if (detail.message != error.message) print_line(stderr, fmt::format("  {}", sentence_of(detail)));  // the first may stand for all
  }
  return exit_status(error);
}

void Console::progress(std::string_view what, double share) const {
  if (quiet) return;
  const int percent = static_cast<int>(std::clamp(share, 0.0, 1.0) * 100);
  if (::isatty(STDERR_FILENO) == 1) {
    constexpr int kCells = 30;
    const int full = percent * kCells / 100;
    fmt::print(stderr, "\r{:<8}[{}{}] {:>3} %{}", what, std::string(static_cast<std::size_t>(full), '#'),
               std::string(static_cast<std::size_t>(kCells - full), '.'), percent, percent == 100 ? "\r\033[K" : "");
    std::fflush(stderr);
    return;
  }
  static int last = -25;
  if (percent < last) last = -25;  // something else has begun
  if (percent == last || (percent < last + 25 && percent != 100)) return;
  last = percent;
  print_line(stderr, fmt::format("{:<8}{:>7} %", what, percent));
}

const std::atomic<bool>& stop_flag() { return stop_requested; }

int status_with_output(int status) {
  if (lost_output == 0) return status;
  print_line(stderr, fmt::format("layoutbox: {}", sentence_of(stdout_error(lost_output))));
  return status == kDone || status == kNotAsAsked ? kWrongSurroundings : status;
}

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);  // nohup, and shells for what runs in the background
  }
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  for (const int number : {SIGPIPE, SIGXFSZ}) sigaction(number, &ignore, nullptr);  // writing fails instead, and says so
}

}  // namespace layoutbox::cli
