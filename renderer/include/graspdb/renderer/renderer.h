// SPDX-License-Identifier: MIT
// Pictures of a posed hand and what it holds: seen by rays (Embree), or drawn triangle by triangle.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "graspdb/core/camera.h"
#include "graspdb/core/image.h"
#include "graspdb/core/mesh.h"

namespace graspdb {

enum SurfaceLabel : std::uint8_t { kBackground = 0, kHandSurface = 1, kObjectSurface = 2 };

// Posed meshes in the hand frame, ready for rays. Immutable after construction, and so safe to
// render from many threads. `hand_parts` is a part number for each vertex (a triangle takes its
// first one's), `hand_openness` what ambient_openness() gave for the same meshes; both may be
// empty, which means part 0 and wide open. `object` may be null. Meshes are copied.
class Scene {
 public:
  Scene(const Mesh& hand, std::span<const std::uint8_t> hand_parts, const Mesh* object,
        std::span<const float> hand_openness = {});
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  struct State;
  const State& state() const { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

// How open each vertex of the hand is to the outside, 0..1: the share of the rays into its
// hemisphere, each weighed by the cosine to the normal, that hit nothing within `reach` metres. All
// vertices use the same 2 x `rays` directions, evenly spread over the sphere, so that the result
// varies smoothly along the skin and is deterministic. Given to a Scene, it darkens the creases
// between touching fingers. 16 rays and a reach of 0.03 m show them.
std::vector<float> ambient_openness(const Mesh& hand, const Mesh* object, int rays, double reach);

// Grey = 255 * albedo * (ambient * openness + diffuse * lit), clipped, with normal, albedo and
// openness interpolated between the triangle's vertices. `lit` is max(0, cosine to the light +
// softness) / (1 + softness): a softness above 0 is a wide light, which reaches round to what is
// turned away.
struct Light {
  double ambient = 0.35;
  double diffuse = 0.6;
  double softness = 0;                                // 0..1
  Eigen::Vector3d towards_light_in_camera{0, 0, -1};  // need not be of unit length
};

// Which pictures are wanted beside shading and label.
struct Layers {
  bool depth = false;
  bool normals = false;
  bool parts = false;
  bool amodal = false;
};

struct View {
  GrayImage shading;              // of every surface; 0 where there is none
  Image<std::uint8_t> label;      // SurfaceLabel of what is nearest
  Image<float> depth;             // planar z, metres; +infinity where nothing is hit
  Image<Eigen::Vector3f> normal;  // unit, in the camera frame; 0 where nothing is hit
  Image<std::uint8_t> part;       // hand part + 1 of visible hand, else 0
  Mask hand_amodal;               // the hand as if no object were there
  Mask object_amodal;
};

// Thread-safe. One ray a pixel, through its centre.
View render(const Scene& scene, const Camera& camera, const Light& light = {},
            const Layers& layers = {});

// The picture that render() makes without layers, four times as fast for a hand at the size of a
// row: each triangle is tested against the rays of the few pixels around it, where render() tests
// each ray against the triangles around it. For closed meshes whose triangles run counter-clockwise
// seen from outside: of them, only what faces the camera can be seen and is drawn, and triangles
// that skinning has turned over, from both sides. Pictures agree in all but a few pixels of a
// million at outlines, and in shading but for 3 pixels of 10,000 (where skin has folded into
// itself, Embree sees it from inside). A scene that comes nearer to the camera than 20 mm is left
// to render(); all others give the same bytes with every instruction set. Thread-safe.
View rasterize(const Scene& scene, const Camera& camera, const Light& light = {});

// The visible hand: 255 where the label is kHandSurface.
Mask visible_hand(const View& view);

// For each joint centre (a point inside the hand): whether it is seen, that is inside the picture,
// and the first surface on the way to it is its own skin: no object, and no hand skin nearer than
// the point's depth minus its own radius (metres, one a point). Thread-safe.
std::vector<bool> visible_points(const Scene& scene, const Camera& camera,
                                 std::span<const Eigen::Vector3d> points_in_hand,
                                 std::span<const double> radii);

// Whether a point of the camera frame lies in front of the camera and projects into the picture.
bool inside_picture(const Intrinsics& k, const Eigen::Vector3d& in_camera);

// The camera that looks along `camera_from_hand` rotation at `centre` from `distance` metres and
// whose square picture of resolution x resolution pixels just holds all `vertices` plus a margin (a
// share of the side). The optical axis goes through the centre: the crop is off-axis, K is that of
// the crop.
Camera crop_camera(const Eigen::Matrix3d& camera_from_hand, const Eigen::Vector3d& center,
                   double distance, std::span<const Eigen::Vector3f> vertices, int resolution,
                   double margin = 0.04);

}  // namespace graspdb
