// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Runs the program as a user would and collects what it says.
#pragma once

#include <nlohmann/json.hpp>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

namespace ameco::test {

struct Run {
    int code = -1; ///< exit code; -1 when it crashed or was killed
    QString out;
    QString err;

    /// For QVERIFY2.
    [[nodiscard]] QByteArray text() const {
        return QString("exit code %1\nstdout: %2\nstderr: %3").arg(code).arg(out, err).toUtf8();
    }
    [[nodiscard]] nlohmann::ordered_json json() const {
        return nlohmann::ordered_json::parse(out.toStdString());
    }
};

inline Run result_of(QProcess& process) {
    Run run;
    const bool ended = process.waitForFinished(120'000);
    run.code = ended && process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    run.out = QString::fromUtf8(process.readAllStandardOutput());
    run.err = QString::fromUtf8(process.readAllStandardError());
    return run;
}

inline QByteArray content_of(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
}

/// A folder to run the program in; it goes away with its files.
class Workspace {
public:
    [[nodiscard]] QString path(const QString& name = {}) const {
        return name.isEmpty() ? folder_.path() : folder_.filePath(name);
    }
    [[nodiscard]] QByteArray content(const QString& name) const { return content_of(path(name)); }
    void write(const QString& name, const QByteArray& bytes) const {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
            qFatal("cannot write %s", qPrintable(path(name)));
        }
    }
    /// Names of the files in a folder.
    [[nodiscard]] QStringList files(const QString& name) const {
        return QDir(path(name)).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }

    [[nodiscard]] Run ameco(const QStringList& arguments) const {
        QProcess process;
        start(process, arguments);
        return result_of(process);
    }
    void start(QProcess& process, const QStringList& arguments) const {
        process.setWorkingDirectory(path());
        process.setProcessEnvironment(environment());
        process.start(AMECO_PROGRAM, arguments);
    }
    /// Runs a line of shell; "$AMECO" is the program.
    [[nodiscard]] Run shell(const QString& line) const {
        QProcess process;
        process.setWorkingDirectory(path());
        process.setProcessEnvironment(environment());
        process.start("/bin/sh", {"-c", line});
        return result_of(process);
    }

private:
    /// Without a screen, so that no test opens a window by mistake.
    [[nodiscard]] static QProcessEnvironment environment() {
        QProcessEnvironment here = QProcessEnvironment::systemEnvironment();
        here.insert("AMECO", AMECO_PROGRAM);
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
            here.remove(name);
        }
        return here;
    }

    QTemporaryDir folder_;
};

/// Whether every file that DIR/hierarchy.json lists is there, and a valid mesh or metric. Returns
/// what is wrong, or "".
inline QString broken_part_of(const Workspace& here, const QString& folder) {
    using Json = nlohmann::ordered_json;
    const Json hierarchy = Json::parse(here.content(folder + "/hierarchy.json").toStdString());
    for (const Json& level : hierarchy.at("levels")) {
        for (const char* kind : {"mesh", "metric", "state"}) {
            if (!level.contains(kind)) {
                continue;
            }
            const QString file =
                folder + "/" + QString::fromStdString(level.at(kind).at("file").get<std::string>());
            if (!QFile::exists(here.path(file))) {
                return file + " is missing";
            }
            const Run run = kind == std::string("mesh")     ? here.ameco({"check", "-q", file})
                            : kind == std::string("metric") ? here.ameco({"info", "-q", file})
                                                            : Run{0, "", ""};
            if (run.code != 0) {
                return file + ": " + run.text();
            }
        }
    }
    return {};
}

} // namespace ameco::test
