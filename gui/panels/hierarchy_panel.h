// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The table of levels: click to show, delete what is not wanted.
#pragma once

#include <QWidget>

class QTableView;
class QToolButton;

namespace ameco::gui {

class Document;
class LevelTableModel;

class HierarchyPanel : public QWidget {
    Q_OBJECT
public:
    explicit HierarchyPanel(Document& document, QWidget* parent = nullptr);

    [[nodiscard]] QTableView& table() { return *table_; }
    [[nodiscard]] LevelTableModel& model() { return *model_; }

public slots:
    void removeCurrent();

private:
    void showCurrent();
    void copy() const;

    Document& document_;
    LevelTableModel* model_;
    QTableView* table_;
    QToolButton* remove_;
};

} // namespace ameco::gui
