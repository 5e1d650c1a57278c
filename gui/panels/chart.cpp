// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/chart.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/hierarchy/settings.h"
#include "core/io/atomic_file.h"

#include <QBuffer>
#include <QFileInfo>
#include <QFont>
#include <QFontMetricsF>
#include <QImage>
#include <QObject>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ameco::gui {
namespace {

const QColor mark_colour(214, 39, 40);

QString number_label(double value) {
    return QString::fromStdString(number_text(value, 3));
}

/// The axis of values: from where to where, and its ticks.
struct ValueAxis {
    double low = 0, high = 1;
    bool logarithmic = false;
    std::vector<double> ticks;

    /// 0 at the bottom, 1 at the top.
    [[nodiscard]] double at(double value) const {
        if (!logarithmic) {
            return (value - low) / (high - low);
        }
        return value > 0 ? std::log(value / low) / std::log(high / low) : -1;
    }
};

ValueAxis linear_axis(double largest) {
    ValueAxis axis;
    const double raw = std::max(largest, 1e-300) / 4;
    const double power = std::pow(10, std::floor(std::log10(raw)));
    const double step = raw > 5 * power   ? 10 * power
                        : raw > 2 * power ? 5 * power
                        : raw > power     ? 2 * power
                                          : power;
    axis.high = std::ceil(largest / step) * step;
    for (double tick = 0; tick <= axis.high * (1 + 1e-9); tick += step) {
        axis.ticks.push_back(tick);
    }
    return axis;
}

ValueAxis logarithmic_axis(double smallest, double largest) {
    ValueAxis axis;
    axis.logarithmic = true;
    const int first = static_cast<int>(std::floor(std::log10(smallest) - 1e-9));
    const int last = std::max(first + 1, static_cast<int>(std::ceil(std::log10(largest) - 1e-9)));
    axis.low = std::pow(10, first);
    axis.high = std::pow(10, last);
    const int step = std::max(1, (last - first + 4) / 5);
    for (int p = first; p <= last; p += step) {
        axis.ticks.push_back(std::pow(10, p));
    }
    return axis;
}

ValueAxis value_axis(const Chart& chart) {
    double smallest = HUGE_VAL;
    double largest = 0;
    for (const ChartSeries& s : chart.series) {
        for (std::size_t k = 0; k < s.values.size(); ++k) {
            const double value = chart.shown(s, k);
            largest = std::max(largest, value);
            smallest = value > 0 ? std::min(smallest, value) : smallest;
        }
    }
    if (!(largest > 0)) {
        return linear_axis(1);
    }
    return chart.logarithmic ? logarithmic_axis(smallest, largest) : linear_axis(largest);
}

/// Puts shapes into a drawing.
class Draughtsman {
public:
    Draughtsman(const Chart& chart, QSizeF size, const ChartStyle& style)
        : chart_(chart), style_(style), metrics_(style.font), axis_(value_axis(chart)) {
        drawing_.size = size;
    }

    ChartDrawing draw() {
        if (chart_.series.empty()) {
            text({drawing_.size.width() / 2, drawing_.size.height() / 2}, chart_.empty_text, 0,
                 style_.text);
            return std::move(drawing_);
        }
        place_plot();
        bands();
        value_ticks();
        chart_.kind == Chart::Kind::bars ? bars() : curves();
        class_ticks();
        titles();
        return std::move(drawing_);
    }

private:
    void text(QPointF at, const QString& words, int anchor, const QColor& colour,
              bool upright = false) {
        ChartShape shape;
        shape.kind = ChartShape::Kind::text;
        shape.box = {at, QSizeF()};
        shape.text = words;
        shape.anchor = anchor;
        shape.pen = colour;
        shape.upright = upright;
        drawing_.shapes.push_back(shape);
    }
    void line(QPointF from, QPointF to, const QColor& colour, double width = 1) {
        ChartShape shape;
        shape.kind = ChartShape::Kind::line;
        shape.box = {from, to};
        shape.pen = colour;
        shape.width = width;
        drawing_.shapes.push_back(shape);
    }
    void rectangle(const QRectF& box, const QColor& fill, const QColor& pen = {},
                   double width = 1) {
        drawing_.shapes.push_back(
            {ChartShape::Kind::rectangle, box, fill, pen, width, QString(), 0, false});
    }

