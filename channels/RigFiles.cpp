// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/RigFiles.h"

#include "brickwall/channels/CoviseXml.h"
#include "brickwall/channels/ParaviewPvx.h"
#include "brickwall/channels/RigFilesBuiltIn.h"
#include "brickwall/channels/RigJson.h"
#include "brickwall/channels/RigToml.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace brickwall {
namespace {

constexpr std::uintmax_t largestFile = 16 << 20; // installations take kilobytes; a data set given by mistake stops here

RigText readText(const std::string& file)
{
    std::error_code failed;
    const std::filesystem::file_status status = std::filesystem::status(file, failed);
    if (!std::filesystem::exists(status))
        throw Error(file, fmt::format("no such file, and no built-in rig of that name; the built-in rigs are {}",
                                      enumerate(builtInRigs())));
    if (!std::filesystem::is_regular_file(status))
        throw Error(file, "expected a rig file, found a directory or device");
    if (std::filesystem::file_size(file, failed) > largestFile)
        throw Error(file, "expected a rig file, found one of more than 16 MiB");
    std::ifstream stream(file, std::ios::binary);
    RigText source{file, std::string(std::istreambuf_iterator<char>(stream), {})};
    if (!stream)
        throw Error(file, "the file cannot be read; check its permissions");
    return source;
}

Rig rigOfXml(RigText source, const RigScope& scope)
{
    const RigXml xml(std::move(source));
    const pugi::xml_node root = xml.document.document_element();
    if (std::string_view(root.name()) == "pvx")
        return readPvx(xml);
    if (std::string_view(root.name()) == "COCONFIG")
        return readCovise(xml, scope);
    throw Error(
        xml.placeOf(root),
        fmt::format("expected the root element <pvx> (ParaView) or <COCONFIG> (COVISE), found <{}>", root.name()));
}

Rig rigOfText(RigText source, const RigScope& scope)
{
    const std::size_t begin = source.text.starts_with("\xef\xbb\xbf") ? 3 : 0;
    const std::size_t first = source.text.find_first_not_of(" \t\r\n", begin);
    if (first == source.text.npos)
        throw Error(source.file, "expected a rig (TOML, JSON, COVISE XML or .pvx), found an empty file");
    if (source.text[first] == '<')
        return rigOfXml(std::move(source), scope);
    return rigOfRecord(source.text[first] == '{' ? recordOfJson(source) : recordOfToml(source));
}

/// For formats in which every channel is in a window.
Rig withWindows(Rig rig, std::vector<std::string>& lost)
{
    for (Channel& channel : rig.channels) {
        if (channel.window >= 0)
            continue;
        lost.push_back(fmt::format("channel \"{}\": that it has no window; one of its size is written", channel.name));
        Window window;
        window.name = channel.name;
        window.width = channel.viewport.x + channel.viewport.width;
        window.height = channel.viewport.y + channel.viewport.height;
        channel.window = int(rig.windows.size());
        rig.windows.push_back(window);
    }
    return rig;
}

} // namespace

Rig loadRig(const std::string& fileOrName, const RigScope& scope)
{
    const auto& builtIn = builtInRigFiles();
    const auto known =
        std::find_if(builtIn.begin(), builtIn.end(), [&](const auto& rig) { return rig.name == fileOrName; });
    Rig rig =
        rigOfText(known != builtIn.end() ? RigText{fileOrName, std::string(known->text)} : readText(fileOrName), scope);
    if (rig.name.empty())
        rig.name = std::filesystem::path(fileOrName).stem().string() + (scope.host.empty() ? "" : "-" + scope.host);
    checkRig(rig, fileOrName);
    return rig;
}

std::vector<std::string> builtInRigs()
{
    std::vector<std::string> names;
    for (const BuiltInRig& rig : builtInRigFiles())
        names.emplace_back(rig.name);
    return names;
}

std::string writeRig(const Rig& rig, RigFormat format, std::vector<std::string>& lost)
{
    checkRig(rig, rig.name);
    switch (format) {
    case RigFormat::toml:
        return tomlOfRecord(recordOfRig(rig));
    case RigFormat::json:
        return recordOfRig(rig).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    case RigFormat::covise:
        return writeCovise(withWindows(rig, lost), lost);
    case RigFormat::pvx:
        return writePvx(withWindows(rig, lost), lost);
    }
    return {};
}

} // namespace brickwall
