// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/log_panel.h"

#include <QTime>

namespace ameco::gui {
namespace {

constexpr int most_lines = 5000;

} // namespace

LogPanel::LogPanel(QWidget* parent) : QPlainTextEdit(parent) {
    setReadOnly(true);
    setMaximumBlockCount(most_lines);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    setFrameShape(QFrame::NoFrame);
    setPlaceholderText(tr("Messages of the program appear here."));
}

void LogPanel::add(Severity severity, const QString& text) {
    const bool dark = palette().color(QPalette::Base).lightness() < 128;
    QString line = QTime::currentTime().toString(QStringLiteral("hh:mm:ss  ")).toHtmlEscaped();
    line.replace(QLatin1Char(' '), QStringLiteral("&nbsp;"));
    const QString words = text.toHtmlEscaped();
    switch (severity) {
    case Severity::error:
        line += QStringLiteral("<span style=\"color:%1\"><b>%2</b> %3</span>")
                    .arg(dark ? "#ff8a80" : "#b00020", tr("error:"), words);
        break;
    case Severity::warning:
        line += QStringLiteral("<span style=\"color:%1\"><b>%2</b> %3</span>")
                    .arg(dark ? "#ffcc66" : "#8a5a00", tr("warning:"), words);
        break;
    case Severity::info:
        line += words;
    }
    appendHtml(line);
}

} // namespace ameco::gui
