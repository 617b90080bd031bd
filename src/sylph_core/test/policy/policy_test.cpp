#include "sylph_core/policy/policy.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "test/support/random_weights.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

class PolicyTest : public ::testing::Test {
 protected:
  void expectRefused(const std::string& error) const {
    try {
      const Policy policy(weights_, "w.safetensors");
      FAIL() << "accepted";
    } catch (const std::runtime_error& thrown) {
      EXPECT_EQ("w.safetensors: " + error, thrown.what());
    }
  }

  TensorFile weights_ = RandomWeights(smallShape(), 3).file();
};

TEST_F(PolicyTest, ReadsWhetherTheMemoryIsFedBack) {
  EXPECT_FALSE(Policy(weights_, "w").hasMemory());
  weights_.metadata["memory"] = "true";
  EXPECT_TRUE(Policy(weights_, "w").hasMemory());
  weights_.metadata["memory"] = "false";
  EXPECT_FALSE(Policy(weights_, "w").hasMemory());
  weights_.metadata["memory"] = "yes";
  expectRefused("metadata 'memory' is 'yes': must be 'true' or 'false'");
}

TEST_F(PolicyTest, LoadsWhatWasSaved) {
  const TemporaryFolder folder;
  saveTensorFile(weights_, folder.path("w.safetensors"));
  EXPECT_EQ(24, Policy::load(folder.path("w.safetensors")).network().shape().width);
}

TEST_F(PolicyTest, RefusesNetworksForOtherObservations) {
  weights_.metadata["channels"] = "20";
  expectRefused("metadata 'channels' is '20': must be '32'");
  weights_.metadata["channels"] = "32";
  weights_.metadata["svo_levels"] = "5";
  expectRefused("metadata 'svo_levels' is '5': must be '10'");
  weights_.metadata.erase("svo_levels");
  expectRefused("metadata has no entry 'svo_levels'");
}

TEST_F(PolicyTest, RefusesOtherObservationsNamingWhatDiffers) {
  std::string& described = weights_.metadata["observation"];
  const std::string right = described;
  const std::string first = "obstacle [0, 1]: an obstacle or outside the map";
  const std::string second = "agent [0, 1]: an agent, oneself included";
  ASSERT_EQ(0U, right.find(first + "\n" + second + "\n"));
  described = right.substr(first.size() + 1);
  expectRefused("metadata 'observation' has '" + second + "' as entry 0: must be '" + first + "'");
  described = first;
  expectRefused("metadata 'observation' lacks entry 1, '" + second + "'");
  described = right + "\nmore [0, 1]: of it";
  expectRefused(
      "metadata 'observation' has 'more [0, 1]: of it' as entry 39: must be none, this build sees "
      "less");
  weights_.metadata.erase("observation");
  expectRefused("metadata has no entry 'observation'");
}

TEST_F(PolicyTest, RefusesSizesThatAreNoWholeNumbers) {
  for (const std::string text : {"24x", " 24", "+24", "24.0", "0x18", "99999999999", ""}) {
    weights_.metadata["width"] = text;
    expectRefused("metadata 'width' is '" + text + "': must be a whole number");
  }
}

TEST_F(PolicyTest, RefusesTensorsOfAnotherShape) {
  weights_.metadata["near_width"] = "7";
  expectRefused("tensor 'encoder.conv1.weight' has the shape [6, 32, 3, 3]: must be [7, 32, 3, 3]");
  weights_ = RandomWeights(smallShape(), 3).file();
  weights_.tensors.erase("heads.svo.bias");
  expectRefused("has no tensor 'heads.svo.bias'; the network needs it, of shape [10]");
}

TEST_F(PolicyTest, RefusesInOneLineWhateverTheWeightsHold) {
  weights_.tensors["a\nb"] = {{1}, {0.F}};
  expectRefused("tensor 'a?b' is no part of the network");
  weights_.metadata["architecture"] = "a\nb";
  expectRefused("metadata 'architecture' is 'a?b': must be 'sylph-2'");
  weights_ = RandomWeights(smallShape(), 3).file();
  weights_.metadata["memory"] = "a\nb";
  expectRefused("metadata 'memory' is 'a?b': must be 'true' or 'false'");
}

TEST_F(PolicyTest, IgnoresMetadataThatItDoesNotKnow) {
  weights_.metadata["cost_width"] = "0";  // as weights had that said to have no cost head
  EXPECT_EQ(24, Policy(weights_, "w").network().shape().width);
}

TEST_F(PolicyTest, ReadsTheCostNetworkBesideThePolicy) {
  EXPECT_EQ(nullptr, Policy(weights_, "w").costNetwork());
  weights_ = withCostNetwork(weights_, RandomWeights(smallShape(), 4).file());
  const Policy policy(weights_, "w");
  ASSERT_NE(nullptr, policy.costNetwork());
  EXPECT_EQ(policy.network().multiplyAdds(), policy.costNetwork()->multiplyAdds());
  weights_.tensors.erase("cost.goal.bias");
  try {
    const Policy refused(weights_, "w.safetensors");
    FAIL() << "accepted";
  } catch (const std::runtime_error& thrown) {
    EXPECT_EQ(
        "w.safetensors, cost network: has no tensor 'goal.bias'; the network needs it, of shape "
        "[4]",
        std::string(thrown.what()));
  }
}

}  // namespace
}  // namespace sylph
