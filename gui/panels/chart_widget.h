// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A chart on the screen: hover for values, drag to select classes.
#pragma once

#include "gui/panels/chart.h"

#include <QWidget>

namespace ameco::gui {

/// Shows a chart in the colours of the palette. A click selects a class, a drag several, with Ctrl
/// in addition to those selected; Esc selects none. With the keyboard: left, right, space.
class ChartWidget : public QWidget {
    Q_OBJECT
public:
    explicit ChartWidget(QWidget* parent = nullptr);

    [[nodiscard]] const Chart& chart() const { return chart_; }
    /// Keeps the selection where the classes are as many as before.
    void setChart(Chart chart);
    void setPercent(bool percent);
    void setLogarithmic(bool logarithmic);
    void setSelectable(bool selectable) { selectable_ = selectable; }
    void setSelected(const std::set<int>& classes); ///< tells nobody

    /// Where a class is, for tests.
    [[nodiscard]] QRectF classBox(int k) const;
    /// What is told about the class under the mouse; "" off the classes.
    [[nodiscard]] QString hoverText(const QPointF& position) const;

    [[nodiscard]] QSize sizeHint() const override { return {560, 210}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {260, 130}; }

signals:
    void selectionChanged(const std::set<int>& classes); ///< by the user's hand

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] ChartStyle chartStyle() const;
    [[nodiscard]] int classAt(double x) const; ///< -1 off the plot
    void select(std::set<int> classes);

    Chart chart_;
    bool selectable_ = true;
    int pressed_ = -1;
    int cursor_ = -1;
    std::set<int> before_;
};

} // namespace ameco::gui
