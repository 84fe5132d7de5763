#include "layoutbox/base/process.h"

#include <gmock/gmock.h>
#include <signal.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <thread>

namespace layoutbox {
namespace {

using testing::ElementsAre;
using testing::EndsWith;

ProcessOutcome run_shell(const std::string& script, const ProcessOptions& options = {}) {
  return run_process({"sh", "-c", script}, options).value();
}

TEST(Process, GivesStatusAndOutput) {
  const ProcessOutcome outcome = run_shell("echo out; echo err >&2; exit 3");
  EXPECT_EQ(outcome.exit_status, 3);
  EXPECT_EQ(outcome.output, "out\nerr\n");
  EXPECT_FALSE(outcome.timed_out);
  EXPECT_FALSE(outcome.stopped);
}

TEST(Process, ArgumentsArePassedAsTheyAre) { EXPECT_EQ(run_process({"printf", "%s|%s", "a b", "$HOME;'"}).value().output, "a b|$HOME;'"); }

TEST(Process, AnUnknownProgramIsAnError) {
  for (const char* name : {"no-such-program-anywhere", "/no/such/program", ""}) {
    const auto outcome = run_process({name});
    ASSERT_FALSE(outcome) << name;
    EXPECT_EQ(outcome.error().code, ErrorCode::kIo);
  }
  EXPECT_FALSE(run_process({}));
}

TEST(Process, RunsInTheFolderWithTheEnvironment) {
  ProcessOptions options;
  options.working_folder = "/";
  options.environment = {{"LAYOUTBOX_TEST_A", "one"}, {"HOME", "/changed"}};
  EXPECT_EQ(run_shell("echo $PWD $LAYOUTBOX_TEST_A $HOME", options).output, "/ one /changed\n");
  options.working_folder = "/no/such/folder";
  EXPECT_FALSE(run_process({"true"}, options));
}

TEST(Process, LinesComeWhole) {
  std::vector<std::string> lines;
  ProcessOptions options;
  options.on_line = [&](std::string_view line) { lines.emplace_back(line); };
  run_shell("printf 'a'; sleep 0.05; printf 'b\\r\\n\\nlast'", options);
  EXPECT_THAT(lines, ElementsAre("ab", "", "last"));
}

TEST(Process, KeepsTheTailOfLongOutput) {
  const ProcessOutcome outcome = run_shell("head -c 1000000 /dev/zero | tr '\\0' x; echo; echo end");
  EXPECT_EQ(outcome.output.size(), 64u << 10);
  EXPECT_THAT(outcome.output, EndsWith("x\nend\n"));
}

TEST(Process, ASignalIsCountedAsAShellDoes) { EXPECT_EQ(run_shell("kill -SEGV $$").exit_status, 128 + SIGSEGV); }

// Ended; whether somebody has reaped it yet is not our matter.
bool is_gone(pid_t process) {
  for (int attempt = 0; attempt < 200; ++attempt) {
    if (::kill(process, 0) != 0 && errno == ESRCH) return true;
    std::ifstream status("/proc/" + std::to_string(process) + "/stat");
    std::string id, name, state;
    if (status >> id >> name >> state && state == "Z") return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST(Process, TheTimeLimitEndsTheWholeGroup) {
  ProcessOptions options;
  options.time_limit_s = 0.2;
  const ProcessOutcome outcome = run_shell("sleep 1000 & echo $!; wait", options);
  EXPECT_TRUE(outcome.timed_out);
  EXPECT_EQ(outcome.exit_status, 128 + SIGTERM);
  EXPECT_TRUE(is_gone(std::stoi(outcome.output))) << "the grandchild is left behind";
}

TEST(Process, WhatIgnoresTheSignalIsKilled) {
  ProcessOptions options;
  options.time_limit_s = 0.2;
  const ProcessOutcome outcome = run_shell("trap '' TERM; while :; do sleep 0.1; done", options);
  EXPECT_TRUE(outcome.timed_out);
  EXPECT_EQ(outcome.exit_status, 128 + SIGKILL);
}

TEST(Process, TheStopFlagEndsIt) {
  std::atomic<bool> stop = false;
  ProcessOptions options;
  options.stop = &stop;
  options.on_line = [&](std::string_view) { stop = true; };
  const ProcessOutcome outcome = run_shell("echo started; sleep 1000", options);
  EXPECT_TRUE(outcome.stopped);
  EXPECT_FALSE(outcome.timed_out);
}

TEST(Process, AGrandchildThatKeepsThePipeDoesNotHoldUsUp) {
  const ProcessOutcome outcome = run_shell("sleep 1000 & echo $!");
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_TRUE(is_gone(std::stoi(outcome.output)));
}

TEST(Process, ProgramsAreFoundOnThePath) {
  EXPECT_THAT(find_program("sh").string(), EndsWith("/sh"));
  EXPECT_TRUE(find_program("no-such-program-anywhere").empty());
  EXPECT_TRUE(find_program("/etc/passwd").empty()) << "it cannot be run";
}

}  // namespace
}  // namespace layoutbox
