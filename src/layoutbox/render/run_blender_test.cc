#include <gmock/gmock.h>
#include <gtest/gtest.h>
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

// A program that stands for Blender: a shell script that gets the script and the folder as its first words, like a Python with bpy.
class RunBlender : public ::testing::Test {
 protected:
  RunBlender() : folder_(TemporaryFolder::make("render-test").value()) {
    std::ofstream(script()) << "# blender.py\n";
    options_.save_blend = false;
    options_.time_limit_s = 20;
  }

  fs::path script() const { return folder_.path() / "blender.py"; }
  fs::path out() const { return folder_.path() / "out"; }

  Result<RenderOutputs> run(const std::string& shell) {
    const fs::path program = folder_.path() / "fake";
    std::ofstream(program) << "#!/bin/sh\nout=\"$2\"\n" << shell << "\n";
    ::chmod(program.c_str(), 0755);
    return run_blender({{program.string()}, true, "5.0.1"}, script(), out(), options_);
  }

  // The user's folder holds nothing, not even a half or hidden file.
  void expect_nothing_left() const { EXPECT_TRUE(!fs::exists(out()) || fs::is_empty(out())); }

  static std::string write_pixel(const char* name) { return "echo " + std::string(kPixel) + " | base64 -d > \"$out\"/" + name; }

  TemporaryFolder folder_;
  RenderOptions options_;
};

TEST_F(RunBlender, DeliversThePictureThatBlenderMade) {
  std::vector<double> shares;
  options_.progress = [&](double share) { shares.push_back(share); };
  const auto made = run("echo 'layoutbox: blender 4.5.1'; echo 'layoutbox: progress 0.25'; " + write_pixel("scene.png"));
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->picture, out() / "scene.png");
  EXPECT_TRUE(fs::exists(made->picture));
  EXPECT_EQ(made->blender_version, "4.5.1");
  EXPECT_THAT(shares, ::testing::ElementsAre(0.25, 1.0));
}

TEST_F(RunBlender, AsksForMaskAndBlendOnlyWhereWished) {
  const auto made = run("echo \"$@\" > " + (folder_.path() / "words").string() + "; " + write_pixel("scene.png"));
  ASSERT_TRUE(made);
  EXPECT_THAT(read_file(folder_.path() / "words").value(), HasSubstr("--no-blend"));
  EXPECT_TRUE(made->mask.empty());
  options_.object_mask = true;
  const auto masked = run(write_pixel("scene.png") + "; " + write_pixel("mask.png") + "; echo '{}' > \"$out\"/mask.json");
  ASSERT_TRUE(masked) << masked.error().message;
  EXPECT_TRUE(fs::exists(masked->mask_index));
}

TEST_F(RunBlender, RunsItInAHomeOfItsOwnThatIsRemoved) {
  const auto made = run("echo \"$HOME\" > " + (folder_.path() / "home").string() + "; touch \"$HOME\"/cache; " + write_pixel("scene.png"));
  ASSERT_TRUE(made);
  std::string home = read_file(folder_.path() / "home").value();
  home.pop_back();
  EXPECT_NE(home, std::getenv("HOME"));
  EXPECT_FALSE(fs::exists(home));
}

TEST_F(RunBlender, ReportsTheErrorOfAScriptThatRaises) {
  const auto made = run("echo Traceback; echo '  File \"x\"'; echo \"KeyError: 'oak'\"; exit 3");
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kRenderFailed);
  EXPECT_THAT(made.error().message, HasSubstr("KeyError: 'oak'"));
  expect_nothing_left();
}

TEST_F(RunBlender, ReportsACrash) {
  const auto made = run(write_pixel("scene.png") + "; kill -SEGV $$");
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("crashed"));
  expect_nothing_left();
}

TEST_F(RunBlender, EndsOneThatHangs) {
  options_.time_limit_s = 0.3;
  const auto made = run(write_pixel("scene.png") + "; sleep 60");
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kRenderFailed);
  EXPECT_THAT(made.error().message, HasSubstr("0.3 s"));
  expect_nothing_left();
}

TEST_F(RunBlender, StopsWhenAsked) {
  std::atomic<bool> stop{false};
  options_.stop = &stop;
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    stop = true;
  });
  const auto made = run("sleep 60");
  stopper.join();
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kInterrupted);
  expect_nothing_left();
}

