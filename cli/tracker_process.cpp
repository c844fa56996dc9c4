// SPDX-License-Identifier: MIT
#include "tracker_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <ctime>
#include <optional>
#include <sstream>
#include <type_traits>

#include "console.h"
#include "frame_source.h"
#include "graspdb/error.h"
#include "graspdb/file.h"
#include "graspdb/segmentation.h"
#include "graspdb/stopwatch.h"
#include "tracker_options.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

constexpr const char* kVerb = "tracker-process";
constexpr const char* kProcess = "the process of the tracker";

// Bytes over a socket. Whoever has gone is noticed by an Error, not by a signal.
void send_bytes(int socket, const void* bytes, std::size_t count) {
  const auto* at = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = ::send(socket, at, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) throw Error({.file = kProcess, .expected = "a reader", .found = "none"});
    at += sent;
    count -= static_cast<std::size_t>(sent);
  }
}

void receive_bytes(int socket, void* bytes, std::size_t count) {
  auto* at = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t received = ::recv(socket, at, count, 0);
    if (received < 0 && errno == EINTR) continue;
    if (received <= 0) throw Error({.file = kProcess, .expected = "an answer", .found = "its end"});
    at += received;
    count -= static_cast<std::size_t>(received);
  }
}

template <typename Value>
void send_value(int socket, const Value& value) {
  static_assert(std::is_trivially_copyable_v<Value>);
  send_bytes(socket, &value, sizeof value);
}

template <typename Value>
Value receive_value(int socket) {
  static_assert(std::is_trivially_copyable_v<Value>);
  Value value;
  receive_bytes(socket, &value, sizeof value);
  return value;
}

// An answer goes after the length of a fault's text: 0 when there is none.
template <typename Answer>
void send_answer(int socket, const Answer& answer) {
  send_value(socket, std::uint32_t{0});
  send_value(socket, answer);
}

void send_fault(int socket, const std::string& text) {
  send_value(socket, static_cast<std::uint32_t>(text.size()));
  send_bytes(socket, text.data(), text.size());
}

// A frame goes after its width and height; one without pixels is none.
using FrameSize = std::array<std::int32_t, 2>;

void send_frame(int socket, const ColorImage& frame) {
  send_value(socket, FrameSize{frame.width(), frame.height()});
  send_bytes(socket, frame.data(), frame.size() * sizeof(Bgr));
}

std::optional<ColorImage> receive_frame(int socket) {
  const auto [width, height] = receive_value<FrameSize>(socket);
  if (width == 0) return std::nullopt;
  ColorImage frame(width, height);
  receive_bytes(socket, frame.data(), frame.size() * sizeof(Bgr));
  return frame;
}

double processor_ms() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

// As the kernel tells it, in lines like "VmHWM:   123 kB".
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

StepTimes timed_step(Tracker& tracker, const ColorImage& frame) {
  const double processor_before = processor_ms();
  const Stopwatch watch;
  const GrayImage gray = to_gray(frame);
  const Mask hand = find_hand(frame);
  const double segment = watch.ms();
  const Estimate estimate = tracker.step({gray, hand, guess_camera(frame)});
  const double total = watch.ms();
  const StageTimes& ms = estimate.ms;
  return {segment,       ms.describe, ms.search,
          ms.temporal,   total,       processor_ms() - processor_before,
          estimate.valid};
}

void serve(int socket, const std::string& file, const std::string& method) {
  Opening opening{.before = resident_memory(), .tracker = TrackerSettings{}.options()};
  const Stopwatch watch;
  const Database database = Database::open(file);
  opening.database_ms = watch.ms();
  const auto search = open_search(database, method);
  opening.search_ms = watch.ms() - opening.database_ms;
  Tracker tracker(database, *search, opening.tracker);
  send_answer(socket, opening);  // after all that may fail: a fault can only be an answer
  while (const auto frame = receive_frame(socket)) send_answer(socket, timed_step(tracker, *frame));
  send_answer(socket, resident_memory());
}

void serve_to_the_end(int socket, const std::string& file, const std::string& method) {
  try {
    serve(socket, file, method);
  } catch (const std::exception& fault) {
    send_fault(socket, fault.what());
  }
}

}  // namespace

TrackerProcess::TrackerProcess(const std::string& database, const std::string& search) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw Error({.file = kProcess, .expected = "a socket", .found = "none left"});
  const std::string socket = std::to_string(ends[1]);
  child_ = ::fork();
  if (child_ == 0) {
    ::fcntl(ends[1], F_SETFD, 0);
    ::execl("/proc/self/exe", "graspdb", kVerb, database.c_str(), search.c_str(), socket.c_str(),
            nullptr);
    ::_exit(127);
  }
  ::close(ends[1]);
  socket_ = ends[0];
  if (child_ > 0) return;
  ::close(socket_);
  throw Error({.file = kProcess, .expected = "to be forked", .found = "no place for it"});
}

TrackerProcess::~TrackerProcess() {
  ::close(socket_);
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

template <typename Answer>
Answer TrackerProcess::receive() {
  const auto length = receive_value<std::uint32_t>(socket_);
  if (length == 0) return receive_value<Answer>(socket_);
  std::string fault(length, ' ');
  receive_bytes(socket_, fault.data(), fault.size());
  throw Error(fault);
}

Opening TrackerProcess::open() {
  return receive<Opening>();
}

StepTimes TrackerProcess::step(const ColorImage& frame) {
  GRASPDB_CHECK(!frame.empty());
  send_frame(socket_, frame);
  return receive<StepTimes>();
}

ResidentMemory TrackerProcess::finish() {
  send_frame(socket_, {});
  return receive<ResidentMemory>();
}

void add_tracker_process(CLI::App& app) {
  struct Options {
    std::string database, search;
    int socket = -1;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand(kVerb, "The other end of `bench`");
  verb->group("");  // of no use to people
  verb->add_option("DB", options->database, "The database")->required();
  verb->add_option("SEARCH", options->search, "How neighbours are found")
      ->required()
      ->check(CLI::IsMember(search_names()));
  verb->add_option("SOCKET", options->socket, "The number of an open socket")->required();
  verb->callback(
      [options] { serve_to_the_end(options->socket, options->database, options->search); });
}

}  // namespace graspdb::cli
