// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/chart_widget.h"

#include "core/base/text.h"

#include <QFont>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ameco::gui {

ChartWidget::ChartWidget(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
}

void ChartWidget::setChart(Chart chart) {
    if (chart.classCount() == chart_.classCount()) {
        chart.selected = chart_.selected;
    }
    chart.percent = chart_.percent;
    chart.logarithmic = chart_.logarithmic;
    chart_ = std::move(chart);
    update();
}

void ChartWidget::setPercent(bool percent) {
    chart_.percent = percent;
    update();
}

void ChartWidget::setLogarithmic(bool logarithmic) {
    chart_.logarithmic = logarithmic;
    update();
}

void ChartWidget::setSelected(const std::set<int>& classes) {
    chart_.selected = classes;
    update();
}

QRectF ChartWidget::classBox(int k) const {
    const QRectF plot = draw_chart(chart_, size(), chartStyle()).plot;
    const double width = plot.width() / std::max(1, chart_.classCount());
    return {plot.left() + k * width, plot.top(), width, plot.height()};
}

QString ChartWidget::hoverText(const QPointF& position) const {
    const int k = classAt(position.x());
    if (k < 0) {
        return {};
    }
    const auto i = static_cast<std::size_t>(k);
    QString text = chart_.kind == Chart::Kind::bars && i + 1 < chart_.edges.size()
                       ? tr("<b>%1 to %2</b>").arg(chart_.edges[i], chart_.edges[i + 1])
                       : tr("<b>%1 %2</b>").arg(chart_.x_title).arg(k);
    text += QStringLiteral("<table>");
    for (const ChartSeries& s : chart_.series) {
        if (i >= s.values.size()) {
            continue;
        }
        QString value = QString::fromStdString(number_text(s.values[i]));
        if (chart_.kind == Chart::Kind::bars) {
            Chart shares = chart_;
            shares.percent = true;
            value = QString::fromStdString(count_text(std::llround(s.values[i]))) +
                    QStringLiteral("</td><td align=right>&nbsp;&nbsp;%1 %")
                        .arg(shares.shown(s, i), 0, 'f', 2);
        }
        text += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td align=right>%2</td></tr>")
                    .arg(s.title.toHtmlEscaped(), value);
    }
    return text + QStringLiteral("</table>");
}

ChartStyle ChartWidget::chartStyle() const {
    ChartStyle style;
    style.background = palette().color(QPalette::Base);
    style.text = palette().color(QPalette::Text);
    style.grid = style.text;
    style.grid.setAlphaF(0.14F);
    style.band = palette().color(QPalette::Highlight);
    style.band.setAlphaF(0.3F);
    style.font = font();
    return style;
}

void ChartWidget::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const ChartStyle look = chartStyle();
    Chart chart = chart_;
    if (look.background.lightness() < 128) { // deep colours would drown in the dark
        for (ChartSeries& s : chart.series) {
            s.colour = s.colour.toHsl();
            s.colour.setHslF(s.colour.hslHueF(), s.colour.hslSaturationF(),
                             std::max(0.62F, s.colour.lightnessF()));
        }
    }
    const ChartDrawing drawing = draw_chart(chart, size(), look);
    paint_chart(painter, drawing, look);
    if (hasFocus() && cursor_ >= 0 && selectable_) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1, Qt::DotLine));
        painter.drawRect(classBox(cursor_));
    }
}

int ChartWidget::classAt(double x) const {
    if (chart_.series.empty()) {
        return -1;
    }
    const QRectF plot = draw_chart(chart_, size(), chartStyle()).plot;
    const int count = chart_.classCount();
    const double k = chart_.kind == Chart::Kind::bars
                         ? std::floor((x - plot.left()) / plot.width() * count)
                         : std::round((x - plot.left()) / plot.width() * (count - 1));
    return k >= 0 && k < count ? static_cast<int>(k) : -1;
}

void ChartWidget::select(std::set<int> classes) {
    if (classes != chart_.selected) {
        chart_.selected = std::move(classes);
        update();
        emit selectionChanged(chart_.selected);
    }
}

void ChartWidget::mousePressEvent(QMouseEvent* event) {
    if (!selectable_ || event->button() != Qt::LeftButton) {
        return;
    }
    pressed_ = classAt(event->position().x());
    const bool adds = (event->modifiers() & Qt::ControlModifier) != 0;
    before_ = adds ? chart_.selected : std::set<int>();
    if (pressed_ < 0) {
        select(before_);
        return;
    }
    std::set<int> classes = before_;
    const bool alone = chart_.selected == std::set<int>{pressed_};
    if (adds ? classes.erase(pressed_) == 0 : !alone) {
        classes.insert(pressed_);
    }
    select(std::move(classes));
}

void ChartWidget::mouseMoveEvent(QMouseEvent* event) {
    const int k = classAt(event->position().x());
    if (pressed_ >= 0 && k >= 0 && k != pressed_) {
        std::set<int> classes = before_;
        for (int i = std::min(k, pressed_); i <= std::max(k, pressed_); ++i) {
            classes.insert(i);
        }
        select(std::move(classes));
    }
    const QString text = hoverText(event->position());
    text.isEmpty() ? QToolTip::hideText()
                   : QToolTip::showText(event->globalPosition().toPoint(), text, this);
}

void ChartWidget::mouseReleaseEvent(QMouseEvent*) {
    pressed_ = -1;
}

void ChartWidget::keyPressEvent(QKeyEvent* event) {
    const int count = chart_.classCount();
    if (event->key() == Qt::Key_Escape && !chart_.selected.empty()) {
        select({});
    } else if ((event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) && count > 0) {
        cursor_ = std::clamp(cursor_ + (event->key() == Qt::Key_Left ? -1 : 1), 0, count - 1);
        update();
    } else if (event->key() == Qt::Key_Space && cursor_ >= 0 && selectable_) {
        std::set<int> classes = chart_.selected;
        if (classes.erase(cursor_) == 0) {
            classes.insert(cursor_);
        }
        select(std::move(classes));
    } else {
        QWidget::keyPressEvent(event);
    }
}

void ChartWidget::leaveEvent(QEvent*) {
    QToolTip::hideText();
}

} // namespace ameco::gui
