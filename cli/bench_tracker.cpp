// SPDX-License-Identifier: MIT
#include "bench_tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "console.h"
#include "frame_source.h"
#include "graspdb/error.h"
#include "graspdb/file.h"
#include "graspdb/metrics.h"
#include "graspdb/parallel.h"
#include "graspdb/sequence.h"
#include "tracker_options.h"

namespace graspdb::cli {
namespace {

using nlohmann::json;

constexpr const char* kRendered = "sequences/train/soap.seq.toml";

// Starting a video gives what gives its frames, one after another, and none at the end.
using Frames = std::function<std::optional<ColorImage>()>;
using Video = std::function<Frames()>;

Video recorded(const std::string& input) {
  return [input]() -> Frames {
    return [source = std::shared_ptr(open_source(input, {}))]() -> std::optional<ColorImage> {
      auto frame = source->next();
      return frame ? std::optional(std::move(frame->color)) : std::nullopt;
    };
  };
}

std::vector<ColorImage> render_sequence(const SequenceRenderer& sequence, int most) {
  std::vector<ColorImage> frames(
      static_cast<std::size_t>(std::min(most, sequence.spec().frame_count())));
  const Progress progress = console_progress("rendered", "frames");
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(frames.size(), 0, [&](std::size_t i) {
    frames[i] = sequence.render(static_cast<int>(i)).color;
    const std::scoped_lock lock(mutex);
    progress(++done, frames.size());
  });
  return frames;
}

Video rendered(int most) {
  const SequenceRenderer sequence(load_sequence(data_directory() / kRendered));
  const auto frames =
      std::make_shared<const std::vector<ColorImage>>(render_sequence(sequence, most));
  return [frames]() -> Frames {
    return [frames, next = std::size_t{0}]() mutable {
      return next < frames->size() ? std::optional((*frames)[next++]) : std::nullopt;
    };
  };
}

std::vector<StepTimes> show_once(TrackerProcess& tracker, const Video& video, std::size_t most) {
  std::vector<StepTimes> times;
  const Frames next = video();
  while (times.size() < most) {
    const auto frame = next();
    if (!frame) break;
    times.push_back(tracker.step(*frame));
  }
  return times;
}

Percentiles percentiles_of(const std::vector<StepTimes>& times, double StepTimes::*stage) {
  std::vector<double> ms;
  for (const StepTimes& step : times) ms.push_back(step.*stage);
  std::sort(ms.begin(), ms.end());
  return {percentile(ms, 50), percentile(ms, 95), percentile(ms, 99)};
}

TrackerFigures measure(const std::string& database, const std::string& search, const Video& video,
                       std::size_t count) {
  TrackerProcess tracker(database, search);
  TrackerFigures figures{.search = search, .opening = tracker.open()};
  show_once(tracker, video, count);  // the warm-up
  std::vector<StepTimes> times;
  while (times.size() < count) {
    const auto more = show_once(tracker, video, count - times.size());
    if (more.empty()) throw Error("a video that gave frames gives none when it is shown again");
    times.insert(times.end(), more.begin(), more.end());
  }
  for (std::size_t i = 0; i < kStages.size(); ++i)
    figures.ms[i] = percentiles_of(times, kStages[i].ms);
  for (const StepTimes& step : times) figures.valid += step.valid ? 1 : 0;
  figures.valid /= static_cast<double>(count);
  figures.memory = tracker.finish();
  return figures;
}

// What the design asks for: at most `must`, better `aim`.
struct Limit {
  const char* what;
  double measured, must, aim;
};

double megabytes(double bytes) {
  return bytes / 1e6;
}

std::vector<Limit> limits(const TrackerBench& bench, const TrackerFigures& figures) {
  std::vector<Limit> all = {{"open the database, ms", figures.opening.database_ms, 20, 2},
                            {"peak memory, MB", megabytes(figures.memory.peak), 400, 120}};
  if (bench.width == 640 && bench.height == 480) {  // what the limits are for
    const Percentiles& total = figures.ms[kTotal];
    all.push_back({"a frame, p50, ms", total.p50, 4, 1});
    all.push_back({"a frame, p99, ms", total.p99, 4, 1});
  }
  return all;
}

void print(const TrackerFigures& figures) {
  fmt::print("\n{:20} {:>8} {:>8} {:>8}\n", figures.search + ", ms a frame", "p50", "p95", "p99");
  for (std::size_t i = 0; i < kStages.size(); ++i) {
    const Percentiles& ms = figures.ms[i];
    fmt::print("  {:18} {:8.3f} {:8.3f} {:8.3f}\n", kStages[i].name, ms.p50, ms.p95, ms.p99);
  }
  const ResidentMemory& memory = figures.memory;
  const Opening& opening = figures.opening;
  fmt::print("  hand read in {:.0f} % of the frames, temporal model {}, {} neighbours\n",
             100 * figures.valid, temporal_name(opening.tracker.temporal),
             opening.tracker.neighbours);
  fmt::print("  opening: database {:.2f} ms, search {:.0f} ms\n", opening.database_ms,
             opening.search_ms);
  fmt::print("  resident: {:.0f} MB at most, {:.0f} MB before anything was opened\n",
             megabytes(memory.peak), megabytes(opening.before.peak));
  fmt::print("            in the end {:.0f} MB of its own, {:.0f} MB of mapped files\n",
             megabytes(memory.own), megabytes(memory.files));
}

void print(const std::string& search, const Limit& limit) {
  const auto verdict = [&limit](double most) {
    return fmt::format("{} {}", most, limit.measured <= most ? "met" : "missed");
  };
  fmt::print("{:32} {:>9.2f} {:>11} {:>11}\n", search + ": " + limit.what, limit.measured,
             verdict(limit.must), verdict(limit.aim));
}

json to_json(const Limit& limit) {
  return {{"what", limit.what},
          {"measured", limit.measured},
          {"must", limit.must},
          {"aim", limit.aim},
          {"meets_must", limit.measured <= limit.must},
          {"meets_aim", limit.measured <= limit.aim}};
}

json to_json(const TrackerBench& bench, const TrackerFigures& figures) {
  json line = {{"search", figures.search},
               {"temporal", temporal_name(figures.opening.tracker.temporal)},
               {"options", options_json(figures.opening.tracker)},
               {"open_database_ms", figures.opening.database_ms},
               {"open_search_ms", figures.opening.search_ms},
               {"valid", figures.valid},
               {"program_mb", megabytes(figures.opening.before.peak)},
               {"peak_mb", megabytes(figures.memory.peak)},
               {"own_mb", megabytes(figures.memory.own)},
               {"files_mb", megabytes(figures.memory.files)},
               {"limits", json::array()}};
  for (std::size_t i = 0; i < kStages.size(); ++i) {
    const Percentiles& ms = figures.ms[i];
    line["ms"][kStages[i].name] = {{"p50", ms.p50}, {"p95", ms.p95}, {"p99", ms.p99}};
  }
  for (const Limit& limit : limits(bench, figures)) line["limits"].push_back(to_json(limit));
  return line;
}

double load_average() {
  double load = 0;
  return ::getloadavg(&load, 1) == 1 ? load : 0;
}

}  // namespace

TrackerBench bench_tracker(const Database& database, const std::string& video, int frames) {
  const Video source = video.empty() ? rendered(frames) : recorded(video);
  const auto first = source()();
  if (!first) throw Error({.file = video, .expected = "frames", .found = "none that can be read"});
  TrackerBench bench{.video = video.empty() ? kRendered : video,
                     .width = first->width(),
                     .height = first->height(),
                     .frames = frames,
                     .load = load_average()};
  for (const std::string& search : search_names()) {
    // Without an index one would be built first, whose memory is not the tracker's.
    if (search == "lsh" && !std::filesystem::exists(index_file(database, search))) continue;
    bench.trackers.push_back(
        measure(database.path(), search, source, static_cast<std::size_t>(frames)));
  }
  return bench;
}

void print(const TrackerBench& bench) {
  fmt::print("\ntracker: {}, {} x {}; {} frames timed after a warm-up; one thread\n", bench.video,
             bench.width, bench.height, bench.frames);
  fmt::print("load of the machine {:.2f} on {} processors\n", bench.load,
             std::thread::hardware_concurrency());
  for (const TrackerFigures& figures : bench.trackers) print(figures);
  fmt::print("\n{:32} {:>9} {:>11} {:>11}\n", "held against the design", "measured", "must", "aim");
  for (const TrackerFigures& figures : bench.trackers) {
    for (const Limit& limit : limits(bench, figures)) print(figures.search, limit);
  }
}

json to_json(const TrackerBench& bench) {
  json trackers = json::array();
  for (const TrackerFigures& figures : bench.trackers) trackers.push_back(to_json(bench, figures));
  return {{"video", bench.video},   {"width_px", bench.width}, {"height_px", bench.height},
          {"frames", bench.frames}, {"load", bench.load},      {"trackers", trackers}};
}

}  // namespace graspdb::cli
