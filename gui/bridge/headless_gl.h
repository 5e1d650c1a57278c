// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// OpenGL without a screen.
#pragma once

#include "gui/bridge/generic_window.h"

#include <vtkSmartPointer.h>

#include <memory>

namespace ameco::gui {

/// An OpenGL context from EGL that needs no display and no surface, and a VTK window in it.
class HeadlessGL {
public:
    /// \param width, height  of the window [pixels]
    /// \throws Error (not_built)  when this machine has no such OpenGL
    HeadlessGL(int width, int height);
    ~HeadlessGL();
    HeadlessGL(const HeadlessGL&) = delete;
    HeadlessGL& operator=(const HeadlessGL&) = delete;

    [[nodiscard]] GenericWindow* window() const { return window_; }

private:
    struct Context;
    std::unique_ptr<Context> context_;
    vtkSmartPointer<GenericWindow> window_;
};

} // namespace ameco::gui
