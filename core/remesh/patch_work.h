// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Work on the patches of a mesh side by side, then on what lies between them.
#pragma once

#include "core/base/monitor.h"
#include "core/base/parallel.h"
#include "core/remesh/partition.h"
#include "core/remesh/verdict.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <string_view>
#include <thread>

namespace ameco {

/// Progress of threads that share a piece of work: reported by the one that called, asked for stops
/// by all.
class SharedProgress {
public:
    SharedProgress(Monitor& monitor, std::size_t items, std::string_view step)
        : monitor_(monitor), items_(items), step_(step) {}

    /// \return  whether a stop was requested
    bool add(std::size_t done) {
        const std::size_t all = done_ += done;
        if (std::this_thread::get_id() == caller_) {
            monitor_.progress(static_cast<double>(all) /
                                  static_cast<double>(std::max<std::size_t>(items_, 1)),
                              step_);
        }
        return monitor_.stop_requested();
    }

private:
    Monitor& monitor_;
    std::size_t items_;
    std::string_view step_;
    std::thread::id caller_ = std::this_thread::get_id();
    std::atomic<std::size_t> done_ = 0;
};

/// Hands items to a worker, in order, until asked to stop.
/// \param positions  of the items; on return, of those that the worker put off
template <class Item, class Worker>
void work_through(const std::vector<Item>& items, std::vector<std::uint32_t>& positions,
                  Worker&& worker, SharedProgress& progress) {
    constexpr std::size_t between_reports = 4096;
    std::size_t put_off = 0, reported = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (i % between_reports == 0) {
            const std::size_t finished = i - put_off;
            if (progress.add(finished - reported)) {
                break;
            }
            reported = finished;
        }
        if (!worker(items[positions[i]])) {
            positions[put_off++] = positions[i];
        }
    }
    positions.resize(put_off);
}

/// So that threads end at about the same time.
inline std::vector<std::size_t>
largest_first(const std::vector<std::vector<std::uint32_t>>& lists) {
    std::vector<std::size_t> order(lists.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return lists[a].size() > lists[b].size();
    });
    return order;
}

/// Goes through items in order, part by part: first on the patches of each partition in turn, many
/// at a time, then on the whole mesh with what no patch held. Ends early when asked to stop.
///
/// The result depends on the items and the partitions, not on the number of threads: items of a
/// part are worked on in their order by one worker, which sees and changes nothing that others
/// change. The work says what that means:
///
///     void open(std::size_t lanes);                    // so many workers come next
///     int part_of(const Partition&, Item);             // -1: not in one part
///     Worker worker(const Patch&, VerdictCounts&);
///     bool Worker::operator()(Item);                   // false: not within the patch, put it off
template <class Item, class Work>
void work_in_patches(const std::vector<Item>& items, std::span<const Partition> partitions,
                     Work& work, VerdictCounts& verdicts, std::string_view step, Monitor& monitor) {
    SharedProgress progress(monitor, items.size(), step);
    std::vector<std::uint32_t> rest(items.size());
    std::iota(rest.begin(), rest.end(), 0U);
    for (const Partition& partition : partitions) {
        std::vector<std::vector<std::uint32_t>> lists(partition.parts);
        std::vector<VerdictCounts> counts(partition.parts);
        std::vector<std::uint32_t> between;
        for (const std::uint32_t i : rest) {
            const int part = work.part_of(partition, items[i]);
            (part < 0 ? between : lists[static_cast<std::size_t>(part)]).push_back(i);
        }
        work.open(partition.parts);
        const std::vector<std::size_t> order = largest_first(lists);
        parallel_for(partition.parts, 1, [&](std::size_t i, std::size_t) {
            const std::size_t part = order[i];
            VerdictCounts own;
            work_through(items, lists[part], work.worker(Patch(partition, part), own), progress);
            counts[part] = own;
        });
        rest = std::move(between);
        for (std::size_t part = 0; part < partition.parts; ++part) {
            rest.insert(rest.end(), lists[part].begin(), lists[part].end());
            verdicts.add(counts[part]);
        }
        std::sort(rest.begin(), rest.end());
        if (monitor.stop_requested()) {
            return;
        }
    }
    work.open(1);
    work_through(items, rest, work.worker(Patch(), verdicts), progress);
}

} // namespace ameco
