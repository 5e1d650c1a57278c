// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How the next levels are made, what they will be like, and the button that makes them.
#pragma once

#include "core/coarsen/prediction.h"
#include "core/hierarchy/hierarchy.h"
#include "gui/jobs/job_runner.h"

#include <QElapsedTimer>
#include <QWidget>

#include <functional>
#include <map>
#include <optional>
#include <string>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace ameco::gui {

struct CaseLevel;

/// A form made from the table of settings (core/hierarchy/settings.h). Holds no algorithm.
class CoarsenPanel : public QWidget {
    Q_OBJECT
public:
    explicit CoarsenPanel(QWidget* parent = nullptr);

    [[nodiscard]] const HierarchyOptions& options() const { return options_; }
    void setOptions(const HierarchyOptions& options);
    void setFrozenPatches(const std::vector<int>& patches);
    [[nodiscard]] int threads() const;
    void setThreads(int threads);

    /// The level that would be coarsened; null: none.
    void setLevel(const CaseLevel* level);
    void setPrediction(const std::optional<Prediction>& prediction);

    /// The editor of a setting by its name, or "factor", "threads"; for tests.
    [[nodiscard]] QWidget* editor(const std::string& setting) const;
    [[nodiscard]] QPushButton& runButton() { return *run_; }
    [[nodiscard]] QPushButton& cancelButton() { return *cancel_; }
    [[nodiscard]] QString predictionText() const;

public slots:
    void showStart(const QString& title);
    void showProgress(double fraction, const QString& step);
    void showEnd();

signals:
    void optionsChanged();
    void threadsChanged(int threads);
    void runRequested();
    void cancelRequested();

private:
    struct Editor {
        QWidget* widget = nullptr;
        std::function<void(const std::string& word)> show;
    };
    void addSettings(QFormLayout& form);
    [[nodiscard]] Editor makeEditor(const std::string& setting);
    void addFactor(QFormLayout& form);
    void change(const std::string& setting, const std::string& word);
    void changeFactor();
    void showOptions();
    void enable();

    HierarchyOptions options_;
    std::map<std::string, Editor> editors_;
    QComboBox* by_;
    QDoubleSpinBox* factor_;
    QSpinBox* threads_;
    QLabel* frozen_;
    QLabel* base_;
    QLabel* prediction_;
    QPushButton* run_;
    QPushButton* cancel_;
    QProgressBar* bar_;
    QLabel* step_;
    QElapsedTimer clock_;
    bool filling_ = false;
    bool running_ = false;
    bool can_coarsen_ = false;
    bool finest_ = true;
    std::int64_t nodes_ = 0;
};

} // namespace ameco::gui
