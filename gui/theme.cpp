// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/theme.h"

#include <QApplication>
#include <QHeaderView>
#include <QPalette>
#include <QStyleFactory>
#include <QTableView>

namespace ameco::gui {
namespace {

struct Colours {
    QColor window, base, alternate, text, faint, button, highlight, link;
};

QPalette palette_of(const Colours& c) {
    QPalette p;
    p.setColor(QPalette::Window, c.window);
    p.setColor(QPalette::WindowText, c.text);
    p.setColor(QPalette::Base, c.base);
    p.setColor(QPalette::AlternateBase, c.alternate);
    p.setColor(QPalette::Text, c.text);
    p.setColor(QPalette::Button, c.button);
    p.setColor(QPalette::ButtonText, c.text);
    p.setColor(QPalette::ToolTipBase, c.base);
    p.setColor(QPalette::ToolTipText, c.text);
    p.setColor(QPalette::PlaceholderText, c.faint);
    p.setColor(QPalette::Highlight, c.highlight);
    p.setColor(QPalette::HighlightedText, Qt::white);
    p.setColor(QPalette::Link, c.link);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        p.setColor(QPalette::Disabled, role, c.faint);
    }
    return p;
}

} // namespace

void apply_theme(QApplication& application, bool dark) {
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    application.setPalette(
        // Fields are lighter than the window, or Fusion's empty check boxes would not be seen.
        dark ? palette_of({QColor(38, 40, 44), QColor(54, 57, 62), QColor(60, 63, 69),
                           QColor(226, 228, 232), QColor(138, 142, 150), QColor(66, 69, 75),
                           QColor(45, 110, 175), QColor(130, 190, 250)})
             : palette_of({QColor(244, 245, 247), Qt::white, QColor(247, 248, 250),
                           QColor(32, 34, 38), QColor(150, 154, 162), QColor(238, 240, 243),
                           QColor(31, 78, 121), QColor(31, 95, 160)}));
}

void style_table(QTableView& table) {
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setFrameShape(QFrame::NoFrame);
    table.setShowGrid(false);
    table.setTabKeyNavigation(false);
    table.verticalHeader()->hide();
    table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 8);
    table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table.horizontalHeader()->setHighlightSections(false);
}

} // namespace ameco::gui
