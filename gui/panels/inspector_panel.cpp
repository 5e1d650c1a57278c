// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/inspector_panel.h"

#include "core/base/text.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

namespace ameco::gui {
namespace {

QString number(double value, int digits = 5) {
    return QString::fromStdString(number_text(value, digits));
}

QString cells(const std::vector<double>& values, int digits) {
    QString text;
    for (const double value : values) {
        text += QStringLiteral("<td align=right>%1</td>").arg(number(value, digits));
    }
    return text;
}

QString fact(const QString& what, const QString& value) {
    return QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>").arg(what, value);
}

QString facts(const Inspection& i) {
    QStringList patches;
    for (const std::string& patch : i.patches) {
        patches << QString::fromStdString(patch).toHtmlEscaped();
    }
    QStringList point;
    for (const double x : i.point) {
        point << number(x, 8);
    }
    return QStringLiteral("<table cellpadding=1>") +
           fact(InspectorPanel::tr("Position"), point.join(QStringLiteral(", "))) +
           fact(InspectorPanel::tr("Patches"),
                patches.isEmpty() ? InspectorPanel::tr("none") : patches.join(", ")) +
           fact(InspectorPanel::tr("Class"), QString::fromStdString(i.node_class)) +
           fact(InspectorPanel::tr("Elements"), InspectorPanel::tr("%1, worst quality %2")
                                                    .arg(i.elements)
                                                    .arg(number(i.worst_quality, 3))) +
           fact(InspectorPanel::tr("Aspect ratio"),
                QStringLiteral("<b>%1</b>").arg(number(i.aspect_ratio))) +
           QStringLiteral("</table>");
}

QString metric_table(const Inspection& i) {
    QString text = InspectorPanel::tr("<p><b>Natural metric</b></p>") +
                   QStringLiteral("<table cellpadding=2><tr><td></td><td align=right>%1</td>"
                                  "<td align=right>%2</td><td align=center colspan=3>%3</td></tr>")
                       .arg(InspectorPanel::tr("size"), InspectorPanel::tr("target"),
                            InspectorPanel::tr("direction"));
    for (std::size_t k = 0; k < i.sizes.size(); ++k) {
        text += QStringLiteral("<tr><td>h%1&nbsp;</td><td align=right>%2</td>"
                               "<td align=right>&nbsp;&nbsp;%3&nbsp;&nbsp;</td>%4</tr>")
                    .arg(k + 1)
                    .arg(number(i.sizes[k]), number(i.target_sizes[k]), cells(i.directions[k], 4));
    }
    return text + QStringLiteral("</table>");
}

QString means_table(const Inspection& i) {
    QString text = InspectorPanel::tr("<p><b>Means of the elements' metrics</b></p>") +
                   QStringLiteral("<table cellpadding=2><tr><td></td>");
    for (std::size_t k = 0; k < i.sizes.size(); ++k) {
        text += QStringLiteral("<td align=right>h%1</td>").arg(k + 1);
    }
    text += InspectorPanel::tr("<td align=right>AR</td><td align=right>turn°</td></tr>");
    for (const InspectedMean& m : i.means) {
        text += QStringLiteral("<tr><td>%1&nbsp;</td>").arg(QString::fromStdString(m.name));
        text += m.failure.empty() ? cells(m.sizes, 3) + cells({m.aspect_ratio}, 4) +
                                        cells({m.turn_deg < 1e-9 ? 0 : m.turn_deg}, 2)
                                  : QStringLiteral("<td colspan=%1>%2</td>")
                                        .arg(i.sizes.size() + 2)
                                        .arg(QString::fromStdString(m.failure).toHtmlEscaped());
        text += QStringLiteral("</tr>");
    }
    return text + QStringLiteral("</table>");
}

QString element_table(const Inspection& i) {
    if (!i.element) {
        return {};
    }
    const InspectedElement& e = *i.element;
    QStringList nodes, sizes;
    for (const int node : e.nodes) {
        nodes << QString::number(node);
    }
    for (const double size : e.sizes) {
        sizes << number(size, 4);
    }
    return InspectorPanel::tr("<p><b>Element %1</b>, where you clicked</p>").arg(e.id.value()) +
           QStringLiteral("<table cellpadding=1>") +
           fact(InspectorPanel::tr("Nodes"), nodes.join(QStringLiteral(", "))) +
           fact(InspectorPanel::tr("Region"), QString::number(e.region)) +
           fact(e.nodes.size() == 4 ? InspectorPanel::tr("Volume") : InspectorPanel::tr("Area"),
                number(e.volume)) +
           fact(InspectorPanel::tr("Quality"), number(e.quality, 3)) +
           fact(InspectorPanel::tr("Aspect ratio"), number(e.aspect_ratio)) +
           fact(InspectorPanel::tr("Sizes"), sizes.join(QStringLiteral(", "))) +
           QStringLiteral("</table>");
}

QString places(const std::vector<InspectorPanel::Elsewhere>& elsewhere) {
    if (elsewhere.empty()) {
        return {};
    }
    QString text = InspectorPanel::tr("<p><b>The same place</b></p>") +
                   QStringLiteral("<table cellpadding=1>");
    for (const auto& e : elsewhere) {
        const QString node = e.node ? QStringLiteral("<a href=\"node:%1/%2\">%3 %2</a>")
                                          .arg(e.level_id)
                                          .arg(e.node->value())
                                          .arg(InspectorPanel::tr("node"))
                                    : InspectorPanel::tr("removed");
        text += fact(InspectorPanel::tr("Level %1").arg(e.level), node);
    }
    return text + QStringLiteral("</table>");
}

} // namespace

InspectorPanel::InspectorPanel(QWidget* parent) : QWidget(parent) {
    id_ = new QSpinBox;
    id_->setRange(0, 0);
    id_->setAccessibleName(tr("Node"));
    auto* const go = new QPushButton(tr("&Go"));
    go->setToolTip(tr("Go to this node of the current level"));
    copy_ = new QPushButton(tr("Co&py"));
    text_ = new QTextBrowser;
    text_->setOpenLinks(false);
    text_->setFrameShape(QFrame::NoFrame);
    auto* const row = new QHBoxLayout;
    row->setContentsMargins(10, 6, 10, 0);
    row->addWidget(new QLabel(tr("Node")));
    row->addWidget(id_, 1);
    row->addWidget(go);
    row->addWidget(copy_);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(text_, 1);
    connect(go, &QPushButton::clicked, this, [this] { emit nodeRequested(id_->value()); });
    connect(id_, &QSpinBox::editingFinished, this, [this] {
        if (id_->hasFocus()) { // Enter, not the focus leaving
            emit nodeRequested(id_->value());
        }
    });
    connect(copy_, &QPushButton::clicked, this, &InspectorPanel::copy);
    connect(text_, &QTextBrowser::anchorClicked, this, &InspectorPanel::follow);
    clear();
}

void InspectorPanel::setInspection(const Inspection& inspection,
                                   const std::vector<Elsewhere>& elsewhere) {
    inspection_ = inspection;
    id_->setValue(inspection.node.value());
    text_->setHtml(
        tr("<p><b>Node %1</b> of level %2</p>").arg(inspection.node.value()).arg(inspection.level) +
        facts(inspection) + metric_table(inspection) + element_table(inspection) +
        means_table(inspection) + places(elsewhere));
    copy_->setEnabled(true);
}

void InspectorPanel::clear() {
    inspection_.reset();
    copy_->setEnabled(false);
    text_->setHtml(tr("<p>Click a node in a view, or type its number.</p>"));
}

void InspectorPanel::setNodeCount(std::int64_t nodes) {
    id_->setMaximum(static_cast<int>(std::max<std::int64_t>(0, nodes - 1)));
}

QString InspectorPanel::text() const {
    return text_->toPlainText();
}

void InspectorPanel::copy() const {
    if (inspection_) {
        QGuiApplication::clipboard()->setText(
            QString::fromStdString(inspection_text(*inspection_)));
    }
}

void InspectorPanel::focusId() {
    id_->setFocus();
    id_->selectAll();
}

void InspectorPanel::follow(const QUrl& link) {
    const QStringList parts = link.path().split(QLatin1Char('/'));
    if (parts.size() == 2) {
        emit placeRequested(parts[0].toInt(), parts[1].toInt());
    }
}

} // namespace ameco::gui