    [[nodiscard]] QString tick_label(double tick) const {
        return chart_.kind == Chart::Kind::curves ? QString::number(tick, 'g', 3)
                                                  : number_label(tick);
    }

    void place_plot() {
        double widest = 0;
        for (const double tick : axis_.ticks) {
            widest = std::max(widest, metrics_.horizontalAdvance(tick_label(tick)));
        }
        const double line_height = metrics_.height();
        const double left = widest + 1.6 * line_height + 8;
        const double top = 1.9 * line_height;
        const double bottom = 2.7 * line_height;
        drawing_.plot = {left, top, std::max(10.0, drawing_.size.width() - left - 16),
                         std::max(10.0, drawing_.size.height() - top - bottom)};
    }

    [[nodiscard]] double y_of(double value) const {
        return drawing_.plot.bottom() -
               std::clamp(axis_.at(value), 0.0, 1.0) * drawing_.plot.height();
    }

    void bands() {
        const double width = drawing_.plot.width() / std::max(1, chart_.classCount());
        for (const int k : chart_.selected) {
            rectangle({drawing_.plot.left() + k * width, drawing_.plot.top(), width,
                       drawing_.plot.height()},
                      style_.band);
        }
    }

    void value_ticks() {
        for (const double tick : axis_.ticks) {
            const double y = y_of(tick);
            line({drawing_.plot.left(), y}, {drawing_.plot.right(), y}, style_.grid);
            text({drawing_.plot.left() - 6, y + 0.35 * metrics_.ascent()}, tick_label(tick), 1,
                 style_.text);
        }
    }

    void bars() {
        const int classes = chart_.classCount();
        const double width = drawing_.plot.width() / std::max(1, classes);
        const double gap = std::min(8.0, 0.16 * width);
        const double bar = (width - gap) / static_cast<double>(chart_.series.size());
        for (std::size_t i = 0; i < chart_.series.size(); ++i) {
            const ChartSeries& s = chart_.series[i];
            for (std::size_t k = 0; k < s.values.size(); ++k) {
                const double y = y_of(chart_.shown(s, k));
                const double x = drawing_.plot.left() + static_cast<double>(k) * width + gap / 2 +
                                 static_cast<double>(i) * bar;
                if (y >= drawing_.plot.bottom()) {
                    continue;
                }
                const QRectF box(x, y, bar * (bar > 4 ? 0.9 : 1), drawing_.plot.bottom() - y);
                // An outline lies half a pixel inside, but not below the axis.
                const double inside = std::min(0.5, box.height());
                s.hollow ? rectangle(box.adjusted(0.5, inside, -0.5, 0), {}, s.colour, 1.2)
                         : rectangle(box, s.colour);
            }
        }
    }

    void curves() {
        const double steps = std::max(1, chart_.classCount() - 1);
        for (const ChartSeries& s : chart_.series) {
            for (std::size_t k = 0; k + 1 < s.values.size(); ++k) {
                const auto point = [&](std::size_t i) {
                    return QPointF(drawing_.plot.left() +
                                       static_cast<double>(i) / steps * drawing_.plot.width(),
                                   y_of(chart_.shown(s, i)));
                };
                line(point(k), point(k + 1), s.colour, 2);
            }
        }
    }

    void class_ticks() {
        line(drawing_.plot.bottomLeft(), drawing_.plot.bottomRight(), style_.text);
        const double width = drawing_.plot.width() / std::max(1, chart_.classCount());
        for (const int k : chart_.marked) {
            const double x = drawing_.plot.left() + k * width;
            rectangle({x + 0.1 * width, drawing_.plot.bottom() - 1, 0.8 * width, 5}, mark_colour);
        }
        std::vector<QString> labels = chart_.edges;
        if (chart_.kind == Chart::Kind::curves) {
            for (int k = 0; k < chart_.classCount(); ++k) {
                labels.push_back(QString::number(k));
            }
        }
        if (labels.size() < 2) {
            return;
        }
        double widest = 0;
        for (const QString& label : labels) {
            widest = std::max(widest, metrics_.horizontalAdvance(label));
        }
        const double distance = drawing_.plot.width() / static_cast<double>(labels.size() - 1);
        const auto every = static_cast<std::size_t>(
            std::max(1.0, std::ceil((widest + 0.8 * metrics_.height()) / distance)));
        const double y = drawing_.plot.bottom();
        for (std::size_t k = 0; k < labels.size(); k += every) {
            const double x = drawing_.plot.left() + static_cast<double>(k) * distance;
            line({x, y}, {x, y + 4}, style_.text);
            text({x, y + 5 + metrics_.ascent()}, labels[k], 0, style_.text);
        }
    }

