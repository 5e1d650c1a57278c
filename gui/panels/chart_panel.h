// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A chart with what can be done to it.
#pragma once

#include "gui/panels/chart_widget.h"

#include <QWidget>

class QCheckBox;
class QHBoxLayout;
class QToolButton;

namespace ameco::gui {

/// Per cent or counts, logarithmic axis, export.
class ChartPanel : public QWidget {
    Q_OBJECT
public:
    /// \param name  of files it is exported to: "aspect-ratios"
    explicit ChartPanel(const QString& name, QWidget* parent = nullptr);

    [[nodiscard]] ChartWidget& chart() { return *chart_; }
    [[nodiscard]] QHBoxLayout& tools() { return *tools_; }
    void setChart(const Chart& chart);
    void setPercent(bool percent);
    void setLogarithmic(bool logarithmic);

public slots:
    /// Writes a file; the suffix says what: .png, .svg or .csv.
    void exportTo(const QString& path);

signals:
    void exported(const QString& path);
    void failed(const QString& reason);

private:
    void chooseFile();

    QString name_;
    ChartWidget* chart_;
    QHBoxLayout* tools_;
    QCheckBox* percent_;
    QCheckBox* logarithmic_;
    QToolButton* export_;
};

} // namespace ameco::gui
