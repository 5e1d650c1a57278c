// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/level_transfers.h"

#include "core/base/stopwatch.h"
#include "core/multigrid/transfer_files.h"

#include <utility>

namespace ameco::cli {
namespace {

/// Passes on nothing but requests to stop: the level's share of the progress is used up already.
class OnlyStops : public Monitor {
public:
    explicit OnlyStops(const Monitor& parent) : parent_(parent) {}
    void message(Severity, std::string_view) override {}
    void progress(double, std::string_view) override {}
    [[nodiscard]] bool stop_requested() const override { return parent_.stop_requested(); }

private:
    const Monitor& parent_;
};

} // namespace

template <int D>
LevelTransfers<D>::LevelTransfers(HierarchyFolder& folder, Monitor& monitor)
    : folder_(folder), monitor_(monitor) {
    const int kept = static_cast<int>(folder.hierarchy().levels.size());
    for (int k = 0; k < kept; ++k) {
        Mesh<D> mesh = read_level_mesh<D>(folder.path(), folder.hierarchy(), k);
        if (k > 0 && !folder.hierarchy().levels[static_cast<std::size_t>(k)].transfer) {
            write(k, mesh, {});
        }
        finer_ = std::move(mesh);
    }
}

template <int D>
void LevelTransfers<D>::add(const Level<D>& level, int number) {
    if (number > 0) {
        write(number, level.mesh, level.parent);
    }
    finer_ = level.mesh;
}

template <int D>
void LevelTransfers<D>::write(int number, const Mesh<D>& coarse,
                              const IdVector<NodeId, NodeId>& parent) {
    const Stopwatch watch;
    OnlyStops monitor(monitor_);
    TransferFiles files =
        write_transfer_files(folder_.path(), number - 1, finer_, coarse, parent, monitor);
    folder_.add_transfer(number, std::move(files), watch.seconds());
}

template class LevelTransfers<2>;
template class LevelTransfers<3>;

} // namespace ameco::cli