    void titles() {
        const double line_height = metrics_.height();
        text({drawing_.plot.center().x(), drawing_.size.height() - 0.4 * line_height},
             chart_.x_title, 0, style_.text);
        const QString values =
            chart_.percent ? QObject::tr("% of %1").arg(chart_.y_title) : chart_.y_title;
        text({0.95 * line_height, drawing_.plot.center().y()}, values, 0, style_.text, true);
        double x = drawing_.plot.left();
        const double y = 1.2 * line_height;
        const double box = 0.7 * line_height;
        for (const ChartSeries& s : chart_.series) {
            const QRectF key(x, y - 0.82 * box, box, box);
            s.hollow ? rectangle(key.adjusted(0.5, 0.5, -0.5, -0.5), {}, s.colour, 1.4)
                     : rectangle(key, s.colour);
            text({x + box + 5, y}, s.title, -1, style_.text);
            x += box + 5 + metrics_.horizontalAdvance(s.title) + 14;
        }
    }

    const Chart& chart_;
    const ChartStyle& style_;
    QFontMetricsF metrics_;
    ValueAxis axis_;
    ChartDrawing drawing_;
};

QString svg_colour(const QColor& colour) {
    return colour.isValid() ? colour.name() : QStringLiteral("none");
}

QString svg_shape(const ChartShape& s) {
    const auto number = [](double value) { return QString::number(value, 'f', 2); };
    switch (s.kind) {
    case ChartShape::Kind::rectangle:
        return QStringLiteral("<rect x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\" fill=\"%5\" "
                              "fill-opacity=\"%6\" stroke=\"%7\" stroke-width=\"%8\"/>\n")
            .arg(number(s.box.x()), number(s.box.y()), number(s.box.width()),
                 number(s.box.height()), svg_colour(s.fill), number(s.fill.alphaF()),
                 svg_colour(s.pen), number(s.width));
    case ChartShape::Kind::line:
        return QStringLiteral("<line x1=\"%1\" y1=\"%2\" x2=\"%3\" y2=\"%4\" stroke=\"%5\" "
                              "stroke-width=\"%6\" stroke-linecap=\"round\"/>\n")
            .arg(number(s.box.left()), number(s.box.top()), number(s.box.right()),
                 number(s.box.bottom()), svg_colour(s.pen), number(s.width));
    case ChartShape::Kind::text:
        break;
    }
    const char* const anchor = s.anchor < 0 ? "start" : s.anchor > 0 ? "end" : "middle";
    const QString turn = s.upright ? QStringLiteral(" transform=\"rotate(-90 %1 %2)\"")
                                         .arg(number(s.box.x()), number(s.box.y()))
                                   : QString();
    return QStringLiteral("<text x=\"%1\" y=\"%2\" text-anchor=\"%3\" fill=\"%4\"%5>%6</text>\n")
        .arg(number(s.box.x()), number(s.box.y()), QLatin1String(anchor), svg_colour(s.pen), turn,
             s.text.toHtmlEscaped());
}

void write_bytes(const QString& path, const QByteArray& bytes) {
    AtomicFile file(path.toStdString());
    file.write(bytes.data(), static_cast<std::size_t>(bytes.size()));
    file.commit();
}

} // namespace

int Chart::classCount() const {
    std::size_t count = edges.empty() ? 0 : edges.size() - 1;
    for (const ChartSeries& s : series) {
        count = std::max(count, s.values.size());
    }
    return static_cast<int>(count);
}

double Chart::shown(const ChartSeries& s, std::size_t k) const {
    if (!percent) {
        return s.values[k];
    }
    const double sum = std::accumulate(s.values.begin(), s.values.end(), 0.0);
    return sum > 0 ? 100 * s.values[k] / sum : 0;
}

