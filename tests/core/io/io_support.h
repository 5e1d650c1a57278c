// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Temporary files, messages of exceptions, meshes with random content.
#pragma once

#include "core/io/io.h"

#include <bit>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <unistd.h>

#include <QTemporaryDir>
#include <QtTest>

namespace ameco::test {

inline std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A folder that goes away with its files.
class Folder {
public:
    [[nodiscard]] std::filesystem::path path() const { return folder_.path().toStdString(); }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
        return path() / name;
    }
    /// Makes a file and returns its path.
    [[nodiscard]] std::filesystem::path file(const std::string& name,
                                             const std::string& content) const {
        std::ofstream(path() / name, std::ios::binary) << content;
        return path() / name;
    }
    [[nodiscard]] std::size_t entries() const {
        using Iterator = std::filesystem::directory_iterator;
        return static_cast<std::size_t>(std::distance(Iterator(path()), Iterator()));
    }

private:
    QTemporaryDir folder_;
};

/// The message of the exception of type E that `f` throws; says what came instead otherwise.
template <class E, class F>
std::string message_of(F&& f) {
    try {
        f();
    } catch (const E& error) {
        return error.what();
    } catch (const std::exception& error) {
        return std::string("(exception of another type) ") + error.what();
    }
    return "(no exception)";
}

/// Whether `text` contains `part`; prints both otherwise.
inline bool contains(const std::string& text, const QString& part) {
    if (text.find(part.toStdString()) != std::string::npos) {
        return true;
    }
    qWarning("'%s' does not contain '%s'", text.c_str(), qPrintable(part));
    return false;
}

/// Takes the rights of an ordinary user for a while: root may read and write everything.
class OrdinaryUser {
public:
    OrdinaryUser() : is_root_(::geteuid() == 0), became_(is_root_ && ::seteuid(nobody) == 0) {}
    ~OrdinaryUser() {
        if (became_ && ::seteuid(0) != 0) {
            std::abort();
        }
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;
    [[nodiscard]] explicit operator bool() const { return !is_root_ || became_; }

private:
    static constexpr uid_t nobody = 65534;
    bool is_root_;
    bool became_;
};

/// How a message about a file begins.
inline QString name_of(const std::filesystem::path& path) {
    return QString::fromStdString(path.string() + ": ");
}

template <int D>
bool same_bits(const Mesh<D>& a, const Mesh<D>& b) {
    // Equal numbers may differ in bits: 0 and -0.
    return a == b &&
           std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Vec<D>)) == 0;
}

/// Random content, with no regard to geometry: readers have none either.
class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}

    int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }

    /// Any finite double: all magnitudes, subnormals and zeros of both signs.
    double real() {
        switch (below(8)) {
        case 0:
            return below(2) ? 0.0 : -0.0;
        case 1:
            return 1 + 1e-9 * below(1000);
        default:
            for (;;) {
                const auto value = std::bit_cast<double>(engine_());
                if (std::isfinite(value)) {
                    return value;
                }
            }
        }
    }
    float real32() {
        for (;;) {
            const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(engine_()));
            if (std::isfinite(value)) {
                return value;
            }
        }
    }
    int label() { return below(4) ? below(20) : static_cast<int>(engine_()); }

    template <std::size_t N>
    std::array<NodeId, N> cell(int nodes) {
        std::array<NodeId, N> result;
        for (NodeId& node : result) {
            node = NodeId(below(nodes));
        }
        return result;
    }
    template <class T>
    std::vector<T> list(int limit) {
        std::vector<T> result;
        for (int i = limit == 0 ? 0 : below(6); i > 0; --i) {
            result.push_back(T(below(limit)));
        }
        return result;
    }

private:
    std::mt19937_64 engine_;
};

/// \param single  coordinates that float32 can hold
template <int D>
Mesh<D> random_mesh(unsigned seed, bool single) {
    Random random(seed);
    Mesh<D> mesh;
    const int n = 1 + random.below(40);
    const bool labelled = random.below(2) == 0;
    for (int i = 0; i < n; ++i) {
        Vec<D> x;
        for (int k = 0; k < D; ++k) {
            x[k] = single ? static_cast<double>(random.real32()) : random.real();
        }
        mesh.points.push_back(x);
        if (labelled) {
            mesh.labels.push_back(i == 0 ? 3 : random.label());
        }
    }
    for (int i = 1 + random.below(50); i > 0; --i) {
        mesh.elements.push_back(random.cell<D + 1>(n));
        mesh.region.push_back(random.label());
    }
    for (int i = random.below(30); i > 0; --i) {
        mesh.faces.push_back(random.cell<D>(n));
        mesh.patch.push_back(random.label());
    }
    Features& f = mesh.features;
    const auto faces = static_cast<int>(mesh.faces.size());
    int edges = faces;
    if (D == 3) {
        for (int i = random.below(10); i > 0; --i) {
            f.edges.push_back(random.cell<2>(n));
            f.edge_labels.push_back(random.label());
        }
        edges = static_cast<int>(f.edges.size());
        f.required_faces = random.list<int>(faces);
    }
    f.corners = random.list<NodeId>(n);
    f.ridges = random.list<int>(edges);
    f.required_nodes = random.list<NodeId>(n);
    f.required_edges = random.list<int>(edges);
    f.required_elements = random.list<int>(static_cast<int>(mesh.elements.size()));
    for (int i = random.below(4); i > 0; --i) {
        mesh.patch_names[random.label()] = "wing, part " + std::to_string(i);
    }
    return mesh;
}

} // namespace ameco::test
