// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/format.h"

#include <algorithm>

namespace ameco {
namespace {

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return text;
}

bool ends_with(std::string_view text, std::string_view end) {
    return text.size() > end.size() && text.substr(text.size() - end.size()) == end;
}

std::string join(const std::vector<std::string>& items, const char* between) {
    std::string result;
    for (const std::string& item : items) {
        result += (result.empty() ? "" : between) + item;
    }
    return result;
}

/// More than one value: with a single one there is nothing to tell apart.
template <class Labels>
bool differ(const Labels& labels) {
    return std::any_of(labels.begin(), labels.end(),
                       [&](int label) { return label != *labels.begin(); });
}

} // namespace

const Format* format_of_suffix(const std::filesystem::path& path, bool metric) {
    std::string name = lower_case(path.filename().string());
    if (ends_with(name, ".gz")) {
        name.resize(name.size() - 3);
    }
    const Format* best = nullptr;
    std::size_t longest = 0;
    for (const Format& format : formats()) {
        for (const std::string_view suffix : format.suffixes) {
            if (format.is_metric() == metric && suffix.size() > longest &&
                ends_with(name, suffix)) {
                best = &format;
                longest = suffix.size();
            }
        }
    }
    return best;
}

const Format* format_of_name(std::string_view name) {
    const auto found = std::find_if(formats().begin(), formats().end(),
                                    [&](const Format& format) { return format.name == name; });
    return found == formats().end() ? nullptr : &*found;
}

const Format& format_to_write(const std::filesystem::path& path, const WriteOptions& options,
                              bool metric) {
    const bool packed = lower_case(path.extension().string()) == ".gz"; // read, but not written
    const Format* format = !options.format.empty() ? format_of_name(options.format)
                           : packed                ? nullptr
                                                   : format_of_suffix(path, metric);
    if (format == nullptr && !options.format.empty()) {
        throw UsageError("there is no format '" + options.format + "'; ameco formats lists them");
    }
    if (format != nullptr && !format->reads() && !format->writes()) {
        throw Error(ExitCode::not_built, path.string() + ": " + std::string(format->title) +
                                             " cannot be written: " + std::string(format->remark));
    }
    if (format == nullptr || format->is_metric() != metric || !format->writes()) {
        throw UsageError(path.string() + ": cannot be written as a " +
                         (metric ? "metric" : "mesh") + "; choose a name that ends in one of " +
                         suffix_list(metric, true));
    }
    return *format;
}

std::string suffix_list(bool metric, bool to_write) {
    std::vector<std::string> list;
    for (const Format& format : formats()) {
        const bool listed = to_write ? format.writes() : format.reads();
        const std::string suffix(format.suffixes.front());
        if (format.is_metric() == metric && listed &&
            std::find(list.begin(), list.end(), suffix) == list.end()) {
            list.push_back(suffix);
        }
    }
    return join(list, ", ");
}

template <int D>
std::vector<std::string> losses(const Format& format, const Mesh<D>& mesh) {
    const auto lacks = [&](Keeps what) { return (format.keeps & what) == 0; };
    const bool boundary_only = format.keeps == keeps_surfaces; // of a mesh with volume, too
    if (lacks(D == 2                                   ? keeps_2d
              : mesh.elements.empty() || boundary_only ? keeps_surfaces
                                                       : keeps_3d)) {
        throw UsageError("the format " + std::string(format.title) + " cannot hold a " +
                         (D == 2                  ? "2-D mesh"
                          : mesh.elements.empty() ? "surface"
                                                  : "3-D mesh") +
                         "; ameco formats says which can");
    }
    const Features& f = mesh.features;
    std::vector<std::string> lost;
    const auto test = [&](bool present, Keeps what, const char* words) {
        if (present && lacks(what)) {
            lost.emplace_back(words);
        }
    };
    test(differ(mesh.patch), keeps_patches, "patches");
    test(!mesh.patch_names.empty(), keeps_names, "names of patches");
    test(differ(mesh.region), keeps_regions, "regions");
    test(D == 3 && !f.edges.empty(), keeps_curves, "curves");
    test(!f.corners.empty() || !f.ridges.empty() || !f.required_nodes.empty() ||
             !f.required_edges.empty() || !f.required_faces.empty() || !f.required_elements.empty(),
         keeps_features, "corners, ridges and what is required");
    test(!mesh.labels.empty(), keeps_labels, "labels of nodes");
    if (lost.empty()) {
        return {};
    }
    return {"left out, since " + std::string(format.title) +
            " cannot hold them: " + join(lost, "; ")};
}

template std::vector<std::string> losses(const Format&, const Mesh<2>&);
template std::vector<std::string> losses(const Format&, const Mesh<3>&);

} // namespace ameco
