#include "core/map/ply.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

namespace citrine {
namespace {

class Ply : public ::testing::Test {
 protected:
  void SetUp() override {
    mesh_.vertices_W = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5f}};
    mesh_.triangles = {{0, 1, 2}};
    mesh_.confidence = {0.1f, 0.2f, 0.3f};
  }
  void TearDown() override { std::filesystem::remove(path_); }
  std::string Bytes() {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void Write(const std::string& bytes) { std::ofstream(path_, std::ios::binary) << bytes; }
  std::string Complaint() {
    try {
      ReadPly(path_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  TriMesh mesh_;
  std::string path_ = ::testing::TempDir() + "citrine_ply_test.ply";
};

TEST_F(Ply, ReadsWhatItWrote) {
  WritePly(path_, mesh_);
  const TriMesh read = ReadPly(path_);
  EXPECT_EQ(read.vertices_W, mesh_.vertices_W);
  EXPECT_EQ(read.triangles, mesh_.triangles);
  EXPECT_EQ(read.confidence, mesh_.confidence);
}

TEST_F(Ply, SaysWhatIsWrongWithADamagedFileAndWhere) {
  WritePly(path_, mesh_);
  const std::string whole = Bytes();
  Write(whole.substr(0, whole.size() - 1));
  EXPECT_THAT(Complaint(), ::testing::HasSubstr("fewer bytes than the header says"));
  Write(whole + "x");
  EXPECT_THAT(Complaint(), ::testing::HasSubstr("more bytes than the header says follow at byte"));
  std::string wrong = whole;
  wrong[whole.size() - 1] = 0x7f;  // the last index of the face
  Write(wrong);
  EXPECT_THAT(Complaint(), ::testing::HasSubstr("face 0 names a vertex that does not exist"));
  Write("plx" + whole.substr(3));
  EXPECT_THAT(Complaint(), ::testing::HasSubstr("\"ply\" is expected at byte 0"));
}

TEST_F(Ply, NamesAFileThatCannotBeOpened) {
  EXPECT_THAT(Complaint(), ::testing::HasSubstr("citrine_ply_test.ply: cannot be opened"));
}

}  // namespace
}  // namespace citrine
