// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The patches of the open case: what is shown of them, and which must stay untouched.
#pragma once

#include <QAbstractTableModel>
#include <QColor>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace ameco::gui {

class Document;

/// One row per patch; the check boxes of the columns `visible` and `frozen` can be changed.
class PatchModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { visible, name, faces, frozen, column_count };

    explicit PatchModel(const Document& document, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

    [[nodiscard]] int patchOf(int row) const;
    [[nodiscard]] int rowOf(int patch) const; ///< -1 when there is none
    [[nodiscard]] const std::set<int>& hidden() const { return hidden_; }
    [[nodiscard]] std::vector<int> frozenPatches() const;

    void setHidden(const std::set<int>& patches);
    void setFrozen(const std::vector<int>& patches);
    void isolate(const std::set<int>& patches); ///< hides all others

signals:
    void hiddenChanged();
    void frozenChanged();

private:
    struct Row {
        int patch = 0;
        QString name;
        QColor colour;
        std::int64_t faces = 0;
    };
    void rebuild();
    void tellAll();

    const Document& document_;
    std::vector<Row> rows_;
    std::set<int> hidden_, frozen_;
};

} // namespace ameco::gui
