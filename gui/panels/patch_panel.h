// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The patches: show, isolate, freeze.
#pragma once

#include <QWidget>

#include <set>

class QTableView;

namespace ameco::gui {

class PatchModel;

class PatchPanel : public QWidget {
    Q_OBJECT
public:
    explicit PatchPanel(PatchModel& model, QWidget* parent = nullptr);

    [[nodiscard]] QTableView& table() { return *table_; }
    [[nodiscard]] std::set<int> selectedPatches() const;

public slots:
    void isolateSelected();
    void showAll();
    void selectPatch(int patch);

signals:
    void selectionChanged();

private:
    PatchModel& model_;
    QTableView* table_;
};

} // namespace ameco::gui
