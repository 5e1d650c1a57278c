// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/view_panel.h"

#include "gui/panels/number_edit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ameco::gui {
namespace {

constexpr int slider_steps = 1000;
constexpr double largest_scale = 1e6;

QString from_view(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QFormLayout* make_form(QWidget* parent) {
    auto* const form = new QFormLayout(parent);
    form->setContentsMargins(8, 6, 8, 8);
    form->setVerticalSpacing(5);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    return form;
}

QHBoxLayout* row_of(std::initializer_list<QWidget*> widgets) {
    auto* const row = new QHBoxLayout;
    row->setSpacing(6);
    for (QWidget* const widget : widgets) {
        row->addWidget(widget, 1);
    }
    return row;
}

} // namespace

ViewPanel::ViewPanel(QWidget* parent) : QWidget(parent) {
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    addLook(*column);
    addClip(*column);
    addScale(*column);
    addEllipsoids(*column);
    addDecorations(*column);
    column->addStretch(1);
    showOptions();
}

void ViewPanel::addLook(QVBoxLayout& column) {
    auto* const box = new QGroupBox(tr("Surface"));
    QFormLayout* const form = make_form(box);
    representation_ = new QComboBox;
    representation_->addItems({tr("Surface"), tr("Surface with edges"), tr("Wireframe")});
    colour_ = new QComboBox;
    for (const ColourBy colour : all_colours) {
        colour_->addItem(from_view(title(colour)), static_cast<int>(colour));
    }
    lock_ = new QCheckBox(tr("Lock range"));
    lock_->setToolTip(tr("The same colours mean the same numbers on all levels"));
    range_low_ = new NumberEdit(-HUGE_VAL, HUGE_VAL);
    range_high_ = new NumberEdit(-HUGE_VAL, HUGE_VAL);
    form->addRow(tr("Show"), representation_);
    form->addRow(tr("Colour by"), colour_);
    form->addRow(lock_, row_of({range_low_, range_high_}));
    column.addWidget(box);
    connect(representation_, &QComboBox::currentIndexChanged, this, &ViewPanel::read);
    connect(colour_, &QComboBox::currentIndexChanged, this, [this] {
        const QSignalBlocker quiet(lock_); // another quantity has another range
        if (!filling_) {
            lock_->setChecked(false);
        }
        read();
    });
    connect(lock_, &QCheckBox::toggled, this, [this](bool locked) {
        if (locked && shown_range_ && !filling_) {
            range_low_->setValue(shown_range_->first);
            range_high_->setValue(shown_range_->second);
        }
        read();
    });
    connect(range_low_, &NumberEdit::valueChanged, this, &ViewPanel::read);
    connect(range_high_, &NumberEdit::valueChanged, this, &ViewPanel::read);
}

void ViewPanel::addClip(QVBoxLayout& column) {
    clip_ = new QGroupBox(tr("Clip plane"));
    clip_->setCheckable(true);
    QFormLayout* const form = make_form(clip_);
    const std::array<QString, 3> names{tr("&X"), tr("&Y"), tr("&Z")};
    auto* const buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    for (int axis = 0; axis < 3; ++axis) {
        auto* const button = new QPushButton(names.at(static_cast<std::size_t>(axis)));
        button->setMinimumWidth(30);
        button->setToolTip(tr("Across this axis, through the middle"));
        connect(button, &QPushButton::clicked, this, [this, axis] { clipAcross(axis); });
        buttons->addWidget(button);
        axis_buttons_.at(static_cast<std::size_t>(axis)) = button;
    }
    auto* const flip = new QPushButton(tr("&Flip"));
    flip->setToolTip(tr("Turn the plane around"));
    buttons->addWidget(flip);
    clip_slider_ = new QSlider(Qt::Horizontal);
    clip_slider_->setRange(0, slider_steps);
    clip_position_ = new NumberEdit(-HUGE_VAL, HUGE_VAL);
    clip_position_->setToolTip(tr("Distance of the plane from the origin, along its normal"));
    crinkle_ = new QCheckBox(tr("&Crinkle: whole elements"));
    other_side_ = new QCheckBox(tr("&Other side"));
    form->addRow(tr("Across"), buttons);
    auto* const place = new QHBoxLayout;
    place->addWidget(clip_slider_, 1);
    place->addWidget(clip_position_);
    form->addRow(tr("Position"), place);
    auto* const checks = new QHBoxLayout;
    checks->addWidget(crinkle_);
    checks->addWidget(other_side_);
    checks->addStretch(1);
    form->addRow(checks);
    column.addWidget(clip_);
    connect(clip_, &QGroupBox::toggled, this, &ViewPanel::read);
    connect(flip, &QPushButton::clicked, this, &ViewPanel::flipClip);
    connect(clip_slider_, &QSlider::valueChanged, this, [this](int step) {
        const auto [low, high] = clipSpan();
        moveClip(low + (high - low) * step / slider_steps);
    });
    connect(clip_position_, &NumberEdit::valueChanged, this, &ViewPanel::moveClip);
    connect(crinkle_, &QCheckBox::toggled, this, &ViewPanel::read);
    connect(other_side_, &QCheckBox::toggled, this, &ViewPanel::read);
}

void ViewPanel::addScale(QVBoxLayout& column) {
    auto* const box = new QGroupBox(tr("View scale"));
    QFormLayout* const form = make_form(box);
    for (NumberEdit*& edit : scale_) {
        edit = new NumberEdit(1 / largest_scale, largest_scale);
        edit->setMinimumWidth(56);
        connect(edit, &NumberEdit::valueChanged, this, &ViewPanel::read);
    }
    form->addRow(tr("x, y, z"), row_of({scale_[0], scale_[1], scale_[2]}));
    column.addWidget(box);
    lens_ = new QGroupBox(tr("Boundary-layer lens"));
    lens_->setCheckable(true);
    lens_->setToolTip(tr("Stretches the view along the normal of the wall at a picked place"));
    QFormLayout* const lens_form = make_form(lens_);
    lens_factor_ = new NumberEdit(1, largest_scale);
    lens_at_pick_ = new QPushButton(tr("At the &picked place"));
    lens_form->addRow(tr("Factor"), row_of({lens_factor_, lens_at_pick_}));
    column.addWidget(lens_);
    connect(lens_, &QGroupBox::toggled, this, &ViewPanel::read);
    connect(lens_factor_, &NumberEdit::valueChanged, this, &ViewPanel::read);
    connect(lens_at_pick_, &QPushButton::clicked, this, &ViewPanel::lensAtPickRequested);
}

void ViewPanel::addEllipsoids(QVBoxLayout& column) {
    auto* const box = new QGroupBox(tr("Metric ellipsoids"));
    QFormLayout* const form = make_form(box);
    where_ = new QComboBox;
    where_->addItems({tr("None"), tr("At the picked node"), tr("On the clip plane"),
                      tr("Spread over the view")});
    source_ = new QComboBox;
    source_->addItems({tr("Natural metric"), tr("Target of the next level")});
    mean_ = new QComboBox;
    for (const Mean mean : all_means) {
        mean_->addItem(from_view(name(mean)));
    }
    count_ = new QSpinBox;
    count_->setRange(1, 2000);
    ball_scale_ = new NumberEdit(1e-3, 1e3);
    ball_scale_->setToolTip(tr("Half axes over sizes; with 0.5 the balls of two nodes touch at an "
                               "edge of length 1"));
    compress_ = new NumberEdit(0.01, 1);
    compress_->setToolTip(tr("An aspect ratio AR is drawn as AR to this power; 1 is true"));
    form->addRow(tr("Where"), where_);
    form->addRow(tr("Metric"), source_);
    side_by_side_ = new QPushButton(tr("Means side by &side"));
    side_by_side_->setCheckable(true);
    side_by_side_->setToolTip(
        tr("Four views: corrected, interpolation, log-Euclidean and geodesic mean"));
    connect(side_by_side_, &QPushButton::clicked, this, &ViewPanel::meansSideBySideRequested);
    form->addRow(tr("Mean"), mean_);
    form->addRow(QString(), side_by_side_);
    form->addRow(tr("At most"), count_);
    form->addRow(tr("Size"), ball_scale_);
    form->addRow(tr("AR power"), compress_);
    column.addWidget(box);
    for (QComboBox* const each : {where_, source_, mean_}) {
        connect(each, &QComboBox::currentIndexChanged, this, &ViewPanel::read);
    }
    connect(count_, &QSpinBox::valueChanged, this, &ViewPanel::read);
    connect(ball_scale_, &NumberEdit::valueChanged, this, &ViewPanel::read);
    connect(compress_, &NumberEdit::valueChanged, this, &ViewPanel::read);
}

void ViewPanel::addDecorations(QVBoxLayout& column) {
    axes_ = new QCheckBox(tr("A&xes"));
    scale_bar_ = new QCheckBox(tr("&Scale bar"));
    legend_ = new QCheckBox(tr("Le&gend"));
    auto* const row = new QHBoxLayout;
    for (QCheckBox* const box : {axes_, scale_bar_, legend_}) {
        row->addWidget(box);
        connect(box, &QCheckBox::toggled, this, &ViewPanel::read);
    }
    row->addStretch(1);
    column.addLayout(row);
}

void ViewPanel::read() {
    if (filling_) {
        return;
    }
    SceneOptions o = options_;
    o.representation =
        all_representations.at(static_cast<std::size_t>(representation_->currentIndex()));
    o.colour = static_cast<ColourBy>(colour_->currentData().toInt());
    o.range.reset();
    if (lock_->isChecked() && range_low_->value() < range_high_->value()) {
        o.range = std::pair(range_low_->value(), range_high_->value());
    }
    o.clip.enabled = clip_->isChecked();
    o.clip.crinkle = crinkle_->isChecked();
    o.clip.keep_other_side = other_side_->isChecked();
    for (int i = 0; i < 3; ++i) {
        o.view_scale[i] = scale_.at(static_cast<std::size_t>(i))->value();
    }
    o.lens.enabled = lens_->isChecked();
    o.lens.factor = lens_factor_->value();
    o.ellipsoids.where = static_cast<EllipsoidOptions::Where>(where_->currentIndex());
    o.ellipsoids.source = static_cast<EllipsoidSource>(source_->currentIndex());
    o.ellipsoids.mean = all_means.at(static_cast<std::size_t>(mean_->currentIndex()));
    o.ellipsoids.max_count = static_cast<std::size_t>(count_->value());
    o.ellipsoids.scale = ball_scale_->value();
    o.ellipsoids.compress = compress_->value();
    o.axes = axes_->isChecked();
    o.scale_bar = scale_bar_->isChecked();
    o.legend = legend_->isChecked();
    options_ = o;
    showOptions();
    emit optionsChanged(options_);
}

void ViewPanel::setOptions(const SceneOptions& options) {
    options_ = options;
    showOptions();
}

void ViewPanel::showOptions() {
    filling_ = true;
    const SceneOptions& o = options_;
    representation_->setCurrentIndex(static_cast<int>(o.representation));
    colour_->setCurrentIndex(colour_->findData(static_cast<int>(o.colour)));
    lock_->setChecked(lock_->isChecked() || o.range.has_value());
    if (o.range) {
        range_low_->setValue(o.range->first);
        range_high_->setValue(o.range->second);
    }
    range_low_->setEnabled(lock_->isChecked());
    range_high_->setEnabled(lock_->isChecked());
    clip_->setChecked(o.clip.enabled);
    crinkle_->setChecked(o.clip.crinkle);
    other_side_->setChecked(o.clip.keep_other_side);
    const auto [low, high] = clipSpan();
    clip_position_->setValue(clipPosition());
    clip_slider_->setValue(static_cast<int>(
        std::lround(slider_steps * (clipPosition() - low) / std::max(high - low, 1e-300))));
    for (int i = 0; i < 3; ++i) {
        scale_.at(static_cast<std::size_t>(i))->setValue(o.view_scale[i]);
    }
    lens_->setChecked(o.lens.enabled);
    lens_factor_->setValue(o.lens.factor);
    where_->setCurrentIndex(static_cast<int>(o.ellipsoids.where));
    source_->setCurrentIndex(static_cast<int>(o.ellipsoids.source));
    mean_->setCurrentText(from_view(name(o.ellipsoids.mean)));
    count_->setValue(static_cast<int>(o.ellipsoids.max_count));
    ball_scale_->setValue(o.ellipsoids.scale);
    compress_->setValue(o.ellipsoids.compress);
    const bool any = o.ellipsoids.where != EllipsoidOptions::Where::none;
    for (QWidget* const each :
         std::initializer_list<QWidget*>{source_, mean_, count_, ball_scale_, compress_}) {
        each->setEnabled(any);
    }
    axes_->setChecked(o.axes);
    scale_bar_->setChecked(o.scale_bar);
    legend_->setChecked(o.legend);
    filling_ = false;
}

void ViewPanel::setBounds(const Vec3& low, const Vec3& high) {
    low_ = low;
    high_ = high;
    showOptions();
}

void ViewPanel::setShownRange(const std::optional<std::pair<double, double>>& range) {
    shown_range_ = range;
    lock_->setEnabled(range.has_value());
    if (range && !lock_->isChecked()) {
        range_low_->setValue(range->first);
        range_high_->setValue(range->second);
    }
}

void ViewPanel::setMeansSideBySide(bool on) {
    side_by_side_->setChecked(on);
    mean_->setEnabled(!on && options_.ellipsoids.where != EllipsoidOptions::Where::none);
}

void ViewPanel::setPickKnown(bool known) {
    lens_at_pick_->setEnabled(known);
}

void ViewPanel::clipAcross(int axis) {
    options_.clip.enabled = true;
    options_.clip.origin = (low_ + high_) / 2;
    options_.clip.normal = Vec3::Unit(axis);
    showOptions();
    emit optionsChanged(options_);
}

void ViewPanel::flipClip() {
    options_.clip.normal = -options_.clip.normal;
    showOptions();
    emit optionsChanged(options_);
}

double ViewPanel::clipPosition() const {
    return options_.clip.origin.dot(options_.clip.normal.normalized());
}

void ViewPanel::moveClip(double position) {
    if (filling_) {
        return;
    }
    options_.clip.origin += (position - clipPosition()) * options_.clip.normal.normalized();
    showOptions();
    emit optionsChanged(options_);
}

/// Smallest and largest distance of the box's corners along the normal.
std::pair<double, double> ViewPanel::clipSpan() const {
    const Vec3 n = options_.clip.normal.normalized();
    const Vec3 a = low_.cwiseProduct(n);
    const Vec3 b = high_.cwiseProduct(n);
    return {a.cwiseMin(b).sum(), a.cwiseMax(b).sum()};
}

} // namespace ameco::gui
