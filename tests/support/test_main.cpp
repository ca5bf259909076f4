#include <cstdlib>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

/// Runs the tests with a temporary folder of this process alone, so that any two may run at once.
int main(int argc, char** argv) {
  std::string folder = std::filesystem::temp_directory_path() / "citrine_test_XXXXXX";
  if (!mkdtemp(folder.data())) return 1;
  setenv("TEST_TMPDIR", folder.c_str(), 1);
  ::testing::InitGoogleMock(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  std::filesystem::remove_all(folder);
  return failed;
}
