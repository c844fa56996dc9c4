// SPDX-License-Identifier: MIT
#include "graspdb/bench/tracker_bench.h"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <mutex>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/parallel.h"
#include "graspdb/core/stopwatch.h"
#include "graspdb/evaluation/metrics.h"
#include "graspdb/sequences/sequence.h"
#include "graspdb/tracker/hand_reader.h"
#include "graspdb/video/frame_source.h"

namespace graspdb {
namespace {

constexpr std::size_t kKeptFrames = 256;
constexpr const char* kRendered = "sequences/train/soap.seq.toml";

double processor_ms() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

// From lines like "VmHWM:   123 kB".
ResidentMemory resident_memory() {
  constexpr const char* kStatus = "/proc/self/status";
  const std::string status = read_text(kStatus);
  const auto bytes = [&status](const std::string& key) {
    const auto at = status.find("\n" + key + ":");
    if (at == std::string::npos) throw Error({kStatus, key, "a line of it", "none"});
    return 1024 * std::stod(status.substr(at + key.size() + 2));
  };
  return {bytes("VmHWM"), bytes("RssAnon"), bytes("RssFile") + bytes("RssShmem")};
}

// Gives back what was freed, and lets the peak begin anew from what is resident now.
void begin_memory_anew() {
  ::malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

std::vector<ColorImage> render_frames(std::size_t most, const Progress& progress) {
  const SequenceRenderer sequence(load_sequence(data_directory() / kRendered));
  const auto all = static_cast<std::size_t>(sequence.spec().frame_count());
  std::vector<ColorImage> frames(std::min(most, all));
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(frames.size(), 0, [&](std::size_t i) {
    frames[i] = sequence.render(static_cast<int>(i)).color;
    const std::scoped_lock lock(mutex);
    if (progress) progress(++done, frames.size());
  });
  return frames;
}

std::vector<ColorImage> read_frames(const std::string& video, std::size_t most) {
  const auto source = open_source(video, {});
  std::vector<ColorImage> frames;
  while (frames.size() < most) {
    auto frame = source->next();
    if (!frame) break;
    frames.push_back(std::move(frame->color));
  }
  if (frames.empty())
    throw Error({.file = video, .expected = "frames", .found = "none that can be read"});
  return frames;
}

struct FrameTimes {
  std::array<double, kBenchStages.size()> ms;
  bool valid;
};

FrameTimes timed_read(HandReader& reader, const ColorImage& frame) {
  const double processor_before = processor_ms();
  const Estimate estimate = reader.read(frame, guess_camera(frame.width(), frame.height()));
  const StageTimes& ms = estimate.ms;
  return {{ms.segment, ms.describe, ms.search, ms.temporal, ms.total,
           processor_ms() - processor_before},
          estimate.valid};
}

std::vector<FrameTimes> timed_reads(HandReader& reader, const std::vector<ColorImage>& frames,
                                    std::size_t count) {
  for (const ColorImage& frame : frames) timed_read(reader, frame);  // the warm-up
  std::vector<FrameTimes> times;
  for (std::size_t i = 0; i < count; ++i)
    times.push_back(timed_read(reader, frames[i % frames.size()]));
  return times;
}

Percentiles percentiles_of(const std::vector<FrameTimes>& times, std::size_t stage) {
  std::vector<double> ms;
  for (const FrameTimes& frame : times) ms.push_back(frame.ms[stage]);
  std::sort(ms.begin(), ms.end());
  return {percentile(ms, 50), percentile(ms, 95), percentile(ms, 99)};
}

SearchBench bench_search(const std::filesystem::path& file, const std::string& search,
                         const std::vector<ColorImage>& frames, std::size_t count) {
  begin_memory_anew();
  SearchBench bench{.search = search, .tracker = {}};
  bench.before = resident_memory();
  Stopwatch watch;
  const Database database = Database::open(file);
  bench.open_database_ms = watch.lap_ms();
  bench.tracker = tuned_options(TemporalModel::kKde, descriptor_kind(database));
  HandReader reader(database, {.tracker = bench.tracker}, search);
  bench.open_search_ms = watch.lap_ms();
  const auto times = timed_reads(reader, frames, count);
  bench.after = resident_memory();
  for (std::size_t i = 0; i < kBenchStages.size(); ++i) bench.ms[i] = percentiles_of(times, i);
  for (const FrameTimes& frame : times) bench.valid += frame.valid ? 1 : 0;
  bench.valid /= static_cast<double>(times.size());
  return bench;
}

double load_average() {
  double load = 0;
  return ::getloadavg(&load, 1) == 1 ? load : 0;
}

}  // namespace

TrackerBench bench_tracker(const Database& database, const std::string& video, int frames,
                           const Progress& progress) {
  GRASPDB_CHECK(frames > 0);
  const auto count = static_cast<std::size_t>(frames);
  const std::size_t most = std::min(count, kKeptFrames);
  const auto shown = video.empty() ? render_frames(most, progress) : read_frames(video, most);
  TrackerBench bench{.video = video.empty() ? kRendered : video,
                     .width = shown.front().width(),
                     .height = shown.front().height(),
                     .frames = frames,
                     .load = load_average()};
  for (const std::string& search : search_names())
    bench.searches.push_back(bench_search(database.path(), search, shown, count));
  return bench;
}

}  // namespace graspdb
