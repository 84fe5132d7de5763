// What a subcommand says to the user, and the exit status that goes with it. The only place that prints.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/pipeline/generate.h"

namespace layoutbox::cli {

enum ExitStatus { kDone = 0, kNotAsAsked = 1, kWrongInput = 2, kWrongSurroundings = 3, kStoppedByUser = 130 };

// The exit status of docs/cli.md for an error.
int exit_status(const Error& error);

class Console {
 public:
  bool json = false;  // machine-readable result on stdout, nothing else there
  bool quiet = false;
  int verbosity = 0;

  // A line for a person: on stderr, unless quiet.
  void say(std::string_view line) const;
  // "warning: …" on stderr, even when quiet is set nothing else is.
  void warn(std::string_view line) const;
  // The result of a command: text on stdout, or the JSON when --json is set.
  void result(std::string_view text, std::string_view json_text) const;
  // One line per stage with its time.
  void stage(const StageTime& stage) const;
  // Notes of the planner and the reader: what was not understood always, what was filled in only with -v.
  void notes(const std::vector<Note>& notes) const;
  // What nobody asked for and gave way to what was.
  void gave_way(const Layout& layout) const;
  // Prints the error (what, where, what to do; with --json the object) and returns its exit status.
  int fail(const Error& error) const;
  // A share done of something long: a bar on a terminal, plain lines elsewhere.
  void progress(std::string_view what, double share) const;
};

// Bytes as they are, for files that go to stdout. Errors: kIo; Console::fail() then says it on stderr alone.
Status write_stdout(std::string_view bytes);

// The status to end with: what could not be written to stdout was not done, and is said on stderr.
int status_with_output(int status);

// Set by SIGINT, SIGTERM, SIGHUP and SIGQUIT; every stage looks at it.
const std::atomic<bool>& stop_flag();
void install_signal_handlers();

}  // namespace layoutbox::cli
