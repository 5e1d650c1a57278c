// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/number_edit.h"

#include <QLocale>

#include <algorithm>

namespace ameco::gui {
namespace {

constexpr int digits = 8;

} // namespace

NumberEdit::NumberEdit(double low, double high, QWidget* parent)
    : QLineEdit(parent), low_(low), high_(high) {
    setAlignment(Qt::AlignRight);
    setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-1.2345e-10")) + 12);
    connect(this, &QLineEdit::editingFinished, this, &NumberEdit::finish);
}

void NumberEdit::setValue(double value) {
    value_ = std::clamp(value, low_, high_);
    setText(QLocale::c().toString(value_, 'g', digits));
}

void NumberEdit::finish() {
    bool ok = false;
    const double number = QLocale::c().toDouble(text().trimmed(), &ok);
    const double before = value_;
    const QString unchanged = QLocale::c().toString(value_, 'g', digits);
    setValue(ok && text().trimmed() != unchanged ? number : value_);
    if (value_ != before) {
        emit valueChanged(value_);
    }
}

} // namespace ameco::gui
