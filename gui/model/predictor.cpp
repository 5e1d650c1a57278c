// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/model/predictor.h"

#include "core/hierarchy/settings.h"
#include "core/metric/nodal_metric.h"

#include <algorithm>
#include <utility>

namespace ameco::gui {
namespace {

/// Knobs are turned in many small steps; the work waits for a pause [ms].
constexpr int pause = 120;

/// The factor of the next level.
TargetOptions next_target(const CaseLevel& level, const HierarchyOptions& options) {
    TargetOptions target = options.coarsen.target;
    if (!options.factors.empty()) {
        const auto next = static_cast<std::size_t>(level.number);
        target.factor = options.factors[std::min(next, options.factors.size() - 1)];
    }
    return target;
}

} // namespace

Predictor::Predictor(QObject* parent) : QObject(parent) {
    delay_.setSingleShot(true);
    delay_.setInterval(pause);
    connect(&delay_, &QTimer::timeout, this, &Predictor::start);
}

void Predictor::request(const CaseLevel* level, const HierarchyOptions& options,
                        double max_aspect_ratio) {
    jobs_.cancel();
    const bool can = level != nullptr && level->statistics.elements > 0;
    const bool same_level = can && level_ && level_->id == level->id;
    level_ = can ? std::optional(*level) : std::nullopt;
    options_ = options;
    max_aspect_ratio_ = max_aspect_ratio;
    if (!same_level) {
        fields_.reset();
        prediction_.reset();
        emit changed();
    }
    can ? delay_.start() : delay_.stop();
}

void Predictor::start() {
    if (!level_) {
        return;
    }
    jobs_.start(tr("Predicting"), [this, level = *level_, options = options_, fields = fields_,
                                   max = max_aspect_ratio_](JobContext& job) {
        std::visit(
            [&]<int D>(const Level<D>& l) {
                const Mean mean = options.coarsen.mean;
                std::shared_ptr<const Fields> natural = fields;
                if (mean != level.options.coarsen.mean &&
                    (natural == nullptr || natural->mean != mean)) {
                    natural = std::make_shared<const Fields>(
                        Fields{level.id, mean, nodal_metric(l.mesh, mean, job)});
                }
                const bool own = mean == level.options.coarsen.mean;
                const MetricField<D>& field =
                    own ? l.natural : std::get<MetricField<D>>(natural->natural);
                const Prediction result =
                    predict(l.mesh, field, next_target(level, options), options.target_ratio, max);
                job.post([this, result, natural] {
                    fields_ = natural;
                    prediction_ = result;
                    emit changed();
                });
            },
            *level.level);
    });
}

} // namespace ameco::gui
