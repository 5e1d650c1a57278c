// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How multigrid converges on the current branch, measured when asked for.
#pragma once

#include "gui/jobs/job_runner.h"
#include "gui/panels/chart_panel.h"

class QLabel;
class QPushButton;

namespace ameco::gui {

class Document;

class ConvergencePanel : public ChartPanel {
    Q_OBJECT
public:
    explicit ConvergencePanel(Document& document, QWidget* parent = nullptr);

    [[nodiscard]] JobRunner& jobs() { return jobs_; }

public slots:
    void measure(); ///< again: cancels

private:
    void forget();
    void enable();

    Document& document_;
    JobRunner jobs_;
    QPushButton* measure_;
    QLabel* step_;
};

} // namespace ameco::gui
