// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A field for a number of any size: 1e-9 as well as 250000.
#pragma once

#include <QLineEdit>

namespace ameco::gui {

class NumberEdit : public QLineEdit {
    Q_OBJECT
public:
    /// \param low, high  what is accepted
    NumberEdit(double low, double high, QWidget* parent = nullptr);

    [[nodiscard]] double value() const { return value_; }
    void setValue(double value); ///< tells nobody

signals:
    void valueChanged(double value); ///< by the user's hand

private:
    void finish();

    double low_, high_;
    double value_ = 0;
};

} // namespace ameco::gui
