// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/bridge/generic_window.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>
#include <vtkUnsignedCharArray.h>
#include <vtk_glew.h>

#include <algorithm>

namespace ameco::gui {

vtkStandardNewMacro(GenericWindow);

void GenericWindow::OpenGLInitContext() {
    this->ContextCreationTime.Modified();
    if (this->Initialized) {
        return;
    }
    glewExperimental = GL_TRUE;
    const GLenum result = glewInit();
    if (result != GLEW_OK && result != GLEW_ERROR_NO_GLX_DISPLAY) {
        vtkErrorMacro("OpenGL's functions cannot be found");
        return;
    }
    if (!GLEW_VERSION_3_2) {
        vtkErrorMacro("OpenGL 3.2 is needed");
        return;
    }
    this->Initialized = true;
    this->MaximumHardwareLineWidth = 1;
}

int GenericWindow::GetColorBufferSizes(int* rgba) {
    if (rgba == nullptr) {
        return 0;
    }
    std::fill(rgba, rgba + 4, 8);
    return 8;
}

void GenericWindow::drawOffSide() {
    SetReadyForRendering(false);
    SetFrameBlitModeToNoBlit();
    SetOwnContext(0);
    SetMultiSamples(smooth_samples);
    SetSupportsOpenGL(1);
    SetIsDirect(1);
    SetAlphaBitPlanes(1);
}

void GenericWindow::start() {
    SetForceMaximumHardwareLineWidth(1);
    SetReadyForRendering(true);
    OpenGLInitContext();
    GetState()->Reset();
    GetState()->vtkglDepthFunc(GL_LEQUAL);
}

void GenericWindow::copyTo(unsigned int framebuffer) {
    vtkOpenGLState* const state = GetState();
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    BlitDisplayFramebuffer();
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    state->vtkglClearColor(0, 0, 0, 1);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

GenericWindow::StateGuard::StateGuard(GenericWindow& window) : window_(window) {
    window_.GetState()->Reset();
    window_.GetState()->Push();
    window_.GetState()->vtkglDepthFunc(GL_LEQUAL);
}

GenericWindow::StateGuard::~StateGuard() {
    window_.GetState()->Pop();
}

std::vector<unsigned char> GenericWindow::readPixels(bool opaque) {
    const int width = GetSize()[0];
    const int height = GetSize()[1];
    vtkNew<vtkUnsignedCharArray> bottom_up;
    GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, bottom_up);
    const auto row = static_cast<std::size_t>(width) * 4;
    std::vector<unsigned char> pixels(row * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const unsigned char* from =
            bottom_up->GetPointer(static_cast<vtkIdType>(row) * (height - 1 - y));
        std::copy(from, from + row, pixels.begin() + static_cast<std::ptrdiff_t>(row) * y);
    }
    for (std::size_t alpha = 3; opaque && alpha < pixels.size(); alpha += 4) {
        pixels[alpha] = 255;
    }
    return pixels;
}

} // namespace ameco::gui
