// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <memory>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

namespace ameco {
namespace {

struct Threads {
    std::atomic<int> count = 0; ///< set by the window while workers ask
    std::unique_ptr<tbb::global_control> control;
};

Threads& threads() {
    static Threads instance;
    return instance;
}

} // namespace

void set_thread_count(int count) {
    Threads& t = threads();
    t.control.reset();
    t.count = std::max(0, count);
    if (count > 0) {
        t.control = std::make_unique<tbb::global_control>(
            tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
    }
}

int thread_count() {
    const int count = threads().count;
    return count > 0 ? count : tbb::info::default_concurrency();
}

void parallel_for(std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t pieces = (n + grain - 1) / grain;
    const auto run = [&](std::size_t piece) {
        body(piece * grain, std::min(n, (piece + 1) * grain));
    };
    if (pieces <= 1 || thread_count() == 1) {
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            run(piece);
        }
        return;
    }
    // TBB orders the pieces after what came before, and before what comes after them. The two say
    // so once more, for ThreadSanitizer, which cannot see into TBB; they do not order pieces.
    std::atomic<bool> begun{false};
    std::atomic<std::size_t> done{0};
    begun.store(true, std::memory_order_release);
    // TBB's own order leaves several pieces to one thread and begins at both ends; parts of a mesh
    // are few and unequal.
    std::atomic<std::size_t> next{0};
    tbb::parallel_for(
        std::size_t{0}, pieces,
        [&](std::size_t) {
            (void)begun.load(std::memory_order_acquire);
            run(next.fetch_add(1, std::memory_order_relaxed));
            done.fetch_add(1, std::memory_order_release);
        },
        tbb::simple_partitioner());
    (void)done.load(std::memory_order_acquire);
}

} // namespace ameco
