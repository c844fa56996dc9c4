// SPDX-License-Identifier: MIT
// The measures of a made hand, taken from its skin in the flat pose.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "graspdb/hand/maker/hand_maker.h"
#include "support/made_hands.h"

namespace graspdb {
namespace {

using Points = std::vector<Eigen::Vector3d>;

class FlatHand {
 public:
  explicit FlatHand(const HandShape& shape)
      : hand_(make_hand(shape)),
        skin_(pose_skin(hand_, JointAngles::Zero())),
        strongest_(strongest_bones(hand_)) {}

  Eigen::Vector3d joint_mm(int bone) const {
    return 1000 * hand_.skeleton.hand_from_bone_at_zero[bone].translation;
  }

  // Where the skin's edges cross a plane, millimetres from `origin`. The thumb and, on request,
  // other parts of the skin do not count.
  template <typename Counts>
  Points section(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal,
                 const Counts& counts) const {
    Points points;
    for (const Triangle& t : skin_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d a = vertex(t[i]) - origin, b = vertex(t[(i + 1) % 3]) - origin;
        const double u = a.dot(normal), v = b.dot(normal);
        if (u * v < 0 && counts(strongest_[t[i]])) points.push_back(a + u / (u - v) * (b - a));
      }
    }
    return points;
  }

  double length_mm() const {
    double tip = 0;
    for (const Eigen::Vector3f& v : skin_.vertices) tip = std::max<double>(tip, 1000 * v.y());
    return tip;
  }

 private:
  Eigen::Vector3d vertex(std::size_t i) const { return 1000 * skin_.vertices[i].cast<double>(); }

  Hand hand_;
  Mesh skin_;
  std::vector<std::uint8_t> strongest_;
};

double extent(const Points& points, const Eigen::Vector3d& direction) {
  double low = 1e9, high = -1e9;
  for (const Eigen::Vector3d& point : points) {
    low = std::min(low, point.dot(direction));
    high = std::max(high, point.dot(direction));
  }
  return high - low;
}

bool is_not_of_the_thumb(int bone) {
  return bone < kThumbMetacarpal || bone > kThumbDistal;
}

double breadth_mm(const FlatHand& hand) {
  const Eigen::Vector3d index = hand.joint_mm(finger_bone(0, kProximal));
  const Eigen::Vector3d across = (hand.joint_mm(finger_bone(3, kProximal)) - index).normalized();
  const Eigen::Vector3d along = Eigen::Vector3d::UnitZ().cross(across).normalized();
  return extent(hand.section(index, along, is_not_of_the_thumb), across);
}

double finger_breadth_mm(const FlatHand& hand) {
  const auto is_of_the_index = [](int bone) {
    return bone >= finger_bone(0, kProximal) && bone <= finger_bone(0, kDistal);
  };
  const Points around = hand.section(hand.joint_mm(finger_bone(0, kMiddle)),
                                     Eigen::Vector3d::UnitY(), is_of_the_index);
  return extent(around, Eigen::Vector3d::UnitX());
}

double palm_thickness_mm(const FlatHand& hand) {
  const Eigen::Vector3d middle =
      .5 * (hand.joint_mm(finger_bone(1, kMetacarpal)) + hand.joint_mm(finger_bone(1, kProximal)));
  // What lies nearest to the bone's axis on the back and in the palm.
  Eigen::Vector3d back(1e9, 0, 0), palm(1e9, 0, 0);
  for (const Eigen::Vector3d& p :
       hand.section(middle, Eigen::Vector3d::UnitY(), is_not_of_the_thumb)) {
    Eigen::Vector3d& nearest = p.z() > 0 ? back : palm;
    if (std::abs(p.x()) < std::abs(nearest.x())) nearest = p;
  }
  return back.z() - palm.z();
}

double forearm_breadth_mm(const FlatHand& hand, double length_mm) {
  const Points around =
      hand.section({0, -length_mm / 8, 0}, Eigen::Vector3d::UnitY(), [](int) { return true; });
  return extent(around, Eigen::Vector3d::UnitX());
}

void expect_measures(const HandShape& shape) {
  SCOPED_TRACE(shape.name);
  const FlatHand hand(shape);
  EXPECT_NEAR(hand.length_mm(), shape.length_mm, .01 * shape.length_mm);
  EXPECT_NEAR(breadth_mm(hand), shape.breadth_mm, .01 * shape.breadth_mm);
  const Eigen::Vector3d knuckle = hand.joint_mm(finger_bone(1, kProximal));
  EXPECT_NEAR(hand.length_mm() - knuckle.y(), shape.finger_length_mm, .02 * shape.length_mm);
  EXPECT_NEAR(finger_breadth_mm(hand), shape.finger_breadth_mm, .03 * shape.finger_breadth_mm);
  EXPECT_NEAR(palm_thickness_mm(hand), shape.palm_thickness_mm, .03 * shape.palm_thickness_mm);
  EXPECT_NEAR(forearm_breadth_mm(hand, shape.length_mm), shape.forearm_breadth_mm,
              .03 * shape.forearm_breadth_mm);
  const auto ends_beyond = [&](double back_mm) {
    const Eigen::Vector3d there(0, -back_mm, 0);
    return !hand.section(there, Eigen::Vector3d::UnitY(), [](int) { return true; }).empty();
  };
  EXPECT_TRUE(ends_beyond(shape.forearm_length_mm - 1));
  EXPECT_FALSE(ends_beyond(shape.forearm_length_mm + 1));
}

class DefaultShape : public ::testing::TestWithParam<std::string> {};

TEST_P(DefaultShape, MeasuresWhatItSays) {
  expect_measures(default_hand_shape(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(HandShape, DefaultShape, ::testing::ValuesIn(testing::made_hands()),
                         [](const auto& test) { return test.param; });

#ifndef __SANITIZE_ADDRESS__  // see made_hands()
// Every measure near both ends of what hands have.
TEST(HandShape, OddHandsMeasureWhatIsAsked) {
  expect_measures({"giant", 235, 112, 135, 27, 44, 58, 290});
  expect_measures({"thin", 205, 76, 101, 14.5, 20, 64, 70});
  expect_measures({"small", 104, 54, 61, 10.5, 14, 46, 150});
}
#endif

TEST(HandShape, UnnamedMeasuresStayInProportion) {
  const HandShape base = default_hand_shape("female");
  const HandShape longer = in_proportion(base, {.length_mm = 1.1 * base.length_mm});
  EXPECT_NEAR(longer.breadth_mm, 1.1 * base.breadth_mm, 1e-9);
  EXPECT_NEAR(longer.finger_length_mm, 1.1 * base.finger_length_mm, 1e-9);
  EXPECT_NEAR(longer.finger_breadth_mm, 1.1 * base.finger_breadth_mm, 1e-9);
  EXPECT_NEAR(longer.palm_thickness_mm, 1.1 * base.palm_thickness_mm, 1e-9);
  EXPECT_NEAR(longer.forearm_breadth_mm, 1.1 * base.forearm_breadth_mm, 1e-9);
  EXPECT_NEAR(longer.forearm_length_mm, 1.1 * base.forearm_length_mm, 1e-9);
  const HandShape broader = in_proportion(base, {.breadth_mm = 82, .palm_thickness_mm = 30});
  EXPECT_EQ(broader.length_mm, base.length_mm);
  EXPECT_EQ(broader.finger_length_mm, base.finger_length_mm);
  EXPECT_EQ(broader.palm_thickness_mm, 30);
  EXPECT_NEAR(broader.finger_breadth_mm, base.finger_breadth_mm * 82 / 78, 1e-9);
}

}  // namespace
}  // namespace graspdb
