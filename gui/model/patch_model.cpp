// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/model/patch_model.h"

#include "core/base/text.h"
#include "gui/model/document.h"
#include "gui/scene/scene_values.h"

#include <algorithm>

namespace ameco::gui {
namespace {

std::int64_t count_of(const SceneData& scene, int patch) {
    const auto& ids = scene.dimension == 3 ? scene.triangle_patch : scene.line_patch;
    return std::count(ids.begin(), ids.end(), patch);
}

} // namespace

PatchModel::PatchModel(const Document& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
    connect(&document, &Document::opened, this, &PatchModel::rebuild);
    connect(&document, &Document::closed, this, &PatchModel::rebuild);
}

int PatchModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int PatchModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : column_count;
}

QVariant PatchModel::data(const QModelIndex& index, int role) const {
    const Row& row = rows_.at(static_cast<std::size_t>(index.row()));
    const int column = index.column();
    if (role == Qt::CheckStateRole && column == visible) {
        return hidden_.count(row.patch) > 0 ? Qt::Unchecked : Qt::Checked;
    }
    if (role == Qt::CheckStateRole && column == frozen) {
        return frozen_.count(row.patch) > 0 ? Qt::Checked : Qt::Unchecked;
    }
    if (role == Qt::DisplayRole && column == name) {
        return row.name;
    }
    if (role == Qt::DisplayRole && column == faces) {
        return QString::fromStdString(count_text(row.faces));
    }
    if (role == Qt::DecorationRole && column == name) {
        return row.colour;
    }
    if (role == Qt::TextAlignmentRole && column == faces) {
        return int(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole) {
        return tr("Patch number %1").arg(row.patch);
    }
    return {};
}

bool PatchModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::CheckStateRole) {
        return false;
    }
    const int patch = patchOf(index.row());
    const bool checked = value.toInt() == Qt::Checked;
    const auto put = [patch](std::set<int>& set, bool in) {
        in ? static_cast<void>(set.insert(patch)) : static_cast<void>(set.erase(patch));
    };
    if (index.column() == visible) {
        put(hidden_, !checked);
        emit hiddenChanged();
    } else if (index.column() == frozen) {
        put(frozen_, checked);
        emit frozenChanged();
    } else {
        return false;
    }
    emit dataChanged(index, index, {Qt::CheckStateRole});
    return true;
}

Qt::ItemFlags PatchModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
    return index.column() == visible || index.column() == frozen ? usual | Qt::ItemIsUserCheckable
                                                                 : usual;
}

QVariant PatchModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    static const std::array<std::array<const char*, 2>, column_count> headings{
        {{QT_TR_NOOP("Show"), QT_TR_NOOP("Whether the patch is seen")},
         {QT_TR_NOOP("Patch"), QT_TR_NOOP("Name of the patch; select patches to see which nodes "
                                          "they have in the histogram")},
         {QT_TR_NOOP("Faces"), QT_TR_NOOP("Faces on the finest level")},
         {QT_TR_NOOP("Freeze"), QT_TR_NOOP("Coarsening leaves the patch untouched")}}};
    if (section < 0 || section >= column_count) {
        return {};
    }
    const auto& heading = headings.at(static_cast<std::size_t>(section));
    if (role == Qt::TextAlignmentRole) {
        return section == faces ? int(Qt::AlignRight | Qt::AlignVCenter)
                                : int(Qt::AlignLeft | Qt::AlignVCenter);
    }
    return role == Qt::DisplayRole   ? QVariant(tr(heading[0]))
           : role == Qt::ToolTipRole ? QVariant(tr(heading[1]))
                                     : QVariant();
}

int PatchModel::patchOf(int row) const {
    return rows_.at(static_cast<std::size_t>(row)).patch;
}

int PatchModel::rowOf(int patch) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(),
                                    [patch](const Row& row) { return row.patch == patch; });
    return found != rows_.end() ? static_cast<int>(found - rows_.begin()) : -1;
}

std::vector<int> PatchModel::frozenPatches() const {
    return {frozen_.begin(), frozen_.end()};
}

void PatchModel::setHidden(const std::set<int>& patches) {
    if (patches != hidden_) {
        hidden_ = patches;
        tellAll();
        emit hiddenChanged();
    }
}

void PatchModel::setFrozen(const std::vector<int>& patches) {
    const std::set<int> wanted(patches.begin(), patches.end());
    if (wanted != frozen_) {
        frozen_ = wanted;
        tellAll();
        emit frozenChanged();
    }
}

void PatchModel::isolate(const std::set<int>& patches) {
    std::set<int> others;
    for (const Row& row : rows_) {
        if (patches.count(row.patch) == 0) {
            others.insert(row.patch);
        }
    }
    setHidden(others);
}

void PatchModel::rebuild() {
    beginResetModel();
    rows_.clear();
    hidden_.clear();
    frozen_.clear();
    if (document_.isOpen()) {
        const CaseLevel& finest = document_.levels().front();
        for (const auto& [patch, patch_name] : document_.patches()) {
            const Rgb c = patch_colour(*finest.scene, patch);
            rows_.push_back({patch, QString::fromStdString(patch_name), QColor(c[0], c[1], c[2]),
                             count_of(*finest.scene, patch)});
        }
        hidden_ = patches_hidden_at_first(*finest.scene);
        const auto& wanted = finest.options.coarsen.features.frozen_patches;
        frozen_.insert(wanted.begin(), wanted.end());
    }
    endResetModel();
    emit hiddenChanged();
    emit frozenChanged();
}

void PatchModel::tellAll() {
    if (rowCount() > 0) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, column_count - 1),
                         {Qt::CheckStateRole});
    }
}

} // namespace ameco::gui
