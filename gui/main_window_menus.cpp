// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/error.h"
#include "core/io/format.h"
#include "gui/dialogs/about_dialog.h"
#include "gui/dialogs/shortcuts_dialog.h"
#include "gui/main_window.h"
#include "gui/panels/coarsen_panel.h"
#include "gui/panels/command_panel.h"
#include "gui/panels/hierarchy_panel.h"
#include "gui/panels/inspector_panel.h"
#include "gui/panels/view_panel.h"
#include "gui/view/compare_view.h"
#include "gui/view_controller.h"

#include <QActionGroup>
#include <QCheckBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QGroupBox>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>

namespace ameco::gui {
namespace {

constexpr int most_recent = 10;
const QString recent_key = QStringLiteral("recent");

/// "All meshes (*.mesh *.meshb ...);;Medit (*.mesh);;..." of what can be read or written.
QString mesh_filters(bool to_write) {
    QStringList all, single;
    for (const Format& format : formats()) {
        const bool fits = to_write ? format.write_3d != nullptr : format.read != nullptr;
        if (!fits || format.is_metric()) {
            continue;
        }
        QStringList patterns;
        for (const std::string_view suffix : format.suffixes) {
            patterns << QStringLiteral("*%1").arg(
                QString::fromUtf8(suffix.data(), static_cast<qsizetype>(suffix.size())));
        }
        all << patterns;
        single << QStringLiteral("%1 (%2)").arg(
            QString::fromUtf8(format.title.data(), static_cast<qsizetype>(format.title.size()))
                .remove(QLatin1Char('('))
                .remove(QLatin1Char(')')),
            patterns.join(QLatin1Char(' ')));
    }
    all.removeDuplicates();
    return to_write ? single.join(QStringLiteral(";;"))
                    : QObject::tr("All meshes (%1)").arg(all.join(QLatin1Char(' '))) +
                          QStringLiteral(";;") + single.join(QStringLiteral(";;")) +
                          QObject::tr(";;All files (*)");
}

/// A dialog that does not block the window.
QFileDialog* file_dialog(QWidget* parent, const QString& title, const QString& filters,
                         QFileDialog::AcceptMode mode, QFileDialog::FileMode files) {
    auto* const dialog = new QFileDialog(parent, title, QString(), filters);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(mode);
    dialog->setFileMode(files);
    return dialog;
}

} // namespace

QAction* MainWindow::addAction(QMenu& menu, const QString& text, const QKeySequence& shortcut,
                               std::function<void()> action) {
    QAction* const entry = menu.addAction(text);
    entry->setShortcut(shortcut);
    connect(entry, &QAction::triggered, this, std::move(action));
    return entry;
}

void MainWindow::makeMenus() {
    makeFileMenu();
    makeViewMenu();
    makeLevelMenu();
    makeHelpMenu();
}

void MainWindow::makeFileMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&File"));
    addAction(menu, tr("&Open mesh…"), QKeySequence::Open, [this] { chooseMesh(); });
    addAction(menu, tr("Open &hierarchy…"), tr("Ctrl+Shift+O"), [this] { chooseHierarchy(); });
    addAction(menu, tr("Open se&ssion…"), tr("Ctrl+Alt+O"), [this] { chooseSession(); });
    recent_ = menu.addMenu(tr("Open &recent"));
    connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
    menu.addSeparator();
    needs_case_ = {
        addAction(menu, tr("&Save session…"), QKeySequence::Save,
                  [this] {
                      if (!session_path_.isEmpty()) {
                          saveSessionTo(session_path_);
                          return;
                      }
                      auto* const dialog =
                          file_dialog(this, tr("Save the session"), tr("Session (*.ameco)"),
                                      QFileDialog::AcceptSave, QFileDialog::AnyFile);
                      dialog->setDefaultSuffix(QStringLiteral("ameco"));
                      connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::saveSessionTo);
                      dialog->open();
                  }),
        addAction(menu, tr("Save &levels as hierarchy…"), tr("Ctrl+Shift+S"),
                  [this] { chooseFolderForLevels(); }),
        addAction(menu, tr("&Export level as mesh…"), tr("Ctrl+E"), [this] { chooseMeshFile(); })};
    QMenu* const pictures = menu.addMenu(tr("S&creenshot"));
    for (const int factor : {1, 2, 4}) {
        addAction(*pictures, tr("Size ×&%1…").arg(factor),
                  factor == 1 ? QKeySequence(tr("Ctrl+P")) : QKeySequence(),
                  [this, factor] { chooseScreenshot(factor, false); });
    }
    addAction(*pictures, tr("Size ×2, &transparent…"), {}, [this] { chooseScreenshot(2, true); });
    menu.addSeparator();
    needs_case_.push_back(
        addAction(menu, tr("&Close"), QKeySequence::Close, [this] { document_.close(); }));
    addAction(menu, tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::makeViewMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&View"));
    view_counts_ = new QActionGroup(this);
    for (const int count : {1, 2, 4}) {
        QAction* const entry =
            addAction(menu, count == 1 ? tr("&1 view") : tr("&%1 views").arg(count),
                      QKeySequence(QStringLiteral("Ctrl+%1").arg(count)),
                      [this, count] { setViewCount(count); });
        entry->setCheckable(true);
        entry->setChecked(count == 1);
        entry->setData(count);
        view_counts_->addAction(entry);
    }
    QAction* const linked = menu.addAction(tr("&Linked cameras"));
    linked->setCheckable(true);
    linked->setChecked(true);
    linked->setShortcut(tr("Ctrl+L"));
    connect(linked, &QAction::toggled, views_, &CompareView::setLinked);
    addCameraActions(menu);
    addLookActions(menu);
    menu.addSeparator();
    dark_action_ = menu.addAction(tr("&Dark colours"));
    dark_action_->setCheckable(true);
    dark_action_->setShortcut(tr("Ctrl+D"));
    connect(dark_action_, &QAction::triggered, this, &MainWindow::setDark);
    panels_menu_ = menu.addMenu(tr("&Panels"));
    int number = 1;
    for (auto* const dock : findChildren<QDockWidget*>()) {
        QAction* const raise = panels_menu_->addAction(dock->windowTitle());
        raise->setShortcut(number < 10 ? QKeySequence(QStringLiteral("Alt+%1").arg(number))
                                       : QKeySequence());
        ++number;
        connect(raise, &QAction::triggered, dock, [this, dock] {
            raisePanel(*dock->widget());
            dock->widget()->setFocus();
        });
    }
}