TEST_F(RunBlender, RefusesSuccessWithoutAPicture) {
  const auto made = run("echo all is well");
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("without writing scene.png"));
  expect_nothing_left();
}

TEST_F(RunBlender, RefusesATruncatedPicture) {
  const auto made = run(write_pixel("whole.png") + "; head -c 50 \"$out\"/whole.png > \"$out\"/scene.png");
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("cut off"));
  expect_nothing_left();
}

TEST_F(RunBlender, RefusesAMissingBlend) {
  options_.save_blend = true;
  const auto made = run(write_pixel("scene.png"));
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("scene.blend"));
}

TEST_F(RunBlender, FallsBackWhereThereIsNoGl) {
  options_.quality = Quality::kDraft;
  const fs::path program = folder_.path() / "fake";
  std::ofstream(program) << "#!/bin/sh\nwhile [ \"$1\" != -- ]; do shift; done; shift; out=\"$1\"\n"
                         << "case \"$*\" in *workbench*) kill -ABRT $$;; esac\n"
                         << write_pixel("scene.png") << "\n";
  ::chmod(program.c_str(), 0755);
  const auto made = run_blender({{program.string()}, false, "3.4.1"}, script(), out(), options_);
  EXPECT_TRUE(made) << made.error().message;
}

TEST_F(RunBlender, SaysWhatIsMissing) {
  EXPECT_EQ(run_blender({{}, true, ""}, script(), out(), options_).error().code, ErrorCode::kNoBlender);
  EXPECT_EQ(run_blender({{"true"}, true, ""}, folder_.path() / "none.py", out(), options_).error().code, ErrorCode::kIo);
}

class FindBlender : public ::testing::Test {
 protected:
  FindBlender() : folder_(TemporaryFolder::make("find-test").value()) {
    if (const char* value = std::getenv("LAYOUTBOX_BLENDER")) kept_ = value;
  }
  ~FindBlender() override { kept_.empty() ? unsetenv("LAYOUTBOX_BLENDER") : setenv("LAYOUTBOX_BLENDER", kept_.c_str(), 1); }

  std::string program(const std::string& name, const std::string& shell) const {
    const fs::path path = folder_.path() / name;
    std::ofstream(path) << "#!/bin/sh\n" << shell << "\n";
    ::chmod(path.c_str(), 0755);
    return path.string();
  }
  static Result<Blender> find(const std::string& named) {
    setenv("LAYOUTBOX_BLENDER", named.c_str(), 1);
    return find_blender();
  }

  TemporaryFolder folder_;
  std::string kept_;
};

TEST_F(FindBlender, TakesTheOneThatTheUserNames) {
  const std::string path = program("my-blender", "echo 'Blender 4.2.3 LTS'; echo '  build date: …'");
  const auto blender = find(path);
  ASSERT_TRUE(blender) << blender.error().message;
  EXPECT_EQ(blender->version, "4.2.3");
  EXPECT_FALSE(blender->is_python_module);
  EXPECT_THAT(blender->command, ::testing::ElementsAre(path));
}

TEST_F(FindBlender, TakesAPythonWithBpy) {
  const auto blender =
      find(program("python", "[ \"$1\" = --version ] && echo 'Python 3.11.2' && exit; echo 'bpy 5.0.1'; echo 'at /usr/bin/python9'"));
  ASSERT_TRUE(blender) << blender.error().message;
  EXPECT_TRUE(blender->is_python_module);
  EXPECT_EQ(blender->version, "5.0.1");
  EXPECT_THAT(blender->command, ::testing::ElementsAre("/usr/bin/python9"));
}

TEST_F(FindBlender, RefusesNonsenseInWords) {
  const auto expect_words = [](const Result<Blender>& found, const char* words) {
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::kNoBlender);
    EXPECT_THAT(found.error().message, HasSubstr(words));
    EXPECT_FALSE(found.error().hint.empty());
  };
  expect_words(find("/no/such/blender"), "not there");
  expect_words(find(folder_.path().string()), "folder");
  expect_words(find(program("other", "echo 'GNU bash'")), "no Blender");
  expect_words(find(program("fails", "exit 1")), "does not start");
  expect_words(find(program("python3", "[ \"$1\" = --version ] && echo 'Python 3.11.2' && exit; exit 1")), "without the module bpy");
}

}  // namespace
}  // namespace layoutbox
