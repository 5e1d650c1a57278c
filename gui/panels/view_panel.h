// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the views show: a form for SceneOptions.
#pragma once

#include "gui/scene/scene_options.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QGroupBox;
class QPushButton;
class QSlider;
class QSpinBox;
class QVBoxLayout;

namespace ameco::gui {

class NumberEdit;

class ViewPanel : public QWidget {
    Q_OBJECT
public:
    explicit ViewPanel(QWidget* parent = nullptr);

    [[nodiscard]] const SceneOptions& options() const { return options_; }
    /// Shows options that come from elsewhere; tells nobody.
    void setOptions(const SceneOptions& options);
    /// Where the clip plane can be [L].
    void setBounds(const Vec3& low, const Vec3& high);
    /// The range of the colours at present, which locking keeps.
    void setShownRange(const std::optional<std::pair<double, double>>& range);
    void setPickKnown(bool known);
    void setMeansSideBySide(bool on); ///< tells nobody

    [[nodiscard]] QGroupBox& clipBox() { return *clip_; }
    [[nodiscard]] QGroupBox& lensBox() { return *lens_; }
    [[nodiscard]] QComboBox& colourBox() { return *colour_; }

public slots:
    void clipAcross(int axis); ///< puts the plane across an axis, through the middle
    void flipClip();

signals:
    void optionsChanged(const ameco::gui::SceneOptions& options); ///< by the user's hand
    void lensAtPickRequested();
    void meansSideBySideRequested(bool on);

private:
    void addLook(QVBoxLayout& column);
    void addClip(QVBoxLayout& column);
    void addScale(QVBoxLayout& column);
    void addEllipsoids(QVBoxLayout& column);
    void addDecorations(QVBoxLayout& column);
    void read();
    void showOptions();
    [[nodiscard]] double clipPosition() const;
    void moveClip(double position);
    [[nodiscard]] std::pair<double, double> clipSpan() const;

    SceneOptions options_;
    Vec3 low_ = Vec3::Zero(), high_ = Vec3::Ones();
    std::optional<std::pair<double, double>> shown_range_;
    bool filling_ = false;

    QComboBox *representation_, *colour_;
    QCheckBox* lock_;
    NumberEdit *range_low_, *range_high_;
    QGroupBox *clip_, *lens_;
    std::array<QPushButton*, 3> axis_buttons_;
    QSlider* clip_slider_;
    NumberEdit* clip_position_;
    QCheckBox *crinkle_, *other_side_;
    std::array<NumberEdit*, 3> scale_;
    NumberEdit* lens_factor_;
    QPushButton* lens_at_pick_;
    QComboBox *where_, *source_, *mean_;
    QPushButton* side_by_side_;
    QSpinBox* count_;
    NumberEdit *ball_scale_, *compress_;
    QCheckBox *axes_, *scale_bar_, *legend_;
};

} // namespace ameco::gui
