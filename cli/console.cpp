// SPDX-License-Identifier: MIT
#include "console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

namespace graspdb::cli {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t g_interrupted = 0;

class ProgressPrinter {
 public:
  ProgressPrinter(std::string what, std::string unit)
      : what_(std::move(what)), unit_(std::move(unit)), terminal_(::isatty(STDERR_FILENO) == 1) {}

  void operator()(std::size_t done, std::size_t total) {
    const auto now = Clock::now();
    const std::chrono::duration<double> since_last = now - last_;
    if (done != total && since_last.count() < (terminal_ ? 0.1 : 5.0)) return;
    last_ = now;
    const std::chrono::duration<double> taken = now - begin_;
    print(done, total, static_cast<double>(done) / std::max(taken.count(), 1e-9));
  }

 private:
  void print(std::size_t done, std::size_t total, double rate) const {
    const std::string text = figures(done, total, rate);
    if (!terminal_) {
      fmt::print(stderr, "{}\n", text);
      return;
    }
    constexpr std::size_t kWidth = 30;
    const std::size_t filled = total == 0 ? 0 : kWidth * done / total;
    fmt::print(stderr, "\r[{:#<{}}{: <{}}] {}\033[K{}", "", filled, "", kWidth - filled, text,
               done == total ? "\n" : "");
  }

  std::string figures(std::size_t done, std::size_t total, double rate) const {
    const std::string speed = fmt::format("{:.{}f} {}/s", rate, rate < 10 ? 1 : 0, unit_);
    if (total == 0) return fmt::format("{} {} {}, {}", what_, done, unit_, speed);
    const double left = static_cast<double>(total - done) / std::max(rate, 1e-9);
    return fmt::format("{} {} of {} {}, {}, {:.0f} s left", what_, done, total, unit_, speed, left);
  }

  std::string what_, unit_;
  bool terminal_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
};

}  // namespace

Progress console_progress(const std::string& what, const std::string& unit) {
  return [printer = std::make_shared<ProgressPrinter>(what, unit)](
             std::size_t done, std::size_t total) { (*printer)(done, total); };
}

void stop_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = [](int) { g_interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
}

bool interrupted() {
  return g_interrupted != 0;
}

}  // namespace graspdb::cli
