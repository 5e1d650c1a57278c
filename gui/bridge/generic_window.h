// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A VTK render window in an OpenGL context that somebody else made: Qt, or EGL without a screen.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

#include <vector>

namespace ameco::gui {

/// Samples per pixel of a still picture; while the mouse drags there is one, which takes a third of
/// the time in software.
inline constexpr int smooth_samples = 4;

class GenericWindow : public vtkGenericOpenGLRenderWindow {
public:
    static GenericWindow* New();
    vtkTypeMacro(GenericWindow, vtkGenericOpenGLRenderWindow)

        /// Debian's GLEW is built for GLX: under EGL it says that there is no GLX display although
        /// it has found all functions. That is no failure here.
        void OpenGLInitContext() override;
    /// A context without a surface has no colour buffer to ask; VTK renders into its own of 8 bits.
    int GetColorBufferSizes(int* rgba) override;

    /// Settings that make VTK draw into its own framebuffer and touch nobody else's. To be called
    /// first.
    void drawOffSide();
    /// To be called when the context is there, and current.
    void start();
    /// Copies what was rendered into a framebuffer of the context, and makes that opaque.
    void copyTo(unsigned int framebuffer);

    /// RGBA, 4 bytes per pixel, rows from the top down, of what was rendered last. The context must
    /// be current. \param opaque  things one sees through leave no holes in the picture
    std::vector<unsigned char> readPixels(bool opaque);

    /// While it lives, VTK's idea of the OpenGL state is right although others have used the
    /// context; afterwards the state is theirs again.
    class StateGuard {
    public:
        explicit StateGuard(GenericWindow& window);
        ~StateGuard();
        StateGuard(const StateGuard&) = delete;
        StateGuard& operator=(const StateGuard&) = delete;

    private:
        GenericWindow& window_;
    };

protected:
    GenericWindow() = default;
    ~GenericWindow() override = default;
};

} // namespace ameco::gui
