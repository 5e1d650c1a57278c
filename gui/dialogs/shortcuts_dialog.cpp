// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/dialogs/shortcuts_dialog.h"

#include <QDialogButtonBox>
#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace ameco::gui {
namespace {

QString row(const QString& key, const QString& what) {
    return QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>")
        .arg(key.toHtmlEscaped(), what.toHtmlEscaped());
}

QString rows_of(const QMenu& menu) {
    QString rows;
    for (const QAction* action : menu.actions()) {
        if (action->menu() != nullptr) {
            rows += rows_of(*action->menu());
        } else if (!action->shortcut().isEmpty()) {
            QString name = action->text();
            rows += row(action->shortcut().toString(QKeySequence::NativeText),
                        name.remove(QLatin1Char('&')).remove(QStringLiteral("…")));
        }
    }
    return rows;
}

QString mouse_rows() {
    return row(ShortcutsDialog::tr("left button"), ShortcutsDialog::tr("turn; a click picks")) +
           row(ShortcutsDialog::tr("middle, or Shift + left"), ShortcutsDialog::tr("shift")) +
           row(ShortcutsDialog::tr("wheel"), ShortcutsDialog::tr("zoom at the mouse")) +
           row(ShortcutsDialog::tr("clip plane's handle"),
               ShortcutsDialog::tr("drag the shaft to move, the tip to turn")) +
           row(ShortcutsDialog::tr("drag in a histogram"),
               ShortcutsDialog::tr("select classes: their nodes light up")) +
           row(ShortcutsDialog::tr("drop files"), ShortcutsDialog::tr("open them"));
}

} // namespace

QString shortcuts_html(const QMenuBar& menus) {
    QString text;
    for (const QAction* action : menus.actions()) {
        const QString rows = action->menu() != nullptr ? rows_of(*action->menu()) : QString();
        if (!rows.isEmpty()) {
            QString title = action->text();
            text += QStringLiteral("<h3>%1</h3><table cellpadding=2>%2</table>")
                        .arg(title.remove(QLatin1Char('&')), rows);
        }
    }
    return text + QStringLiteral("<h3>%1</h3><table cellpadding=2>%2</table>")
                      .arg(ShortcutsDialog::tr("Mouse"), mouse_rows());
}

ShortcutsDialog::ShortcutsDialog(const QMenuBar& menus, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Shortcuts"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* const text = new QTextBrowser;
    text->setFrameShape(QFrame::NoFrame);
    text->setHtml(shortcuts_html(menus));
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* const column = new QVBoxLayout(this);
    column->addWidget(text);
    column->addWidget(buttons);
    resize(460, 640);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

} // namespace ameco::gui
