// SPDX-License-Identifier: MIT
// Gruebler: a planar body has three freedoms, a pin takes two of them, and each redundant
// constraint gives one back.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>

#include "../mechanism/files.h"
#include "moivre/kinematics/mobility.h"
#include "random_values.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using test::RandomValues;

/// Bodies in random poses, and pins at random places, given in the frames of both bodies: assembled
/// as it is.
class PinnedBodies {
 public:
  PinnedBodies(std::size_t bodies, std::uint64_t seed) : random_(seed), points_(bodies + 1) {
    q_ = VectorXd::Zero(static_cast<Index>(3 * bodies));
    for (Index k = 0; k < q_.size(); ++k) q_[k] = random_.between(-3, 3);
  }

  /// Body 0 is the ground.
  void pin(std::size_t a, std::size_t b) {
    const Vector2d place(random_.between(-5, 5), random_.between(-5, 5));
    const std::string name = "P" + std::to_string(pins_++);
    std::string ends;
    for (const std::size_t body : {a, b}) {
      const Vector2d own = in_frame_of(body, place);
      char text[96];
      std::snprintf(text, sizeof text, "%s = [%.17g, %.17g]\n", name.c_str(), own.x(), own.y());
      points_[body] += text;
      ends += (ends.empty() ? "\"" : ", \"") + name_of(body) + "." + name + "\"";
    }
    joints_ += "[[joint]]\ntype = \"revolute\"\nat = [" + ends + "]\n";
  }

  Mobility mobility() const {
    std::string text;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      text += (k == 0 ? "[ground.points]\n" : "[body." + name_of(k) + ".points]\n") + points_[k];
    }
    return moivre::mobility(Phi(test::typed(text + joints_)), q_);
  }

  std::size_t bodies() const { return points_.size() - 1; }
  std::size_t pins() const { return pins_; }
  RandomValues& random() { return random_; }

 private:
  static std::string name_of(std::size_t body) {
    return body == 0 ? "ground" : "b" + std::to_string(body);
  }
  Vector2d in_frame_of(std::size_t body, const Vector2d& place) const {
    if (body == 0) return place;
    const Eigen::Vector3d pose = q_.segment<3>(static_cast<Index>(3 * (body - 1)));
    return Eigen::Rotation2Dd(-pose[2]) * (place - pose.head<2>());
  }

  RandomValues random_;
  VectorXd q_;
  std::vector<std::string> points_;
  std::string joints_;
  std::size_t pins_ = 0;
};

Index count_of(const PinnedBodies& linkage) {
  return static_cast<Index>(3 * linkage.bodies()) - static_cast<Index>(2 * linkage.pins());
}

/// Each body is pinned to one before it.
PinnedBodies random_tree(std::size_t bodies, std::uint64_t seed) {
  PinnedBodies tree(bodies, seed);
  for (std::size_t b = 1; b <= bodies; ++b) tree.pin(b, tree.random().below(b));
  return tree;
}

TEST(Gruebler, AnOpenChainHasAFreedomForEachPin) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const PinnedBodies tree = random_tree(1 + seed, seed);
    const Mobility m = tree.mobility();
    EXPECT_EQ(m.degrees_of_freedom, static_cast<Index>(tree.pins()));
    EXPECT_EQ(m.degrees_of_freedom, count_of(tree));
    EXPECT_TRUE(m.redundant.empty());
  }
}

TEST(Gruebler, AnAssurGroupChangesNoFreedom) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    // A crank, and dyads pinned to two of the bodies before them.
    constexpr std::size_t kDyads = 4;
    PinnedBodies linkage(1 + 2 * kDyads, seed);
    linkage.pin(1, 0);
    for (std::size_t k = 0; k < kDyads; ++k) {
      const std::size_t first = 2 * k + 2;
      const std::size_t a = linkage.random().below(first);
      const std::size_t b = (a + 1 + linkage.random().below(first - 1)) % first;
      linkage.pin(first, a);
      linkage.pin(first + 1, b);
      linkage.pin(first, first + 1);
    }
    EXPECT_EQ(count_of(linkage), 1);
    EXPECT_EQ(linkage.mobility().degrees_of_freedom, 1) << seed;
  }
}

TEST(Gruebler, EachRedundantConstraintGivesAFreedomBack) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    PinnedBodies linkage = random_tree(2 + seed % 4, seed);
    const std::size_t bodies = linkage.bodies();
    for (std::size_t extra = 0; extra < 1 + seed % 6; ++extra) {
      const std::size_t a = linkage.random().below(bodies + 1);
      linkage.pin(a, (a + 1 + linkage.random().below(bodies)) % (bodies + 1));
    }
    const Mobility m = linkage.mobility();
    EXPECT_EQ(m.gruebler, count_of(linkage));
    EXPECT_GE(m.degrees_of_freedom, std::max<Index>(m.gruebler, 0));
    EXPECT_EQ(m.degrees_of_freedom, m.gruebler + static_cast<Index>(m.redundant.size())) << seed;
    EXPECT_EQ(m.left_null_space.cols(), static_cast<Index>(m.redundant.size())) << seed;
    EXPECT_EQ(m.null_space.cols(), m.degrees_of_freedom) << seed;
    EXPECT_EQ(m.rank, m.rank_by_svd) << seed;
  }
}

TEST(Gruebler, TwoPinsBetweenTwoBodiesHaveOneRedundantConstraint) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    PinnedBodies linkage(1, seed);
    linkage.pin(1, 0);
    linkage.pin(1, 0);
    const Mobility m = linkage.mobility();
    EXPECT_EQ(m.gruebler, -1);
    EXPECT_EQ(m.degrees_of_freedom, 0);
    EXPECT_EQ(m.redundant.size(), 1U);
  }
}

}  // namespace
}  // namespace moivre
