// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/convergence_panel.h"

#include "gui/model/convergence_work.h"
#include "gui/model/document.h"
#include "gui/panels/level_charts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace ameco::gui {

ConvergencePanel::ConvergencePanel(Document& document, QWidget* parent)
    : ChartPanel(QStringLiteral("convergence"), parent), document_(document) {
    measure_ = new QPushButton;
    step_ = new QLabel;
    tools().insertWidget(0, measure_);
    tools().insertWidget(1, step_);
    chart().setSelectable(false);
    setLogarithmic(true);
    connect(measure_, &QPushButton::clicked, this, &ConvergencePanel::measure);
    connect(&jobs_, &JobRunner::started, this, &ConvergencePanel::enable);
    connect(&jobs_, &JobRunner::ended, this, &ConvergencePanel::enable);
    connect(&jobs_, &JobRunner::progressed, this,
            [this](double, const QString& step) { step_->setText(step); });
    connect(&document, &Document::opened, this, &ConvergencePanel::forget);
    connect(&document, &Document::closed, this, &ConvergencePanel::forget);
    connect(&document, &Document::levelAdded, this, &ConvergencePanel::enable);
    connect(&document, &Document::levelRemoved, this, &ConvergencePanel::enable);
    forget();
}

void ConvergencePanel::measure() {
    if (jobs_.isRunning()) {
        jobs_.cancel();
        return;
    }
    std::vector<CaseLevel> levels;
    for (const CaseLevel* l : document_.currentBranch()) {
        levels.push_back(*l);
    }
    if (levels.size() < 2) {
        return;
    }
    jobs_.start(tr("Measuring convergence"), [this, levels](JobContext& job) {
        const auto curves = measure_convergence(levels, job);
        job.post([this, curves] { setChart(convergence_chart(curves)); });
    });
}

void ConvergencePanel::forget() {
    jobs_.cancel();
    setChart(convergence_chart({}));
    enable();
}

void ConvergencePanel::enable() {
    measure_->setText(jobs_.isRunning() ? tr("Cance&l") : tr("&Measure multigrid"));
    measure_->setEnabled(jobs_.isRunning() || document_.currentBranch().size() > 1);
    if (!jobs_.isRunning()) {
        step_->setText(document_.currentBranch().size() > 1
                           ? QString()
                           : tr("Needs two levels: coarsen the mesh first."));
    }
}

} // namespace ameco::gui
