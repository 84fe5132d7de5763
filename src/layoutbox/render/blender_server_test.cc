#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "layoutbox/base/files.h"
#include "layoutbox/render/render.h"

namespace layoutbox {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// A whole PNG of 1 × 1 pixels, as base64.
constexpr std::string_view kPixel = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNITEoGAAJOASfAYZ4ZAAAAAElFTkSuQmCC";

// A shell script that stands for a Python with bpy: reads jobs as lines, finds the folder in each, and does `job` for it.
class Server : public ::testing::Test {
 protected:
  Server() : folder_(TemporaryFolder::make("server-test").value()) {
    std::ofstream(script()) << "# blender.py\n";
    options_.save_blend = false;
    options_.time_limit_s = 20;
  }

  fs::path script() const { return folder_.path() / "blender.py"; }
  fs::path out(int n = 1) const { return folder_.path() / ("out" + std::to_string(n)); }
  fs::path file(const char* name) const { return folder_.path() / name; }

  BlenderServer server(const std::string& job, const ServerOptions& options = {}) const {
    const fs::path program = file("fake");
    std::ofstream(program) << "#!/bin/bash\necho $$ >> " << file("pids").string()
                           << "\nwhile read -r line; do\nout=$(echo \"$line\" | sed 's/.*\"words\":\\[\"\\([^\"]*\\)\".*/\\1/')\n"
                           << job << "\ndone\n";
    ::chmod(program.c_str(), 0755);
    return BlenderServer({{program.string()}, true, "5.0.1"}, options);
  }

  static std::string draw() { return "echo " + std::string(kPixel) + " | base64 -d > \"$out\"/scene.png\n"; }
  static std::string done() { return "echo 'layoutbox: done'\n"; }

  Result<RenderOutputs> render(BlenderServer& server, int n = 1) const { return server.render(script(), out(n), options_); }

  // None of the processes that were started is there any more.
  void expect_all_ended() const {
    std::ifstream pids(file("pids"));
    for (int pid = 0; pids >> pid;) EXPECT_NE(::kill(pid, 0), 0) << pid << " is still there";
  }

  TemporaryFolder folder_;
  RenderOptions options_;
};

TEST_F(Server, DrawsManyRoomsWithOneStart) {
  BlenderServer blender = server("echo 'layoutbox: progress 0.5'\n" + draw() + done());
  std::vector<double> shares;
  options_.progress = [&](double share) { shares.push_back(share); };
  for (int n = 1; n <= 5; ++n) {
    const auto made = render(blender, n);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_TRUE(fs::exists(out(n) / "scene.png"));
  }
  EXPECT_EQ(blender.starts(), 1);
  EXPECT_THAT(shares, ::testing::Contains(0.5).Times(5));
  blender.close();
  expect_all_ended();
}

TEST_F(Server, StartsOnlyWhenThereIsWork) {
  { const BlenderServer blender = server(done()); }
  EXPECT_FALSE(fs::exists(file("pids")));
}

TEST_F(Server, LeavesNoProcessBehindWhenItGoes) {
  {
    BlenderServer blender = server(draw() + done() + "sleep 100\n");
    ASSERT_TRUE(render(blender));
  }
  expect_all_ended();
}

TEST_F(Server, StartsAgainWhereItDiedAndTriesTheJobOnceMore) {
  BlenderServer blender =
      server("if [ ! -e " + file("died").string() + " ]; then touch " + file("died").string() + "; kill -SEGV $$; fi\n" + draw() + done());
  const auto made = render(blender);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(blender.starts(), 2);
}

TEST_F(Server, AJobThatAlwaysBringsItDownFailsAndTheNextOneIsDrawn) {
  BlenderServer blender =
      server("case $out in *) if [ -e " + file("bad").string() + " ]; then kill -SEGV $$; fi;; esac\n" + draw() + done());
  std::ofstream(file("bad")) << "x";
  const auto failed = render(blender);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kRenderFailed);
  EXPECT_THAT(failed.error().message, HasSubstr("crashed"));
  EXPECT_TRUE(!fs::exists(out()) || fs::is_empty(out()));
  fs::remove(file("bad"));
  EXPECT_TRUE(render(blender));
  EXPECT_EQ(blender.starts(), 3);
}

TEST_F(Server, ReportsTheErrorOfAScriptThatRaises) {
  BlenderServer blender = server("echo \"layoutbox: failed KeyError: 'oak'\"\n");
  const auto failed = render(blender);
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr("KeyError: 'oak'"));
}

TEST_F(Server, EndsAJobThatHangs) {
  BlenderServer blender = server("sleep 100\n");
  options_.time_limit_s = 0.3;
  const auto failed = render(blender);
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr("0.3 s"));
  expect_all_ended();
}

TEST_F(Server, StopsWhenAsked) {
  BlenderServer blender = server("sleep 100\n");
  std::atomic<bool> stop{false};
  options_.stop = &stop;
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    stop = true;
  });
  const auto failed = render(blender);
  stopper.join();
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kInterrupted);
  expect_all_ended();
}

TEST_F(Server, StartsAgainAfterAJobThatLeftItLarge) {
  ServerOptions limits;
  limits.restart_above_mb = 0.001;
  BlenderServer blender = server(draw() + done(), limits);
  ASSERT_TRUE(render(blender, 1));
  ASSERT_TRUE(render(blender, 2));
  EXPECT_EQ(blender.starts(), 2);
}

TEST_F(Server, EndsAJobThatNeedsTooMuchMemory) {
  ServerOptions limits;
  limits.memory_limit_mb = 40;
  BlenderServer blender = server("x=$(head -c 30000000 /dev/zero | tr '\\0' x); x=$x$x; sleep 100\n", limits);
  const auto failed = render(blender);
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr("more than 40 MB"));
  expect_all_ended();
}

TEST_F(Server, RefusesADoneWithoutAPicture) {
  BlenderServer blender = server(done());
  const auto failed = render(blender);
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr("scene.png"));
}

}  // namespace
}  // namespace layoutbox
