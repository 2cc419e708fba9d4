// Synchronisation validation is on in the tests, and would speak: two dispatches that write one buffer need a
// barrier.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "gpu/commands.h"
#include "layout.h"
#include "spirv/points_storage.h"

namespace capcon::gpu {
namespace {

class Hazards : public ::testing::Test {
 protected:
  Instance instance_{true};
  Device device_{instance_, instance_.choose("lavapipe")};
  Kernel kernel_{
      device_, k_points_storage_spirv, {{3, Access::storage}, {6, Access::storage}}, {}, sizeof push_};
  Buffer points_{device_, 4096, Memory::host};
  layout::PointConstants push_{};

  void SetUp() override {
    // One that it reads and writes: the layer keeps quiet about writes after writes of bound buffers.
    kernel_.bind(3, points_);
    kernel_.bind(6, points_);
  }
};

TEST_F(Hazards, DispatchesOfCommandsHaveTheirBarriers) {
  Commands commands(device_);
  for (int i = 0; i < 3; ++i) commands.dispatch(kernel_, &push_, 1, "points");
  commands.submit_and_wait();
  points_.clear();
  EXPECT_EQ(instance_.message_count(), 0);
}

TEST_F(Hazards, ADispatchWithoutOneIsReported) {
  Commands commands(device_);
  commands.dispatch(kernel_, &push_, 1, "points");
  vkCmdDispatch(commands.handle(), 1, 1, 1);
  EXPECT_GT(instance_.message_count(), 0) << "synchronisation validation is off";
  commands.submit_and_wait();
}

TEST_F(Hazards, SoIsAFillOfWhatWasJustWritten) {
  Commands commands(device_);
  commands.dispatch(kernel_, &push_, 1, "points");
  vkCmdFillBuffer(commands.handle(), points_.handle(), 0, VK_WHOLE_SIZE, 0);
  EXPECT_GT(instance_.message_count(), 0) << "synchronisation validation is off";
  commands.submit_and_wait();
}

}  // namespace
}  // namespace capcon::gpu
