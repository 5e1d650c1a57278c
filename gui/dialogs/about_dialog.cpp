// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/dialogs/about_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>

#include <vtkVersion.h>

namespace ameco::gui {

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("About ameco"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* const text = new QLabel(
        tr("<h2>ameco %1</h2>"
           "<p>Anisotropic mesh coarsener: from one mesh with boundary layers to the<br>"
           "sequence of coarser meshes that geometric multigrid needs.</p>"
           "<p>Free software under the GNU Affero General Public License,<br>"
           "version 3 or later. It comes without any warranty.</p>"
           "<p>Made with Qt %2, VTK %3, Eigen, CGAL, oneTBB, CLI11 and<br>nlohmann-json.</p>")
            .arg(QLatin1String(AMECO_VERSION), QLatin1String(qVersion()),
                 QLatin1String(vtkVersion::GetVTKVersion())));
    text->setTextInteractionFlags(Qt::TextBrowserInteraction);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(24, 12, 24, 16);
    column->setSpacing(12);
    column->addWidget(text);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

} // namespace ameco::gui
