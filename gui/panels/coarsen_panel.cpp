// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/coarsen_panel.h"

#include "core/base/text.h"
#include "core/coarsen/target_ratio.h"
#include "core/hierarchy/settings.h"
#include "gui/model/case_level.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ameco::gui {
namespace {

constexpr int number_decimals = 4;
constexpr double smallest_step = 1e-4; ///< with those decimals
constexpr double largest_number = 1e6;

double number_of(const std::string& word) {
    double value = 0;
    std::from_chars(word.data(), word.data() + word.size(), value);
    return value;
}

QString time_text(double seconds) {
    const int s = static_cast<int>(std::lround(seconds));
    return s < 60 ? QStringLiteral("%1 s").arg(s)
                  : QStringLiteral("%1 min %2 s").arg(s / 60).arg(s % 60);
}

/// Shows no zeros that say nothing.
class NumberBox : public QDoubleSpinBox {
public:
    [[nodiscard]] QString textFromValue(double value) const override {
        return QLocale::c().toString(value, 'g', 8);
    }
};

QDoubleSpinBox* number_box(double low, double high) {
    auto* const box = new NumberBox;
    box->setDecimals(number_decimals);
    box->setRange(low, high);
    box->setSingleStep(high > 100 ? 0.1 : 1);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setLocale(QLocale::c());
    return box;
}

/// Settings that other widgets stand for.
bool has_own_widget(std::string_view name) {
    return name == "target-ratio";
}

} // namespace

CoarsenPanel::CoarsenPanel(QWidget* parent) : QWidget(parent) {
    base_ = new QLabel;
    prediction_ = new QLabel;
    prediction_->setTextFormat(Qt::RichText);
    prediction_->setWordWrap(true);
    prediction_->setMinimumHeight(3 * fontMetrics().height() + 4);
    prediction_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* const form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setVerticalSpacing(5);
    addFactor(*form);
    addSettings(*form);
    frozen_ = new QLabel;
    frozen_->setToolTip(tr("Choose in the column Freeze of the patches"));
    form->addRow(tr("Frozen patches"), frozen_);
    threads_ = new QSpinBox;
    threads_->setRange(0, 4096);
    threads_->setSpecialValueText(tr("all"));
    threads_->setToolTip(tr("Threads to use; the result does not depend on them"));
    form->addRow(tr("&Threads"), threads_);
    run_ = new QPushButton(tr("&Coarsen"));
    run_->setDefault(true);
    cancel_ = new QPushButton(tr("Cance&l"));
    bar_ = new QProgressBar;
    bar_->setRange(0, 1000);
    bar_->setFormat(QStringLiteral("%p %"));
    step_ = new QLabel;
    step_->setMinimumWidth(1); // long steps must not widen the dock
    auto* const buttons = new QHBoxLayout;
    buttons->addWidget(run_, 1);
    buttons->addWidget(cancel_);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 8);
    column->setSpacing(8);
    column->addWidget(base_);
    column->addLayout(form);
    column->addWidget(prediction_);
    column->addLayout(buttons);
    column->addWidget(bar_);
    column->addWidget(step_);
    column->addStretch(1);
    connect(run_, &QPushButton::clicked, this, &CoarsenPanel::runRequested);
    connect(cancel_, &QPushButton::clicked, this, &CoarsenPanel::cancelRequested);
    connect(threads_, &QSpinBox::valueChanged, this, &CoarsenPanel::threadsChanged);
    showOptions();
    showEnd();
    setLevel(nullptr);
}

void CoarsenPanel::addFactor(QFormLayout& form) {
    by_ = new QComboBox;
    by_->addItem(tr("Size factor"));
    by_->setItemData(0, tr("Coarse size over fine size"), Qt::ToolTipRole);
    by_->addItem(tr("Node ratio"));
    by_->setItemData(1, QString::fromStdString(setting("target-ratio").help), Qt::ToolTipRole);
    factor_ = number_box(1 + smallest_step, largest_factor);
    factor_->setToolTip(tr("Coarse size over fine size, or how many times fewer nodes, > 1"));
    form.addRow(by_, factor_);
    editors_["factor"] = {factor_, {}};
    connect(by_, &QComboBox::currentIndexChanged, this, &CoarsenPanel::changeFactor);
    connect(factor_, &QDoubleSpinBox::valueChanged, this, &CoarsenPanel::changeFactor);
}

void CoarsenPanel::addSettings(QFormLayout& form) {
    for (const Setting& s : settings()) {
        if (has_own_widget(s.name)) {
            continue;
        }
        const std::string name(s.name);
        Editor editor = makeEditor(name);
        editor.widget->setToolTip(QString::fromStdString(s.help));
        form.addRow(QString::fromUtf8(s.label.data(), static_cast<qsizetype>(s.label.size())),
                    editor.widget);
        editors_[name] = std::move(editor);
    }
}

