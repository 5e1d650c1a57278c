// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/model/document.h"

#include "core/base/text.h"
#include "core/hierarchy/settings.h"
#include "core/io/io.h"
#include "gui/model/case_work.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace ameco::gui {
namespace {

QString name_of(const QString& path) {
    const QFileInfo info(path);
    return info.fileName().isEmpty() ? info.dir().dirName() : info.fileName();
}

/// Carries a result, which is not copied, from a worker into a posted action.
template <class T>
std::shared_ptr<T> parcel(T value) {
    return std::make_shared<T>(std::move(value));
}

/// Up: to the finer levels, by the parents of the nodes. Down: nodes keep their order, so the
/// parents ascend.
std::optional<NodeId> step_down(const AnyLevel& level, NodeId fine) {
    return std::visit(
        [&](const auto& l) -> std::optional<NodeId> {
            const auto& parents = l.parent.raw();
            const auto found = std::lower_bound(parents.begin(), parents.end(), fine);
            if (found == parents.end() || *found != fine) {
                return std::nullopt;
            }
            return NodeId(static_cast<std::size_t>(found - parents.begin()));
        },
        level);
}

NodeId step_up(const AnyLevel& level, NodeId node) {
    return std::visit([&](const auto& l) { return l.parent[node]; }, level);
}

} // namespace

Document::Document(JobRunner& jobs, QObject* parent) : QObject(parent), jobs_(jobs) {}

const CaseLevel* Document::level(int id) const {
    const auto found = std::find_if(levels_.begin(), levels_.end(),
                                    [id](const CaseLevel& level) { return level.id == id; });
    return found != levels_.end() ? &*found : nullptr;
}

Branch Document::branch(int id) const {
    Branch levels;
    for (const CaseLevel* l = level(id); l != nullptr; l = level(l->parent)) {
        levels.insert(levels.begin(), l);
    }
    return levels;
}

Branch Document::currentBranch() const {
    Branch levels = branch(current_);
    while (!levels.empty()) {
        const std::vector<int> next = successors(levels.back()->id);
        if (next.empty()) {
            break;
        }
        levels.push_back(level(next.back()));
    }
    return levels;
}

std::vector<int> Document::successors(int id) const {
    std::vector<int> ids;
    for (const CaseLevel& l : levels_) {
        if (l.parent == id) {
            ids.push_back(l.id);
        }
    }
    return ids;
}

std::optional<NodeId> Document::sameNode(int from, NodeId node, int to) const {
    const Branch target = branch(to);
    const CaseLevel* at = level(from);
    const auto is_on_the_way = [&] {
        return std::find(target.begin(), target.end(), at) != target.end();
    };
    while (at != nullptr && !is_on_the_way()) {
        node = step_up(*at->level, node);
        at = level(at->parent);
    }
    if (at == nullptr) {
        return std::nullopt;
    }
    std::optional<NodeId> place = node;
    for (auto next = std::find(target.begin(), target.end(), at) + 1; next != target.end() && place;
         ++next) {
        place = step_down(*(*next)->level, *place);
    }
    return place;
}

QString Document::commandLine(int id, int threads) const {
    const Branch levels = branch(id);
    if (levels.empty()) {
        return tr("# open a mesh first");
    }
    if (levels.size() == 1) {
        return tr("ameco info %1").arg(QString::fromStdString(shell_word(file_.path)));
    }
    HierarchyOptions options = levels.back()->options;
    std::vector<double> factors;
    for (std::size_t k = 1; k < levels.size(); ++k) {
        const std::string names = different_for_a_level(levels[k]->options, levels[1]->options);
        if (!names.empty()) {
            return tr("# no single command makes this branch: level %1 has other settings than "
                      "level 1 (%2)")
                .arg(k)
                .arg(QString::fromStdString(names));
        }
        factors.push_back(levels[k]->options.coarsen.target.factor);
    }
    options.levels = static_cast<int>(factors.size());
    std::string text = "ameco coarsen " + shell_word(file_.path) + " -o levels";
    for (const std::string& word : coarsen_arguments(options, factors)) {
        text += ' ' + shell_word(word);
    }
    if (threads > 0) {
        text += " --threads " + std::to_string(threads);
    }
    return QString::fromStdString(text);
}

std::map<int, std::string> Document::patches() const {
    std::map<int, std::string> names;
    if (isOpen() && levels_.front().scene) {
        const SceneData& scene = *levels_.front().scene;
        for (const int patch : scene.patches) {
            names[patch] = scene.patch_name(patch);
        }
    }
    return names;
}

void Document::open(const QString& path) {
    jobs_.start(tr("Opening %1").arg(name_of(path)), [this, path](JobContext& job) {
        const std::filesystem::path file = path.toStdString();
        std::error_code unreadable; // then reading the file tells why
        const bool hierarchy =
            std::filesystem::is_directory(file, unreadable) || file.filename() == "hierarchy.json";
        const auto sketch = [this, &job](std::shared_ptr<const SceneData> scene) {
            job.post([this, scene = std::move(scene)] { emit sketched(scene); });
        };
        const auto loaded =
            parcel(hierarchy ? read_hierarchy_case(file, job) : read_case(file, sketch, job));
        job.post([this, loaded] { take(std::move(loaded->file), std::move(loaded->levels)); });
    });
}

