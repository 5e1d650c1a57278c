// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/chart_panel.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <exception>

namespace ameco::gui {

ChartPanel::ChartPanel(const QString& name, QWidget* parent) : QWidget(parent), name_(name) {
    chart_ = new ChartWidget;
    percent_ = new QCheckBox(tr("&Per cent"));
    percent_->setToolTip(tr("Each level as shares of its own number, instead of counts"));
    logarithmic_ = new QCheckBox(tr("&Logarithmic"));
    logarithmic_->setToolTip(tr("Logarithmic axis of values"));
    export_ = new QToolButton;
    export_->setText(tr("E&xport…"));
    export_->setToolTip(tr("Write the chart as PNG, SVG or CSV"));
    tools_ = new QHBoxLayout;
    tools_->setContentsMargins(8, 2, 8, 2);
    tools_->setSpacing(12);
    tools_->addWidget(percent_);
    tools_->addWidget(logarithmic_);
    tools_->addStretch(1);
    tools_->addWidget(export_);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(chart_, 1);
    column->addLayout(tools_);
    connect(percent_, &QCheckBox::toggled, chart_, &ChartWidget::setPercent);
    connect(logarithmic_, &QCheckBox::toggled, chart_, &ChartWidget::setLogarithmic);
    connect(export_, &QToolButton::clicked, this, &ChartPanel::chooseFile);
}

void ChartPanel::setChart(const Chart& chart) {
    chart_->setChart(chart);
    percent_->setVisible(chart.kind == Chart::Kind::bars);
    export_->setEnabled(!chart.series.empty());
}

void ChartPanel::setPercent(bool percent) {
    percent_->setChecked(percent);
}

void ChartPanel::setLogarithmic(bool logarithmic) {
    logarithmic_->setChecked(logarithmic);
}

void ChartPanel::exportTo(const QString& path) {
    try {
        write_chart(path, chart_->chart(), chart_->size().expandedTo({640, 320}));
        emit exported(path);
    } catch (const std::exception& error) {
        emit failed(QString::fromUtf8(error.what()));
    }
}

void ChartPanel::chooseFile() {
    auto* const dialog = new QFileDialog(this, tr("Export the chart"), name_ + ".png",
                                         tr("PNG (*.png);;SVG (*.svg);;CSV (*.csv)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    dialog->selectFile(name_ + ".png");
    connect(dialog, &QFileDialog::fileSelected, this, &ChartPanel::exportTo);
    dialog->open();
}

} // namespace ameco::gui
