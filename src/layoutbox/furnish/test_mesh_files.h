// A folder with a mesh file in it, for tests.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include "layoutbox/base/files.h"
#include "layoutbox/furnish/mesh_checks.h"
#include "layoutbox/furnish/mesh_file.h"

namespace layoutbox {

namespace fs = std::filesystem;

// A box 2 wide (x), 1 high (y), 4 deep (z), with a red material.
inline constexpr std::string_view kBox =
    "mtllib box.mtl\nusemtl red\n"
    "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 4\nv 2 0 4\nv 2 1 4\nv 0 1 4\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";

class MeshFiles : public ::testing::Test {
 protected:
  MeshFiles() : folder_(TemporaryFolder::make("mesh-test").value()) {
    fs::create_directories(assets());
    put("box.obj", kBox);
    put("box.mtl", "newmtl red\nKd 0.9 0.1 0.1\n");
  }
  fs::path assets() const { return folder_.path() / "assets"; }
  void put(const std::string& name, std::string_view bytes) const { std::ofstream(assets() / name, std::ios::binary) << bytes; }
  Result<MeshFile> read(const std::string& name, const MeshLimits& limits = {}) const {
    const std::array folders{assets()};
    return read_mesh_file(folders, name, limits);
  }
  void expect_error(const std::string& name, ErrorCode code, const char* words, const MeshLimits& limits = {}) const {
    const auto mesh = read(name, limits);
    ASSERT_FALSE(mesh) << name;
    EXPECT_EQ(mesh.error().code, code) << mesh.error().message;
    EXPECT_THAT(mesh.error().message, ::testing::HasSubstr(words));
    EXPECT_THAT(mesh.error().message, ::testing::HasSubstr(fs::path(name).filename().string()));
  }
  static kit::Box bounds(const MeshFile& mesh) {
    Node node;
    node.parts = mesh.parts;
    return mesh_checks::bounds_of(node);
  }

  TemporaryFolder folder_;
};

}  // namespace layoutbox
