// SPDX-License-Identifier: MIT
#include "graspdb/core/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "graspdb/core/error.h"

namespace graspdb {

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  GRASPDB_CHECK(threads >= 0);
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : threads);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, body); });
}

}  // namespace graspdb
