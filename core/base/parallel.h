// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Loops whose result is the same on 1 and on 64 threads.
#pragma once

#include <cstddef>
#include <functional>

namespace ameco {

/// Number of threads that parallel loops may use; 0 means all of the machine's. Applies to the
/// whole process until set again.
void set_thread_count(int threads);
[[nodiscard]] int thread_count();

/// Calls `body(begin, end)` for consecutive pieces of [0, n). Pieces have `grain` items (the last
/// one fewer) whatever the number of threads, so a body that writes only to its own items, or to a
/// slot of its piece (begin / grain), gives the same result on any number of threads. Pieces begin
/// in order, each as soon as a thread is free: where they are unequal, the largest should be first.
void parallel_for(std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

} // namespace ameco
