// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What happened, line by line.
#pragma once

#include "core/base/monitor.h"

#include <QPlainTextEdit>

namespace ameco::gui {

class LogPanel : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit LogPanel(QWidget* parent = nullptr);

public slots:
    void add(ameco::Severity severity, const QString& text);
};

} // namespace ameco::gui
