// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The picked node: all that is known about it, and where it is on the other levels.
#pragma once

#include "gui/model/inspection.h"

#include <QWidget>

#include <map>
#include <optional>

class QPushButton;
class QSpinBox;
class QTextBrowser;
class QUrl;

namespace ameco::gui {

class InspectorPanel : public QWidget {
    Q_OBJECT
public:
    /// Where the node is on other levels: by id of the level, its number and the node there.
    struct Elsewhere {
        int level_id = -1;
        int level = 0;
        std::optional<NodeId> node;
    };

    explicit InspectorPanel(QWidget* parent = nullptr);

    void setInspection(const Inspection& inspection, const std::vector<Elsewhere>& elsewhere);
    void clear();
    void setNodeCount(std::int64_t nodes);
    [[nodiscard]] const std::optional<Inspection>& inspection() const { return inspection_; }
    [[nodiscard]] QString text() const; ///< what is shown, without its form
    [[nodiscard]] QSpinBox& idBox() { return *id_; }

public slots:
    void copy() const;
    void focusId();

signals:
    void nodeRequested(int node);                ///< of the current level
    void placeRequested(int level_id, int node); ///< on another level

private:
    void follow(const QUrl& link);

    std::optional<Inspection> inspection_;
    QSpinBox* id_;
    QTextBrowser* text_;
    QPushButton* copy_;
};

} // namespace ameco::gui
