// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Histograms and curves as plain data, and as the shapes they are drawn with: the same on the
/// screen and in a file.
#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>

#include <set>
#include <vector>

class QPainter;

namespace ameco::gui {

struct ChartSeries {
    QString title;
    QColor colour;
    std::vector<double> values; ///< one per class, or one per step of a curve
    bool hollow = false;        ///< drawn as an outline: predicted, or a selection
};

struct Chart {
    enum class Kind { bars, curves };
    Kind kind = Kind::bars;
    QString x_title, y_title;
    std::vector<QString> edges; ///< bars: labels of the classes' edges, one more than classes
    std::vector<ChartSeries> series;
    bool percent = false;     ///< bars: each series as shares of its sum
    bool logarithmic = false; ///< values on a logarithmic axis
    std::set<int> selected;   ///< classes with a band behind them
    std::set<int> marked;     ///< classes with a mark on the axis
    QString empty_text;       ///< said where there is nothing to draw

    [[nodiscard]] int classCount() const;
    /// What the axis shows of a value of a series.
    [[nodiscard]] double shown(const ChartSeries& s, std::size_t k) const;
};

struct ChartStyle {
    QColor background, text, grid, band;
    QFont font;
};

/// One thing to draw.
struct ChartShape {
    enum class Kind { rectangle, line, text };
    Kind kind = Kind::rectangle;
    QRectF box;  ///< a line goes from its top left to its bottom right corner
    QColor fill; ///< of rectangles; not valid: none
    QColor pen;  ///< of outlines, lines, text; not valid: none
    double width = 1;
    QString text;         ///< baseline at the box's top left corner
    int anchor = 0;       ///< text: -1 begins, 0 centred, 1 ends there
    bool upright = false; ///< text runs upwards
};

/// A chart laid out for a size [pixels].
struct ChartDrawing {
    QSizeF size;
    QRectF plot; ///< where the classes are
    std::vector<ChartShape> shapes;
};

[[nodiscard]] ChartDrawing draw_chart(const Chart& chart, QSizeF size, const ChartStyle& style);

void paint_chart(QPainter& painter, const ChartDrawing& drawing, const ChartStyle& style);
[[nodiscard]] QString chart_svg(const ChartDrawing& drawing, const ChartStyle& style);
/// One line per class or step, one column per series, numbers as they were counted.
[[nodiscard]] QString chart_csv(const Chart& chart);

/// Writes .png (in twice the size), .svg or .csv, whole or not at all.
/// \throws Error
void write_chart(const QString& path, const Chart& chart, QSizeF size);

/// Dark text on white, for files.
[[nodiscard]] ChartStyle paper_style();

} // namespace ameco::gui