ChartDrawing draw_chart(const Chart& chart, QSizeF size, const ChartStyle& style) {
    return Draughtsman(chart, size, style).draw();
}

void paint_chart(QPainter& painter, const ChartDrawing& drawing, const ChartStyle& style) {
    painter.fillRect(QRectF(QPointF(), drawing.size), style.background);
    painter.setFont(style.font);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const ChartShape& s : drawing.shapes) {
        const QPen pen =
            s.pen.isValid() ? QPen(s.pen, s.width, Qt::SolidLine, Qt::RoundCap) : QPen(Qt::NoPen);
        painter.setPen(pen);
        if (s.kind == ChartShape::Kind::rectangle) {
            painter.setBrush(s.fill.isValid() ? QBrush(s.fill) : QBrush(Qt::NoBrush));
            painter.drawRect(s.box);
        } else if (s.kind == ChartShape::Kind::line) {
            painter.drawLine(s.box.topLeft(), s.box.bottomRight());
        } else {
            const double width = QFontMetricsF(style.font).horizontalAdvance(s.text);
            painter.save();
            painter.translate(s.box.topLeft());
            painter.rotate(s.upright ? -90 : 0);
            painter.drawText(QPointF(-width * (s.anchor + 1) / 2, 0), s.text);
            painter.restore();
        }
    }
}

QString chart_svg(const ChartDrawing& drawing, const ChartStyle& style) {
    QString text = QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %1 %2\" "
                                  "font-family=\"sans-serif\" font-size=\"%3\">\n"
                                  "<rect width=\"%1\" height=\"%2\" fill=\"%4\"/>\n")
                       .arg(drawing.size.width())
                       .arg(drawing.size.height())
                       .arg(QFontMetricsF(style.font).height() * 0.8)
                       .arg(svg_colour(style.background));
    for (const ChartShape& s : drawing.shapes) {
        text += svg_shape(s);
    }
    return text + QStringLiteral("</svg>\n");
}

QString chart_csv(const Chart& chart) {
    const auto quoted = [](QString text) {
        return QLatin1Char('"') + text.replace(QLatin1Char('"'), QStringLiteral("\"\"")) +
               QLatin1Char('"');
    };
    QStringList heading;
    const bool bars = chart.kind == Chart::Kind::bars;
    heading << (bars ? QStringLiteral("from,to") : QStringLiteral("step"));
    for (const ChartSeries& s : chart.series) {
        heading << quoted(s.title);
    }
    QString text = heading.join(QLatin1Char(',')) + QLatin1Char('\n');
    for (int k = 0; k < chart.classCount(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        QStringList row;
        row << (bars ? quoted(chart.edges[i]) + QLatin1Char(',') + quoted(chart.edges[i + 1])
                     : QString::number(k));
        for (const ChartSeries& s : chart.series) {
            row << (i < s.values.size() ? QString::fromStdString(exact_word(s.values[i]))
                                        : QString());
        }
        text += row.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return text;
}

void write_chart(const QString& path, const Chart& chart, QSizeF size) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    const ChartStyle style = paper_style();
    if (suffix == QLatin1String("csv")) {
        write_bytes(path, chart_csv(chart).toUtf8());
    } else if (suffix == QLatin1String("svg")) {
        write_bytes(path, chart_svg(draw_chart(chart, size, style), style).toUtf8());
    } else if (suffix == QLatin1String("png")) {
        QImage image((2 * size).toSize(), QImage::Format_RGB32);
        image.setDevicePixelRatio(2);
        QPainter painter(&image);
        paint_chart(painter, draw_chart(chart, size, style), style);
        painter.end();
        QByteArray bytes;
        QBuffer buffer(&bytes);
        image.save(&buffer, "PNG");
        write_bytes(path, bytes);
    } else {
        throw UsageError(path.toStdString() + ": its name must end in .png, .svg or .csv");
    }
}

ChartStyle paper_style() {
    QFont font;
    font.setPixelSize(13);
    return {Qt::white, QColor(40, 40, 40), QColor(221, 221, 221), QColor(255, 214, 102, 90), font};
}

} // namespace ameco::gui