CoarsenPanel::Editor CoarsenPanel::makeEditor(const std::string& name) {
    const Setting& s = setting(name);
    switch (s.kind) {
    case Setting::Kind::flag: {
        auto* const box = new QCheckBox;
        connect(box, &QCheckBox::toggled, this,
                [this, name](bool on) { change(name, on ? "1" : "0"); });
        return {box, [box](const std::string& word) { box->setChecked(word == "1"); }};
    }
    case Setting::Kind::choice: {
        auto* const box = new QComboBox;
        for (const std::string& choice : s.choices) {
            box->addItem(QString::fromStdString(choice));
        }
        connect(box, &QComboBox::currentTextChanged, this,
                [this, name](const QString& text) { change(name, text.toStdString()); });
        return {box, [box](const std::string& word) {
                    box->setCurrentText(QString::fromStdString(word));
                }};
    }
    case Setting::Kind::whole_number: {
        auto* const box = new QSpinBox;
        box->setRange(static_cast<int>(s.low), static_cast<int>(s.high));
        connect(box, &QSpinBox::valueChanged, this,
                [this, name](int value) { change(name, std::to_string(value)); });
        return {box, [box](const std::string& word) {
                    box->setValue(static_cast<int>(number_of(word)));
                }};
    }
    case Setting::Kind::number:
        break;
    }
    auto* const box =
        number_box(s.low + (s.above_low ? smallest_step : 0), std::min(s.high, largest_number));
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, name](double value) { change(name, exact_word(value)); });
    return {box, [box](const std::string& word) { box->setValue(number_of(word)); }};
}

void CoarsenPanel::change(const std::string& name, const std::string& word) {
    if (!filling_ && setting(name).accepts(word)) {
        setting(name).assign(options_, word);
        enable();
        emit optionsChanged();
    }
}

void CoarsenPanel::changeFactor() {
    if (filling_) {
        return;
    }
    const bool ratio = by_->currentIndex() == 1;
    options_.factors.clear();
    options_.target_ratio = ratio ? factor_->value() : 0;
    if (!ratio) {
        options_.coarsen.target.factor = factor_->value();
    }
    emit optionsChanged();
}

void CoarsenPanel::setOptions(const HierarchyOptions& options) {
    options_ = options;
    showOptions();
    emit optionsChanged();
}

void CoarsenPanel::showOptions() {
    filling_ = true;
    const bool ratio = options_.target_ratio > 0;
    by_->setCurrentIndex(ratio ? 1 : 0);
    factor_->setValue(ratio ? options_.target_ratio : options_.coarsen.target.factor);
    for (const auto& [name, editor] : editors_) {
        if (editor.show) {
            editor.show(setting(name).value(options_));
        }
    }
    filling_ = false;
    setFrozenPatches(options_.coarsen.features.frozen_patches);
    enable();
}

void CoarsenPanel::setFrozenPatches(const std::vector<int>& patches) {
    QStringList names;
    for (const int patch : patches) {
        names << QString::number(patch);
    }
    frozen_->setText(names.isEmpty() ? tr("none") : names.join(QStringLiteral(", ")));
    if (patches != options_.coarsen.features.frozen_patches) {
        options_.coarsen.features.frozen_patches = patches;
        emit optionsChanged();
    }
}

int CoarsenPanel::threads() const {
    return threads_->value();
}

void CoarsenPanel::setThreads(int threads) {
    threads_->setValue(threads);
}

void CoarsenPanel::setLevel(const CaseLevel* level) {
    can_coarsen_ = level != nullptr && level->statistics.elements > 0;
    finest_ = level == nullptr || level->number == 0;
    nodes_ = level != nullptr ? level->statistics.nodes : 0;
    base_->setText(!can_coarsen_ ? tr("Open a mesh to coarsen it.")
                                 : tr("From <b>level %1</b>, %2 nodes")
                                       .arg(level->number)
                                       .arg(QString::fromStdString(count_text(nodes_))));
    enable();
}

void CoarsenPanel::setPrediction(const std::optional<Prediction>& prediction) {
    if (!can_coarsen_) {
        prediction_->clear();
        return;
    }
    if (!prediction) {
        prediction_->setText(tr("Next level: working it out…"));
        return;
    }
    const auto text = [](const std::string& t) { return QString::fromStdString(t); };
    prediction_->setText(
        tr("Next level: <b>%1 nodes</b> predicted,<br>ratio <b>%2</b> with size factor %3")
            .arg(text(count_text(std::llround(prediction->nodes))),
                 text(ratio_text(static_cast<double>(nodes_) / prediction->nodes)),
                 text(number_text(prediction->factor, 4))));
}

QWidget* CoarsenPanel::editor(const std::string& name) const {
    if (name == "threads") {
        return threads_;
    }
    const auto found = editors_.find(name);
    return found != editors_.end() ? found->second.widget : nullptr;
}

QString CoarsenPanel::predictionText() const {
    return prediction_->text();
}

void CoarsenPanel::showStart(const QString& title) {
    running_ = true;
    clock_.start();
    bar_->setValue(0);
    step_->setText(title);
    enable();
}

void CoarsenPanel::showProgress(double fraction, const QString& step) {
    bar_->setValue(static_cast<int>(std::lround(1000 * fraction)));
    QString text = step;
    const double elapsed = static_cast<double>(clock_.elapsed()) / 1000;
    if (fraction > 0.03 && elapsed > 1) {
        text += tr(" · about %1 left").arg(time_text(elapsed * (1 - fraction) / fraction));
    }
    step_->setText(text);
    step_->setToolTip(text);
}

void CoarsenPanel::showEnd() {
    running_ = false;
    bar_->setValue(0);
    step_->clear();
    enable();
}

void CoarsenPanel::enable() {
    run_->setEnabled(can_coarsen_ && !running_);
    cancel_->setEnabled(running_);
    bar_->setEnabled(running_);
    bar_->setTextVisible(running_);
    // Corners and ridges are found on the finest level and carried along.
    editors_.at("ridge-angle").widget->setEnabled(finest_);
    editors_.at("gradation")
        .widget->setEnabled(options_.coarsen.target.algorithm == TargetAlgorithm::graded);
}

} // namespace ameco::gui
