// SPDX-License-Identifier: MIT
#include "track_camera.h"

#include <fmt/format.h>

#include "checks.h"
#include "graspdb/core/error.h"

namespace graspdb::cli {
namespace {

Intrinsics of_sequence(const WrittenSequence& sequence, int width, int height) {
  const Intrinsics& camera = sequence.camera;
  if (camera.width == width && camera.height == height) return camera;
  throw Error({sequence.directory.string(), "frames/",
               fmt::format("pictures of {} x {} pixels", camera.width, camera.height),
               fmt::format("{} x {}", width, height)});
}

}  // namespace

void add_camera_options(CLI::App& verb, CameraSettings& settings) {
  CLI::Option* focal =
      verb.add_option("--focal", settings.focal_px,
                      "Focal length, pixels [a photograph's own, or .87 of the longer side]")
          ->check(range(50.0, 20000.0));
  CLI::Option* principal =
      verb.add_option("--principal", settings.principal_px,
                      "Where the camera's axis meets the frame: x,y in pixels [the middle]")
          ->delimiter(',')
          ->expected(2)
          ->check(range(-100000.0, 100000.0));
  verb.add_option("--camera", settings.file,
                  "A calibration of OpenCV (YAML, JSON), COLMAP's cameras.txt, or a file of "
                  "the nine numbers of the matrix")
      ->check(CLI::ExistingFile)
      ->excludes(focal)
      ->excludes(principal);
}

TrackCamera::TrackCamera(const CameraSettings& settings) : settings_(settings) {
  if (!settings.file.empty()) calibration_ = read_calibration(settings.file);
}

Intrinsics TrackCamera::of(const InputFrame& frame, const WrittenSequence* sequence) {
  const int width = frame.color.width(), height = frame.color.height();
  origin_ = "sequence";
  if (sequence) return of_sequence(*sequence, width, height);
  origin_ = "calibration";
  if (calibration_) return scaled_to(calibration_->camera, width, height, settings_.file);
  const bool stated = settings_.focal_px > 0;
  origin_ = stated ? "--focal" : frame.focal_px > 0 ? "EXIF" : "guess";
  Intrinsics camera = guess_camera(width, height, stated ? settings_.focal_px : frame.focal_px);
  if (!settings_.principal_px.empty()) {
    camera.cx = settings_.principal_px[0];
    camera.cy = settings_.principal_px[1];
  }
  return camera;
}

}  // namespace graspdb::cli
