// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/overlay.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <numbers>

namespace ameco::gui {
namespace {

constexpr int points_per_inch = 72; ///< font sizes are pixels then

void set_font(vtkTextProperty* property, double size, bool bold) {
    property->SetFontFamilyToArial();
    property->SetFontSize(std::max(1, static_cast<int>(std::lround(size))));
    property->SetBold(bold ? 1 : 0);
}

} // namespace

void Overlay::show_in(vtkRenderer* renderer) {
    renderer_ = renderer;
    mapper_->SetInputData(shapes_);
    actor_->SetMapper(mapper_);
    renderer_->AddActor2D(actor_);
}

void Overlay::clear() {
    points_.clear();
    polygons_.clear();
    colours_.clear();
    texts_used_ = 0;
}

void Overlay::polygon(const std::vector<std::array<double, 2>>& corners, const Rgb& colour,
                      double opacity) {
    std::vector<std::int32_t> ids;
    for (const auto& corner : corners) {
        ids.push_back(static_cast<std::int32_t>(points_.size()));
        points_.push_back(corner);
    }
    polygons_.push_back(std::move(ids));
    const auto alpha = static_cast<unsigned char>(std::lround(255 * opacity));
    colours_.push_back({colour[0], colour[1], colour[2], alpha});
}

void Overlay::fill(double x0, double y0, double x1, double y1, const Rgb& colour, double opacity) {
    polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, colour, opacity);
}

void Overlay::line(double x0, double y0, double x1, double y1, double width, const Rgb& colour) {
    const double length = std::hypot(x1 - x0, y1 - y0);
    if (!(length > 0)) {
        return;
    }
    const double nx = -(y1 - y0) / length * width / 2;
    const double ny = (x1 - x0) / length * width / 2;
    polygon({{x0 + nx, y0 + ny}, {x0 - nx, y0 - ny}, {x1 - nx, y1 - ny}, {x1 + nx, y1 + ny}},
            colour);
}

void Overlay::disc(double x, double y, double radius, const Rgb& colour, double opacity) {
    std::vector<std::array<double, 2>> corners;
    constexpr int pieces = 48;
    for (int k = 0; k < pieces; ++k) {
        const double angle = 2 * std::numbers::pi * k / pieces;
        corners.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
    }
    polygon(corners, colour, opacity);
}

void Overlay::circle(double x, double y, double radius, double width, const Rgb& colour) {
    constexpr int pieces = 32;
    for (int k = 0; k < pieces; ++k) {
        const double a = 2 * std::numbers::pi * k / pieces;
        const double b = 2 * std::numbers::pi * (k + 1) / pieces;
        line(x + radius * std::cos(a), y + radius * std::sin(a), x + radius * std::cos(b),
             y + radius * std::sin(b), width, colour);
    }
}

void Overlay::text(double x, double y, const std::string& text, double size, const Rgb& colour,
                   Align align, bool bold) {
    if (texts_used_ == texts_.size()) {
        texts_.push_back(vtkSmartPointer<vtkTextActor>::New());
        texts_.back()->SetTextScaleModeToNone();
        renderer_->AddActor2D(texts_.back());
    }
    vtkTextActor* const actor = texts_[texts_used_++];
    actor->SetInput(text.c_str());
    actor->SetPosition(std::round(x), std::round(y));
    vtkTextProperty* const property = actor->GetTextProperty();
    set_font(property, size, bold);
    property->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
    property->SetVerticalJustificationToCentered();
    align == Align::left     ? property->SetJustificationToLeft()
    : align == Align::centre ? property->SetJustificationToCentered()
                             : property->SetJustificationToRight();
    actor->SetVisibility(1);
}

void Overlay::finish() {
    for (std::size_t k = texts_used_; k < texts_.size(); ++k) {
        texts_[k]->SetVisibility(0);
    }
    vtkNew<vtkPoints> points;
    for (const auto& [x, y] : points_) {
        points->InsertNextPoint(x, y, 0);
    }
    vtkNew<vtkCellArray> cells;
    for (const auto& ids : polygons_) {
        cells->InsertNextCell(static_cast<int>(ids.size()));
        for (const std::int32_t id : ids) {
            cells->InsertCellPoint(id);
        }
    }
    shapes_->SetPoints(points);
    shapes_->SetPolys(cells);
    shapes_->GetCellData()->SetScalars(to_vtk(colours_));
    actor_->SetVisibility(polygons_.empty() ? 0 : 1);
}

double Overlay::width_of(const std::string& text, double size, bool bold) {
    vtkTextRenderer* const renderer = vtkTextRenderer::GetInstance();
    if (renderer == nullptr) {
        return 0;
    }
    vtkNew<vtkTextProperty> property;
    set_font(property, size, bold);
    int box[4] = {0, 0, 0, 0};
    renderer->GetBoundingBox(property, text, box, points_per_inch);
    return box[1] - box[0] + 1;
}

} // namespace ameco::gui
