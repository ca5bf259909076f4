#include <cstring>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fusion/cloud_files.h"
#include "fusion/pose_file.h"

namespace citrine::fusion {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class RecordedFiles : public ::testing::Test {
 protected:
  RecordedFiles() { fs::create_directories(folder_); }
  ~RecordedFiles() override { fs::remove_all(folder_); }
  std::string Write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return (folder_ / name).string();
  }
  template <class T>
  static std::string Bytes(std::initializer_list<T> numbers) {
    std::string bytes(numbers.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), numbers.begin(), bytes.size());
    return bytes;
  }
  static std::string Refusal(const std::string& file) {
    try {
      ReadCloud(file);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  fs::path folder_ =
      fs::path(::testing::TempDir()) /
      ("citrine_recorded_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

const std::vector<Eigen::Vector3f> kPoints{{1, 2, 3}, {-4, 5.5f, 0}};

TEST_F(RecordedFiles, HoldTheSamePointsInEveryFormat) {
  const std::string kitti = Write("a.bin", Bytes<float>({1, 2, 3, 0.5f, -4, 5.5f, 0, 0.25f}));
  const std::string ply_text =
      Write("b.ply",
            "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 2\nproperty uchar red\n"
            "property float x\nproperty float y\nproperty double z\nend_header\n7 1 2 3\n9 -4 5.5 0\n");
  const std::string ply =
      Write("c.PLY",
            "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty double x\n"
            "property double y\nproperty double z\nelement face 0\nproperty list uchar int i\n"
            "end_header\n" +
                Bytes<double>({1, 2, 3, -4, 5.5, 0}));
  const std::string header =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
      "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ";
  const std::string pcd_text = Write("d.pcd", header + "ascii\n1 2 3 0\n-4 5.5 0 0\n");
  const std::string pcd = Write("e.pcd", header + "binary\n" + Bytes<float>({1, 2, 3, 0, -4, 5.5f, 0, 0}));
  for (const std::string& file : {kitti, ply_text, ply, pcd_text, pcd})
    EXPECT_EQ(ReadCloud(file), kPoints) << file;
  EXPECT_EQ(FindCloudFiles(folder_.string()),
            (std::vector<std::string>{kitti, ply_text, ply, pcd_text, pcd}));
}

TEST_F(RecordedFiles, LeaveOutPointsThatAreNotFinite) {
  EXPECT_EQ(
      ReadCloud(Write("a.bin", Bytes<float>({1, 2, 3, 0, NAN, 0, 0, 0, -4, 5.5f, 0, 0, INFINITY, 0, 0, 0}))),
      kPoints);
}

TEST_F(RecordedFiles, AreRefusedWithTheLineOrByteThatIsDamaged) {
  EXPECT_THAT(Refusal(Write("a.bin", std::string(40, 'x'))),
              HasSubstr("a.bin: 40 bytes are not a whole number of points of 16, cut at byte 32"));
  EXPECT_THAT(Refusal(Write("b.ply", "plx\n")), HasSubstr("b.ply:1: \"ply\" is expected"));
  EXPECT_THAT(Refusal(Write("c.ply",
                            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                            "property float z\nend_header\n1 2 3\n4 five 6\n")),
              HasSubstr("c.ply:9: \"five\" is no number"));
  EXPECT_THAT(Refusal(Write("d.ply",
                            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                            "property float z\nend_header\n1 2 3\n4 5 6\n")),
              HasSubstr("d.ply:10: the file is cut short: 3 points are announced, 2 follow"));
  EXPECT_THAT(Refusal(Write("e.ply", "ply\nformat binary_big_endian 1.0\n")),
              HasSubstr("e.ply:2: format binary_big_endian"));
  EXPECT_THAT(
      Refusal(Write("f.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n")),
      HasSubstr("f.ply:5: the header names"));
  EXPECT_THAT(
      Refusal(Write("g.pcd",
                    "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 2\nDATA binary_compressed\n")),
      HasSubstr("g.pcd:6: DATA binary_compressed"));
  EXPECT_THAT(Refusal(Write("h.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 2\nDATA binary\n" +
                                         std::string(20, '\0'))),
              HasSubstr("h.pcd: the file is cut short: 2 points are announced, 1 follow"));
  EXPECT_THAT(Refusal(Write("i.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n")),
              HasSubstr("i.pcd:3: the header does not end"));
  EXPECT_THAT(Refusal((folder_ / "none.bin").string()), HasSubstr("none.bin: cannot be read"));
}

TEST_F(RecordedFiles, MayBeNoneAtAll) {
  EXPECT_THROW(FindCloudFiles(folder_.string()), std::runtime_error);
  EXPECT_THROW(FindCloudFiles((folder_ / "missing").string()), std::runtime_error);
}

TEST_F(RecordedFiles, TellPosesInTheOrderOfTheirLines) {
  const std::string file =
      Write("poses.tum", "# t x y z qx qy qz qw\n\n0.0 1 2 3 0 0 0 1\n0.1 4 5 6 0 0 0.7071068 0.7071068\r\n");
  const std::vector<Pose> X_WS = ReadTumPoses(file);
  ASSERT_EQ(X_WS.size(), 2u);
  EXPECT_EQ(X_WS[0].p, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR((X_WS[1] * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(4, 6, 6)).norm(), 0, 1e-6);
}

TEST_F(RecordedFiles, RefuseAPoseThatIsNone) {
  const auto refusal = [&](const std::string& lines) -> std::string {
    try {
      ReadTumPoses(Write("poses.tum", lines));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal("0 1 2 3 0 0 0 1\n0.1 4 5 6 0 0 0\n"), HasSubstr("poses.tum:2: 7 numbers"));
  EXPECT_THAT(refusal("0 1 2 3 0 0 0 2\n"), HasSubstr("poses.tum:1: qx qy qz qw is no unit quaternion"));
  EXPECT_THAT(refusal("0 1 2 x 0 0 0 1\n"), HasSubstr("poses.tum:1: \"x\" is no number"));
}

}  // namespace
}  // namespace citrine::fusion
