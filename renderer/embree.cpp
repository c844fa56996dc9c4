// SPDX-License-Identifier: MIT
#include "embree.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>

#include "graspdb/core/error.h"

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace graspdb::embree {
namespace {

// The device of the process. It keeps Embree's default thread count, because Embree would impose
// any other one on all of TBB.
RTCDevice device() {
  static const std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> owner(rtcNewDevice(nullptr),
                                                                       rtcReleaseDevice);
  GRASPDB_CHECK(owner != nullptr);
  return owner.get();
}

template <typename Element>
void copy_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                 const std::vector<Element>& elements) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element),
                                         std::max<std::size_t>(elements.size(), 1));
  GRASPDB_CHECK(buffer != nullptr);
  std::uninitialized_copy(elements.begin(), elements.end(), static_cast<Element*>(buffer));
}

void check_mesh(const Mesh& mesh) {
  GRASPDB_CHECK(!mesh.triangles.empty());
  GRASPDB_CHECK(mesh.normals.size() == mesh.vertices.size());
  GRASPDB_CHECK(mesh.albedo.empty() || mesh.albedo.size() == mesh.vertices.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) GRASPDB_CHECK(vertex < mesh.vertices.size());
  }
}

void attach(RTCScene scene, const Mesh& mesh, unsigned id, Visible mask) {
  check_mesh(mesh);
  RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  copy_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices);
  copy_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
  rtcSetGeometryMask(geometry, mask);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

}  // namespace

SceneHandle build_scene(const Mesh& hand, const Mesh* object) {
  GRASPDB_CHECK(rtcGetDeviceProperty(device(), RTC_DEVICE_PROPERTY_RAY_MASK_SUPPORTED) != 0);
  SceneHandle scene(rtcNewScene(device()));
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  attach(scene.get(), hand, 0, kHandOnly);
  if (object != nullptr) attach(scene.get(), *object, 1, kObjectOnly);
  // Many scenes are built at once by the caller's threads: sharing one build among them would only
  // make them wait for each other.
  tbb::task_arena(1).execute([&] { rtcCommitScene(scene.get()); });
  GRASPDB_CHECK(rtcGetDeviceError(device()) == RTC_ERROR_NONE);
  return scene;
}

#if defined(__SSE__)
FlushDenormals::FlushDenormals() : before_(_mm_getcsr()) {
  constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
  _mm_setcsr(before_ | kFlushToZero | kDenormalsAreZero);
}
FlushDenormals::~FlushDenormals() {
  _mm_setcsr(before_);
}
#else
FlushDenormals::FlushDenormals() : before_(0) {}
FlushDenormals::~FlushDenormals() = default;
#endif

RTCIntersectContext coherent_context() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

}  // namespace graspdb::embree