void MainWindow::addCameraActions(QMenu& menu) {
    menu.addSeparator();
    addAction(menu, tr("&Fit"), tr("F"), [this] { views_->resetCamera(); });
    const std::array<std::pair<StandardView, const char*>, 7> standard{
        {{StandardView::plus_x, "X"},
         {StandardView::minus_x, "Shift+X"},
         {StandardView::plus_y, "Y"},
         {StandardView::minus_y, "Shift+Y"},
         {StandardView::plus_z, "Z"},
         {StandardView::minus_z, "Shift+Z"},
         {StandardView::corner, "I"}}};
    QMenu* const directions = menu.addMenu(tr("Look &from"));
    for (const auto& [view, key] : standard) {
        const std::string_view word = name(view);
        addAction(
            *directions,
            tr("From %1").arg(QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()))),
            QKeySequence(QLatin1String(key)), [this, view = view] { views_->standardView(view); });
    }
    addAction(menu, tr("At the picked &node"), tr("P"), [this] { controller_->lookAtPicked(); });
}

void MainWindow::addLookActions(QMenu& menu) {
    menu.addSeparator();
    const auto show_as = [this](Representation representation) {
        SceneOptions options = controller_->options();
        options.representation = representation;
        changeScene(options);
    };
    QMenu* const looks = menu.addMenu(tr("&Surface"));
    addAction(*looks, tr("&Surface"), tr("S"), [=] { show_as(Representation::surface); });
    addAction(*looks, tr("Surface with &edges"), tr("E"),
              [=] { show_as(Representation::surface_with_edges); });
    addAction(*looks, tr("&Wireframe"), tr("W"), [=] { show_as(Representation::wireframe); });
    addAction(menu, tr("&Clip plane"), tr("C"),
              [this] { view_panel_->clipBox().setChecked(!view_panel_->clipBox().isChecked()); });
    addAction(menu, tr("&Flip the clip plane"), tr("Shift+C"), [this] { view_panel_->flipClip(); });
    addAction(menu, tr("Boundary-layer lens at the picked &place"), tr("B"),
              [this] { emit view_panel_->lensAtPickRequested(); });
}

