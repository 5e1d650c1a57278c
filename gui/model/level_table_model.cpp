// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/model/level_table_model.h"

#include "core/base/text.h"
#include "gui/model/document.h"

#include <QFont>
#include <QFontMetrics>
#include <QSize>

#include <algorithm>

namespace ameco::gui {
namespace {

QString text_of(const CaseLevel& level, int column) {
    const LevelStatistics& s = level.statistics;
    const bool coarse = level.number > 0;
    const bool measured = s.elements > 0;
    const auto text = [](const std::string& t) { return QString::fromStdString(t); };
    switch (column) {
    case LevelTableModel::nodes:
        return text(count_text(s.nodes));
    case LevelTableModel::elements:
        return text(count_text(s.elements));
    case LevelTableModel::ratio:
        return coarse ? text(ratio_text(s.ratio)) : QString();
    case LevelTableModel::predicted_ratio:
        return coarse && s.predicted_nodes > 0
                   ? text(ratio_text(s.ratio * static_cast<double>(s.nodes) / s.predicted_nodes))
                   : QString();
    case LevelTableModel::max_aspect_ratio:
        return measured ? text(number_text(s.aspect_ratio.max)) : QString();
    case LevelTableModel::top_5_percent:
        return measured ? text(number_text(s.aspect_ratio.top_5_percent)) : QString();
    case LevelTableModel::isotropic_share:
        return measured ? text(percent_text(s.aspect_ratio.share_isotropic)) : QString();
    case LevelTableModel::worst_quality:
        return measured ? text(number_text(s.conformity.worst_quality, 3)) : QString();
    case LevelTableModel::deviation:
        return coarse ? text(number_text(s.deviation, 3)) : QString();
    case LevelTableModel::seconds:
        return text(number_text(level.timing.total(), 3));
    default:
        return {};
    }
}

struct Heading {
    const char* title;
    const char* explanation;
};

constexpr std::array<Heading, LevelTableModel::column_count> headings{{
    {QT_TR_NOOP("Level"), QT_TR_NOOP("0 is the finest; what is indented was made from the same "
                                     "level with other settings")},
    {QT_TR_NOOP("Nodes"), QT_TR_NOOP("Nodes of the level")},
    {QT_TR_NOOP("Elements"), QT_TR_NOOP("Tetrahedra, or triangles in 2-D")},
    {QT_TR_NOOP("Ratio"), QT_TR_NOOP("Nodes of the finer level over nodes of this one")},
    {QT_TR_NOOP("Asked"), QT_TR_NOOP("The ratio that the metric asks for")},
    {QT_TR_NOOP("Max AR"), QT_TR_NOOP("Largest aspect ratio of a node")},
    {QT_TR_NOOP("Top 5 %"), QT_TR_NOOP("5 % of the nodes have a larger aspect ratio")},
    {QT_TR_NOOP("AR < 5"), QT_TR_NOOP("Share of the nodes with an aspect ratio below 5: "
                                      "isotropic ones")},
    {QT_TR_NOOP("Worst Q"), QT_TR_NOOP("Worst quality of an element in the metric asked for")},
    {QT_TR_NOOP("Boundary"), QT_TR_NOOP("Largest distance of the boundary to the finest one")},
    {QT_TR_NOOP("Seconds"), QT_TR_NOOP("What making the level took")},
}};

} // namespace

LevelTableModel::LevelTableModel(const Document& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
    connect(&document, &Document::opened, this, &LevelTableModel::rebuild);
    connect(&document, &Document::closed, this, &LevelTableModel::rebuild);
    connect(&document, &Document::levelAdded, this, &LevelTableModel::rebuild);
    connect(&document, &Document::levelRemoved, this, &LevelTableModel::rebuild);
    connect(&document, &Document::currentChanged, this, &LevelTableModel::refreshCurrent);
}

int LevelTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int LevelTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : column_count;
}

QVariant LevelTableModel::data(const QModelIndex& index, int role) const {
    const Row& row = rows_.at(static_cast<std::size_t>(index.row()));
    const CaseLevel* const level = document_.level(row.id);
    if (level == nullptr) {
        return {};
    }
    switch (role) {
    case Qt::DisplayRole:
        return index.column() == number ? QString(2 * row.indent, QChar(0x2003)) + // em spaces
                                              (row.indent > 0 ? QStringLiteral("↳ ") : QString()) +
                                              QString::number(level->number)
                                        : text_of(*level, index.column());
    case Qt::SizeHintRole: {
        // A little air between the columns.
        const QFontMetrics metrics{QFont()};
        return QSize(metrics.horizontalAdvance(text_of(*level, index.column())) + 22,
                     metrics.height() + 8);
    }
    case Qt::TextAlignmentRole:
        return index.column() == number ? int(Qt::AlignLeft | Qt::AlignVCenter)
                                        : int(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole: {
        QFont font;
        font.setBold(document_.current() == level);
        return font;
    }
    case Qt::ToolTipRole:
        return headerData(index.column(), Qt::Horizontal, Qt::ToolTipRole);
    default:
        return {};
    }
}

QVariant LevelTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= column_count) {
        return {};
    }
    const Heading& heading = headings.at(static_cast<std::size_t>(section));
    switch (role) {
    case Qt::DisplayRole:
        if (section == elements && document_.isOpen()) {
            return document_.file().dimension == 3 ? tr("Tets") : tr("Triangles");
        }
        return tr(heading.title);
    case Qt::ToolTipRole:
        return tr(heading.explanation);
    case Qt::TextAlignmentRole:
        return section == number ? int(Qt::AlignLeft | Qt::AlignVCenter)
                                 : int(Qt::AlignRight | Qt::AlignVCenter);
    default:
        return {};
    }
}

int LevelTableModel::idOf(int row) const {
    return row >= 0 && row < rowCount() ? rows_[static_cast<std::size_t>(row)].id : -1;
}

int LevelTableModel::rowOf(int id) const {
    const auto found =
        std::find_if(rows_.begin(), rows_.end(), [id](const Row& row) { return row.id == id; });
    return found != rows_.end() ? static_cast<int>(found - rows_.begin()) : -1;
}

void LevelTableModel::rebuild() {
    beginResetModel();
    rows_.clear();
    if (document_.isOpen()) {
        addRows(document_.levels().front().id, 0);
    }
    endResetModel();
}

void LevelTableModel::addRows(int id, int indent) {
    rows_.push_back({id, indent});
    const std::vector<int> successors = document_.successors(id);
    for (std::size_t i = 0; i < successors.size(); ++i) {
        addRows(successors[i], i == 0 ? indent : indent + 1);
    }
}

void LevelTableModel::refreshCurrent() {
    if (rowCount() > 0) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, column_count - 1), {Qt::FontRole});
    }
}

} // namespace ameco::gui
