// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Flat drawing over a picture: legends, scale bars, labels.
#pragma once

#include "gui/scene/colour_map.h"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <string>
#include <vector>

class vtkRenderer;

namespace ameco::gui {

enum class Align { left, centre, right };

/// Drawn anew for each picture: clear, draw, finish. Coordinates are device pixels of the
/// renderer's viewport, y upwards.
class Overlay {
public:
    void show_in(vtkRenderer* renderer);

    void clear();
    /// \param opacity  in [0, 1]
    void fill(double x0, double y0, double x1, double y1, const Rgb& colour, double opacity = 1);
    void polygon(const std::vector<std::array<double, 2>>& corners, const Rgb& colour,
                 double opacity = 1);
    void line(double x0, double y0, double x1, double y1, double width, const Rgb& colour);
    void disc(double x, double y, double radius, const Rgb& colour, double opacity = 1);
    void circle(double x, double y, double radius, double width, const Rgb& colour);
    /// \param y  middle of the text's height
    void text(double x, double y, const std::string& text, double size, const Rgb& colour,
              Align align = Align::left, bool bold = false);
    void finish();

    /// Width of a text [device pixels].
    [[nodiscard]] static double width_of(const std::string& text, double size, bool bold = false);

private:
    vtkRenderer* renderer_ = nullptr;
    vtkNew<vtkPolyData> shapes_;
    vtkNew<vtkPolyDataMapper2D> mapper_;
    vtkNew<vtkActor2D> actor_;
    std::vector<std::array<double, 2>> points_;
    std::vector<std::vector<std::int32_t>> polygons_;
    std::vector<Rgba> colours_;
    std::vector<vtkSmartPointer<vtkTextActor>> texts_;
    std::size_t texts_used_ = 0;
};

} // namespace ameco::gui
