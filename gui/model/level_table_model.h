// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The levels as a table.
#pragma once

#include <QAbstractTableModel>

#include <vector>

namespace ameco::gui {

class Document;

/// One row per level. A chain of levels stands below each other; what was made from a level besides
/// follows the chain, indented.
class LevelTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column {
        number,
        nodes,
        elements,
        ratio,
        predicted_ratio,
        max_aspect_ratio,
        top_5_percent,
        isotropic_share,
        worst_quality,
        deviation,
        seconds,
        column_count
    };

    explicit LevelTableModel(const Document& document, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

    [[nodiscard]] int idOf(int row) const; ///< of the level; -1 when there is no such row
    [[nodiscard]] int rowOf(int id) const; ///< -1 when there is no such level

private:
    struct Row {
        int id = -1;
        int indent = 0;
    };
    void rebuild();
    void addRows(int id, int indent);
    void refreshCurrent();

    const Document& document_;
    std::vector<Row> rows_;
};

} // namespace ameco::gui
