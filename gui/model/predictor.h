// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The next level's size and histogram, worked out while the user turns the knobs.
#pragma once

#include "core/coarsen/prediction.h"
#include "gui/jobs/job_runner.h"
#include "gui/model/case_level.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace ameco::gui {

/// Predicts in a worker of its own; what is asked for later replaces what is being worked on.
class Predictor : public QObject {
    Q_OBJECT
public:
    explicit Predictor(QObject* parent = nullptr);

    /// \param level  to be coarsened; null: nothing to predict
    void request(const CaseLevel* level, const HierarchyOptions& options, double max_aspect_ratio);
    [[nodiscard]] const std::optional<Prediction>& prediction() const { return prediction_; }

signals:
    void changed(); ///< there is another prediction, or none

private:
    struct Fields { ///< natural metrics with another mean than the level's, kept
        int level = -1;
        Mean mean = Mean::blended;
        std::variant<MetricField<3>, MetricField<2>> natural;
    };
    void start();

    JobRunner jobs_;
    QTimer delay_;
    std::optional<CaseLevel> level_;
    HierarchyOptions options_;
    double max_aspect_ratio_ = 1;
    std::shared_ptr<const Fields> fields_;
    std::optional<Prediction> prediction_;
};

} // namespace ameco::gui
