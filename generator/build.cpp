// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>

#include "data_card.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/folder.h"
#include "graspdb/core/parallel.h"
#include "graspdb/generator/generator.h"
#include "rows.h"
#include "shards.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kConfigName = "build.json";  // in the work folder, for merge_shards

fs::path work_of(const BuildJob& job) {
  return job.work.empty() ? fs::path(job.out.string() + ".work") : job.work;
}

void heed_stop(const BuildJob& job) {
  if (job.stop && job.stop()) throw Error("interrupted");
}

// A shard that is being made: its rows, and how many of its steps are still to do.
struct Making {
  Shard shard;
  fs::path file;
  std::vector<Row> rows;
  std::once_flag allocated;
  std::atomic<int> steps_left;
};

// Makes unfinished shards, step by step on all threads.
class Maker {
 public:
  Maker(const Plan& plan, const BuildJob& job) : plan_(plan), job_(job), work_(work_of(job)) {
    const std::vector<Shard> shards = plan.shards();
    for (std::size_t i = 0; i < shards.size(); ++i) {
      const bool ours =
          i % static_cast<std::size_t>(job.shards) == static_cast<std::size_t>(job.shard);
      if (ours) add(shards[i]);
    }
  }

  void run() {
    if (job_.progress && done_rows_ > 0) job_.progress(done_rows_, total_rows());
    const auto steps = static_cast<std::size_t>(plan_.config.steps);
    if (plan_.config.jitter.object_size_percent > 0) size_grasps();
    parallel_for(making_.size() * steps, job_.threads, [&](std::size_t i) {
      make_step(*making_[i / steps], static_cast<int>(i % steps) + 1);
    });
  }

  // What to do after a fault.
  std::string advice() const {
    return fmt::format("{} of {} shards are finished in {}: the same command goes on",
                       shard_count_ - unfinished_, shard_count_, work_.string());
  }
  std::size_t total_rows() const { return shard_count_ * plan_.rows_per_shard(); }
  std::size_t rendered_rows() const { return making_.size() * plan_.rows_per_shard(); }

 private:
  void add(const Shard& shard) {
    heed_stop(job_);  // to see whether it is finished it is read whole
    ++shard_count_;
    const fs::path file = shard_file(work_, plan_, shard);
    remove_leftovers(file);
    if (is_finished(file)) {
      done_rows_ += plan_.rows_per_shard();
      return;
    }
    ++unfinished_;
    auto making = std::make_unique<Making>();
    making->shard = shard;
    making->file = file;
    making->steps_left = plan_.config.steps;
    making_.push_back(std::move(making));
  }

  // Ahead of the steps, so that all threads close hands, which can take a second each.
  void size_grasps() {
    parallel_for(making_.size(), job_.threads, [&](std::size_t i) {
      heed_stop(job_);
      sized_.of(making_[i]->shard);
    });
  }

  void make_step(Making& making, int step) {
    heed_stop(job_);
    std::call_once(making.allocated, [&] { making.rows.resize(plan_.rows_per_shard()); });
    const std::size_t views = plan_.views.size();
    const std::size_t first = static_cast<std::size_t>(step - 1) * views;
    make_rows(plan_, making.shard, sized_.of(making.shard), step,
              std::span(making.rows).subspan(first, views), [&] { heed_stop(job_); });
    if (--making.steps_left == 0) finish(making);
    report(views);
  }

  void finish(Making& making) {
    DatabaseInfo info = describe_shard(plan_, making.shard);
    info.config = shard_inputs(plan_, making.shard);
    write_database(making.file, info, making.rows);
    std::vector<Row>().swap(making.rows);  // no more than the shards at work are held
    --unfinished_;
  }

  void report(std::size_t rows) {
    const std::lock_guard lock(mutex_);
    done_rows_ += rows;
    if (job_.progress) job_.progress(done_rows_, total_rows());
  }

  const Plan& plan_;
  const BuildJob& job_;
  const fs::path work_;
  std::vector<std::unique_ptr<Making>> making_;
  SizedGrasps sized_{plan_};
  std::size_t shard_count_ = 0;
  std::atomic<std::size_t> unfinished_ = 0;
  std::size_t done_rows_ = 0;
  std::mutex mutex_;
};

// Joins all shards of the plan, which are finished, into the database.
void merge(const Plan& plan, const BuildJob& job) {
  std::vector<DatabasePart> parts;
  for (const Shard& shard : plan.shards()) {
    parts.push_back({shard_file(work_of(job), plan, shard), static_cast<std::uint8_t>(shard.hand),
                     static_cast<std::uint8_t>(shard.variant)});
  }
  DatabaseInfo info = describe_plan(plan);
  info.data_card = data_card(plan);
  join_databases(job.out, info, parts, [&] { heed_stop(job); });
}

// A place that cannot be written is found before the work, not after it.
void prepare(const Plan& plan, const BuildJob& job) {
  remove_leftovers(job.out);
  FileAside(job.out).write("");
  claim_folder(work_of(job), {"shards of a build", kConfigName, {"*.graspdb"}});
  const fs::path config = work_of(job) / kConfigName;
  remove_leftovers(config);
  write_text(config, config_to_json(plan.config));
}

BuildReport report_of(const BuildJob& job, Clock::time_point begin) {
  const Database database = Database::open(job.out);
  const std::chrono::duration<double> taken = Clock::now() - begin;
  return {.rows = database.rows(),
          .seconds = taken.count(),
          .bytes = fs::file_size(job.out),
          .content_hash = database.content_hash()};
}

}  // namespace

BuildReport build_database(const BuildConfig& config, const BuildJob& job) {
  GRASPDB_CHECK(job.shards >= 1 && job.shard >= 0 && job.shard < job.shards);
  const auto begin = Clock::now();
  const Plan plan = make_plan(config, job.threads);
  prepare(plan, job);
  Maker maker(plan, job);
  try {
    maker.run();
    if (job.shards == 1) merge(plan, job);
  } catch (const Error& error) {
    throw Error(fmt::format("{}; {}", error.what(), maker.advice()));
  }
  BuildReport report;
  if (job.shards == 1) {
    report = report_of(job, begin);
  } else {
    report.rows = maker.total_rows();
    report.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }
  report.rendered_rows = maker.rendered_rows();
  return report;
}

BuildReport merge_shards(const BuildJob& job) {
  const auto begin = Clock::now();
  const Plan plan = make_plan(load_config(work_of(job) / kConfigName), job.threads);
  for (const Shard& shard : plan.shards()) {
    const fs::path file = shard_file(work_of(job), plan, shard);
    if (!is_finished(file)) fail_missing(file);
  }
  merge(plan, job);
  return report_of(job, begin);
}

}  // namespace graspdb