void MainWindow::makeLevelMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Levels"));
    needs_case_.push_back(addAction(menu, tr("&Coarsen"), tr("Ctrl+R"), [this] {
        if (coarsen_->runButton().isEnabled()) {
            run();
        }
    }));
    addAction(menu, tr("C&ancel"), tr("Ctrl+."), [this] { jobs_.cancel(); });
    menu.addSeparator();
    addAction(menu, tr("&Finer level"), tr("PgUp"), [this] { stepLevel(-1); });
    addAction(menu, tr("C&oarser level"), tr("PgDown"), [this] { stepLevel(1); });
    addAction(menu, tr("&Delete level"), tr("Ctrl+Backspace"),
              [this] { hierarchy_->removeCurrent(); });
    menu.addSeparator();
    addAction(menu, tr("&Go to node…"), tr("Ctrl+G"), [this] {
        raisePanel(*inspector_);
        inspector_->focusId();
    });
    addAction(menu, tr("Copy the &node"), tr("Ctrl+Shift+C"), [this] { inspector_->copy(); });
    addAction(menu, tr("Copy the co&mmand"), tr("Ctrl+Alt+C"), [this] { command_->copy(); });
}

void MainWindow::makeHelpMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Help"));
    addAction(menu, tr("&Shortcuts"), QKeySequence::HelpContents,
              [this] { (new ShortcutsDialog(*menuBar(), this))->show(); });
    addAction(menu, tr("&About ameco"), {}, [this] { (new AboutDialog(this))->show(); });
}

void MainWindow::chooseMesh() {
    auto* const dialog = file_dialog(this, tr("Open a mesh"), mesh_filters(false),
                                     QFileDialog::AcceptOpen, QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openPath);
    dialog->open();
}

void MainWindow::chooseHierarchy() {
    auto* const dialog = file_dialog(this, tr("Open a hierarchy's folder"), {},
                                     QFileDialog::AcceptOpen, QFileDialog::Directory);
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openPath);
    dialog->open();
}

void MainWindow::chooseSession() {
    auto* const dialog = file_dialog(this, tr("Open a session"), tr("Session (*.ameco)"),
                                     QFileDialog::AcceptOpen, QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openPath);
    dialog->open();
}

void MainWindow::chooseFolderForLevels() {
    auto* const dialog = file_dialog(this, tr("An empty folder for the levels"), {},
                                     QFileDialog::AcceptSave, QFileDialog::Directory);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
        const Branch branch = document_.currentBranch();
        document_.exportBranch(branch.empty() ? -1 : branch.back()->id, folder);
    });
    dialog->open();
}

void MainWindow::chooseMeshFile() {
    auto* const dialog = file_dialog(this, tr("Export the level"), mesh_filters(true),
                                     QFileDialog::AcceptSave, QFileDialog::AnyFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        if (document_.current() != nullptr) {
            document_.exportMesh(document_.current()->id, path);
        }
    });
    dialog->open();
}

void MainWindow::chooseScreenshot(int factor, bool transparent) {
    auto* const dialog = file_dialog(this, tr("Save the picture"), tr("PNG (*.png)"),
                                     QFileDialog::AcceptSave, QFileDialog::AnyFile);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, factor, transparent](const QString& path) {
                saveScreenshot(path, factor, transparent);
            });
    dialog->open();
}

void MainWindow::saveScreenshot(const QString& path, int factor, bool transparent) {
    const QImage image = views_->grabImage(factor, transparent);
    if (image.isNull()) {
        tell(Severity::error, tr("%1: no picture: there is no OpenGL here").arg(path));
    } else if (!image.save(path)) {
        tell(Severity::error, tr("%1: cannot be written").arg(path));
    } else {
        tell(Severity::info, tr("written: %1").arg(path));
    }
}

void MainWindow::setViewCount(int count) {
    controller_->setViewCount(count);
}

void MainWindow::checkViewCount() {
    for (QAction* const action : view_counts_->actions()) {
        action->setChecked(action->data().toInt() == views_->viewCount());
    }
}

void MainWindow::stepLevel(int step) {
    const Branch branch = document_.currentBranch();
    for (std::size_t k = 0; k < branch.size(); ++k) {
        const int next = static_cast<int>(k) + step;
        if (branch[k] == document_.current() && next >= 0 &&
            next < static_cast<int>(branch.size())) {
            document_.setCurrent(branch[static_cast<std::size_t>(next)]->id);
            return;
        }
    }
}

void MainWindow::remember(const QString& path) {
    QSettings store;
    QStringList paths = store.value(recent_key).toStringList();
    paths.removeAll(path);
    paths.prepend(path);
    store.setValue(recent_key, paths.mid(0, most_recent));
}

void MainWindow::fillRecent() {
    recent_->clear();
    const QStringList paths = QSettings().value(recent_key).toStringList();
    for (const QString& path : paths) {
        recent_->addAction(path, this, [this, path] { openPath(path); })
            ->setEnabled(QFileInfo::exists(path));
    }
    if (paths.isEmpty()) {
        recent_->addAction(tr("nothing yet"))->setEnabled(false);
    }
}

} // namespace ameco::gui