void Document::openStored(const QString& mesh, const std::vector<StoredLevel>& stored) {
    jobs_.start(tr("Opening %1").arg(name_of(mesh)), [this, mesh, stored](JobContext& job) {
        const auto loaded = parcel(read_stored_case(mesh.toStdString(), stored, job));
        job.post([this, loaded] { take(std::move(loaded->file), std::move(loaded->levels)); });
    });
}

void Document::take(CaseFile file, std::vector<CaseLevel> levels) {
    file_ = std::move(file);
    levels_ = std::move(levels);
    next_id_ = 0;
    for (const CaseLevel& l : levels_) {
        next_id_ = std::max(next_id_, l.id + 1);
    }
    current_ = levels_.front().id;
    emit opened();
    emit currentChanged(current_);
}

void Document::close() {
    jobs_.cancel();
    levels_.clear();
    file_ = {};
    current_ = -1;
    emit closed();
    emit currentChanged(current_);
}

void Document::add(CaseLevel level) {
    level.id = next_id_++;
    levels_.push_back(std::move(level));
    emit levelAdded(levels_.back().id);
    setCurrent(levels_.back().id);
}

void Document::coarsen(int from, const HierarchyOptions& options) {
    const CaseLevel* const start = level(from);
    if (start == nullptr || start->statistics.elements == 0) {
        return;
    }
    HierarchyOptions wanted = options;
    wanted.levels += start->number; // the core counts from the finest level
    jobs_.start(tr("Coarsening"), [this, start = *start, wanted,
                                   max = levels_.front().statistics.classes.max](JobContext& job) {
        // Each level is made from the one before it.
        const auto last = parcel(start.id);
        const auto sink = [this, &job, last](CaseLevel finished) {
            const auto made = parcel(std::move(finished));
            job.post([this, made, last] {
                if (level(*last) == nullptr) {
                    return; // deleted meanwhile
                }
                made->parent = *last;
                *last = next_id_;
                add(std::move(*made));
            });
        };
        const auto end = parcel(make_case_levels(start, max, wanted, sink, job));
        job.post([this, end, last] { finishCoarsening(*end, *last); });
    });
}

void Document::finishCoarsening(const HierarchyEnd& end, int last) {
    if (end.refused && level(last) != nullptr) {
        const QString text =
            tr("level %1 would have kept %2 of %3 nodes: the mesh cannot be coarsened further")
                .arg(level(last)->number + 1)
                .arg(QString::fromStdString(count_text(end.refused->nodes_after)),
                     QString::fromStdString(count_text(end.refused->nodes_before)));
        emit jobs_.said(Severity::warning, text);
    }
}

void Document::remove(int id) {
    const CaseLevel* const doomed = level(id);
    if (doomed == nullptr || doomed->parent < 0) {
        return;
    }
    const int parent = doomed->parent;
    std::set<int> gone{id};
    for (const CaseLevel& l : levels_) { // parents come first
        if (gone.count(l.parent) > 0) {
            gone.insert(l.id);
        }
    }
    if (gone.count(current_) > 0) {
        setCurrent(parent);
    }
    std::erase_if(levels_, [&](const CaseLevel& l) { return gone.count(l.id) > 0; });
    for (const int each : gone) {
        emit levelRemoved(each);
    }
}

void Document::setCurrent(int id) {
    if (id != current_ && level(id) != nullptr) {
        current_ = id;
        emit currentChanged(id);
    }
}

void Document::prepareRemovedAt() {
    if (jobs_.isRunning()) {
        return; // asked again when the job has ended
    }
    std::vector<CaseLevel> levels;
    for (const CaseLevel* l : currentBranch()) {
        levels.push_back(*l);
    }
    jobs_.start(tr("Finding where nodes disappear"), [this, levels](JobContext& job) {
        for (std::size_t k = 0; k < levels.size(); ++k) {
            job.progress(static_cast<double>(k) / static_cast<double>(levels.size()),
                         "level " + std::to_string(k));
            auto scene = with_removed_at(levels[k], removal_levels_of(levels, k));
            job.post([this, id = levels[k].id, scene] {
                for (CaseLevel& l : levels_) {
                    if (l.id == id) {
                        l.scene = scene;
                        emit levelChanged(id);
                    }
                }
            });
        }
    });
}

void Document::exportBranch(int id, const QString& folder) {
    std::vector<CaseLevel> levels;
    for (const CaseLevel* l : branch(id)) {
        levels.push_back(*l);
    }
    if (levels.empty()) {
        return;
    }
    jobs_.start(tr("Writing levels"), [this, levels, folder, file = file_](JobContext& job) {
        write_branch(file, levels, folder.toStdString(), job);
        job.post([this, folder] { emit exported(folder); });
    });
}

void Document::exportMesh(int id, const QString& path) {
    const CaseLevel* const wanted = level(id);
    if (wanted == nullptr) {
        return;
    }
    jobs_.start(
        tr("Writing %1").arg(name_of(path)), [this, path, data = wanted->level](JobContext& job) {
            const auto lost = std::visit(
                [&](const auto& l) { return write_mesh(path.toStdString(), l.mesh); }, *data);
            for (const std::string& line : lost) {
                job.message(Severity::warning, line);
            }
            job.post([this, path] { emit exported(path); });
        });
}

} // namespace ameco::gui
