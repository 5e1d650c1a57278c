// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/level_state.h"

#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

namespace ameco {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little,
              "arrays are stored as they stand in memory, which must be little-endian");

template <class T>
Json packed(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
    if (!bytes.empty()) {
        std::memcpy(bytes.data(), values.data(), bytes.size());
    }
    return Json::binary(std::move(bytes));
}

template <class T>
std::vector<T> unpacked(const Json& json, const char* key) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::vector<std::uint8_t>& bytes = json.at(key).get_binary();
    if (bytes.size() % sizeof(T) != 0) {
        throw InputError(std::string(key) + " has a broken length");
    }
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!bytes.empty()) {
        std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
    }
    return values;
}

/// Ridges as arrays: a struct's padding bytes would differ from run to run.
Json packed_ridges(const std::vector<RidgeEdge>& ridges) {
    std::vector<Edge> nodes;
    std::vector<std::int32_t> labels;
    std::vector<std::uint8_t> flags;
    for (const RidgeEdge& r : ridges) {
        nodes.push_back(r.nodes);
        labels.push_back(r.label);
        flags.push_back(static_cast<std::uint8_t>((r.listed ? 1 : 0) + (r.declared ? 2 : 0)));
    }
    return {{"nodes", packed(nodes)}, {"label", packed(labels)}, {"flags", packed(flags)}};
}

std::vector<RidgeEdge> unpacked_ridges(const Json& json) {
    const auto nodes = unpacked<Edge>(json, "nodes");
    const auto labels = unpacked<std::int32_t>(json, "label");
    const auto flags = unpacked<std::uint8_t>(json, "flags");
    if (labels.size() != nodes.size() || flags.size() != nodes.size()) {
        throw InputError("ridges have a broken length");
    }
    std::vector<RidgeEdge> ridges(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        ridges[i] = {nodes[i], labels[i], (flags[i] & 1) != 0, (flags[i] & 2) != 0};
    }
    return ridges;
}

template <int D>
void require_fit(const Level<D>& level) {
    const std::size_t nodes = level.mesh.points.size();
    if (level.geometry.node.size() != nodes || level.parent.size() != nodes ||
        level.geometry.deviation.size() != level.mesh.faces.size()) {
        throw InputError("it belongs to another mesh");
    }
    const bool classes_known = std::all_of(level.geometry.node.begin(), level.geometry.node.end(),
                                           [](NodeClass c) { return c <= NodeClass::frozen; });
    const bool ridges_known = std::all_of(
        level.geometry.ridges.begin(), level.geometry.ridges.end(), [&](const RidgeEdge& r) {
            return level.mesh.points.contains(r.nodes[0]) && level.mesh.points.contains(r.nodes[1]);
        });
    if (!classes_known || !ridges_known) {
        throw InputError("its numbers make no sense");
    }
}

} // namespace

template <int D>
std::string level_state_bytes(const Level<D>& level) {
    const Json json = {{"schema_version", 1},
                       {"dimension", D},
                       {"node_class", packed(level.geometry.node.raw())},
                       {"ridges", packed_ridges(level.geometry.ridges)},
                       {"face_deviation", packed(level.geometry.deviation.raw())},
                       {"parent", packed(level.parent.raw())}};
    std::string bytes;
    Json::to_cbor(json, bytes);
    return bytes;
}

template <int D>
void parse_level_state(const std::string& bytes, const std::filesystem::path& file,
                       Level<D>& level) {
    try {
        const Json json = Json::from_cbor(bytes);
        if (json.at("schema_version") != 1 || json.at("dimension") != D) {
            throw InputError("it is of another version or dimension");
        }
        level.geometry.node.raw() = unpacked<NodeClass>(json, "node_class");
        level.geometry.ridges = unpacked_ridges(json.at("ridges"));
        level.geometry.deviation.raw() = unpacked<double>(json, "face_deviation");
        level.parent.raw() = unpacked<NodeId>(json, "parent");
        require_fit(level);
    } catch (const Json::exception& e) {
        throw InputError(file.string() + ": damaged: " + e.what());
    } catch (const InputError& e) {
        throw InputError(file.string() + ": cannot resume from it: " + e.what());
    }
}

template std::string level_state_bytes(const Level<2>&);
template std::string level_state_bytes(const Level<3>&);
template void parse_level_state(const std::string&, const std::filesystem::path&, Level<2>&);
template void parse_level_state(const std::string&, const std::filesystem::path&, Level<3>&);

} // namespace ameco
