// SPDX-License-Identifier: MIT
// Views a second of one core, for a few grasps of the male hand: whole rows, the two ways to make
// their pictures, and a bare loop of Embree's packets over the same rays, scene and flags, which
// everything is set against. In one run, the four of them taking turns; medians.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "graspdb/core/file.h"
#include "graspdb/generator/posed_scene.h"
#include "packet.h"
#include "plan.h"
#include "rows.h"
#include "scene.h"

namespace graspdb {
namespace {

constexpr int kGrasps[] = {1, 6, 22, 28};
constexpr int kStep = 5;

const Plan& plan() {
  static const Plan plan = make_plan({.hands = {data_directory() / "assets/hands/male.glb"},
                                      .grasps = data_directory() / "grasps",
                                      .only = {std::begin(kGrasps), std::end(kGrasps)}},
                                     0);
  return plan;
}

struct Views {
  RowPose pose;
  std::vector<Camera> cameras;
};

Views make_views(std::size_t grasp) {
  const Shard shard = {.hand = 0, .variant = 0, .grasp = grasp};
  RowPose pose = pose_rows(plan(), shard, sized_grasp(plan(), shard), kStep);
  std::vector<Camera> cameras;
  for (std::size_t view = 0; view < plan().views.size(); ++view) {
    cameras.push_back(row_camera(plan(), pose.scene, view));
  }
  return {std::move(pose), std::move(cameras)};
}

std::size_t grasp_of(const benchmark::State& state) {
  const auto found = std::ranges::find(kGrasps, state.range(0));
  return static_cast<std::size_t>(found - std::begin(kGrasps));
}

const Views& views_of(std::size_t grasp) {
  static std::map<std::size_t, Views> made;
  const auto found = made.find(grasp);
  return found != made.end() ? found->second : made.emplace(grasp, make_views(grasp)).first->second;
}

int bare_view(RTCScene scene, const Camera& camera) {
  RTCIntersectContext context = embree::coherent_context();
  const PixelRays rays(camera);
  alignas(64) RTCRayHit16 packet;
  alignas(64) std::array<int, PixelRays::kLanes> valid;
  valid.fill(-1);
  int hits = 0;
  for (int y = 0; y < camera.intrinsics.height; y += PixelRays::kTile) {
    for (int x = 0; x < camera.intrinsics.width; x += PixelRays::kTile) {
      rays.aim(x, y, embree::kEverything, packet.ray);
      std::fill_n(packet.hit.geomID, PixelRays::kLanes, RTC_INVALID_GEOMETRY_ID);
      rtcIntersect16(valid.data(), scene, &context, &packet);
      for (const unsigned id : packet.hit.geomID) hits += id != RTC_INVALID_GEOMETRY_ID;
    }
  }
  return hits;
}

// Calls body(scene, camera) for all views of a grasp, as one iteration.
template <typename Body>
void measure(benchmark::State& state, const Body& body) {
  const Views& views = views_of(grasp_of(state));
  const embree::FlushDenormals flush;
  for (auto _ : state) {
    for (const Camera& camera : views.cameras)
      benchmark::DoNotOptimize(body(views.pose.scene.scene, camera));
  }
}

void bare(benchmark::State& state) {
  measure(state, [](const Scene& scene, const Camera& camera) {
    return bare_view(scene.state().embree.get(), camera);
  });
}

void embree_views(benchmark::State& state) {
  measure(state, [](const Scene& scene, const Camera& camera) {
    return render(scene, camera).shading.at(0, 0);
  });
}

void raster_views(benchmark::State& state) {
  measure(state, [](const Scene& scene, const Camera& camera) {
    return rasterize(scene, camera).shading.at(0, 0);
  });
}

void row(benchmark::State& state) {
  const Shard shard = {.hand = 0, .variant = 0, .grasp = grasp_of(state)};
  const SizedGrasp grasp = sized_grasp(plan(), shard);
  std::vector<Row> rows(plan().views.size());
  for (auto _ : state) make_rows(plan(), shard, grasp, kStep, rows);
}

// One line a grasp and thing measured, instead of nine.
class Medians : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.aggregate_name != "median") continue;
      milliseconds_[run.run_name.args][run.run_name.function_name] = run.GetAdjustedCPUTime();
    }
  }

  void Finalize() override {
    for (const auto& [grasp, milliseconds] : milliseconds_) {
      for (const auto& [name, taken] : milliseconds) {
        const double views_a_second = 1000 / taken * static_cast<double>(plan().views.size());
        fmt::print("{:9} {:7} {:6.0f} views/s", grasp, name, views_a_second);
        const auto bare = milliseconds.find("bare");
        if (bare != milliseconds.end())
          fmt::print(", {:.2f} times the bare loop's time", taken / bare->second);
        fmt::print("\n");
      }
    }
  }

 private:
  std::map<std::string, std::map<std::string, double>> milliseconds_;
};

void add(const char* name, void (*body)(benchmark::State&)) {
  for (const int grasp : kGrasps) {
    benchmark::RegisterBenchmark(name, body)
        ->ArgName("grasp")
        ->Arg(grasp)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1)
        ->Repetitions(9)
        ->ReportAggregatesOnly();
  }
}

void run() {
  add("bare", bare);
  add("embree", embree_views);
  add("raster", raster_views);
  add("row", row);
  Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
}

}  // namespace
}  // namespace graspdb

int main(int argc, char** argv) {
  std::string interleaved = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + 1, interleaved.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;
  graspdb::run();
}
