// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/CoviseXmlConfig.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace brickwall {
namespace {

constexpr int deepest = 64;

void addNames(std::vector<std::string>& names, const char* list)
{
    for (const std::string& name : splitWords(lowerCase(list), ", \t\r\n"))
        if (std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
}

} // namespace

CoviseFiles::CoviseFiles(const RigXml& main)
{
    std::error_code ignored;
    paths.insert(std::filesystem::weakly_canonical(main.source.file, ignored).string());
    collect(main, {});
}

void CoviseFiles::collect(const RigXml& file, const std::vector<pugi::xml_node>& includes)
{
    const pugi::xml_node root = file.document.child("COCONFIG");
    if (!root)
        throw Error(placeOfLine(file.source, 1), "expected a COVISE configuration with the root element <COCONFIG>");
    for (const pugi::xml_node element : root.children()) {
        if (element.type() != pugi::node_element)
            continue;
        const std::string_view tag = element.name();
        if (tag == "GLOBAL" || tag == "CLUSTER" || tag == "LOCAL") {
            if (tag == "LOCAL" && !element.attribute("HOST"))
                throw Error(file.placeOf(element), "<LOCAL> has no attribute HOST");
            all.push_back({&file, element, includes});
            collectHosts(element, 0);
        } else if (tag == "INCLUDE" || tag == "TRYINCLUDE") {
            include(file, element, includes);
        } else {
            remarks.push_back(fmt::format("{}: element <{}> is not read", file.placeOf(element), tag));
        }
    }
}

void CoviseFiles::include(const RigXml& file, const pugi::xml_node& element, std::vector<pugi::xml_node> includes)
{
    const std::vector<std::string> words = splitWords(element.child_value(), "\t\r\n ");
    if (words.empty())
        throw Error(file.placeOf(element), fmt::format("<{}> names no file", element.name()));
    const std::filesystem::path path = std::filesystem::path(file.source.file).parent_path() / words[0];
    std::error_code failed;
    if (!std::filesystem::is_regular_file(path, failed)) {
        if (std::string_view(element.name()) == "INCLUDE")
            remarks.push_back(
                fmt::format("{}: included file {} is not there; COVISE would also look in its own config folder",
                            file.placeOf(element), words[0]));
        return;
    }
    if (!paths.insert(std::filesystem::weakly_canonical(path, failed).string()).second)
        return;
    std::ifstream stream(path, std::ios::binary);
    RigText text{path.string(), std::string(std::istreambuf_iterator<char>(stream), {})};
    included.push_back(std::make_unique<RigXml>(std::move(text)));
    includes.push_back(element);
    collect(*included.back(), includes);
}

void CoviseFiles::collectHosts(const pugi::xml_node& element, int depth)
{
    if (depth > deepest)
        return; // CoviseConfig reports it
    addNames(hostNames, element.attribute("HOST").value());
    addNames(masterNames, element.attribute("MASTER").value());
    for (const pugi::xml_node child : element.children())
        collectHosts(child, depth + 1);
}

} // namespace brickwall
