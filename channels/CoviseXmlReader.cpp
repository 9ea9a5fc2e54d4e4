// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/CoviseXml.h"
#include "brickwall/channels/CoviseXmlHost.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

bool sameRectangle(const Screen& a, const Screen& b)
{
    constexpr double near = 1e-6; // a micrometre: the file counts in millimetres
    return glm::distance(a.lowerLeft, b.lowerLeft) < near && glm::distance(a.lowerRight, b.lowerRight) < near &&
           glm::distance(a.upperRight, b.upperRight) < near;
}

bool sameViewer(const Viewer& a, const Viewer& b)
{
    return a.roomFromHead == b.roomFromHead && a.leftEye == b.leftEye && a.rightEye == b.rightEye;
}

/// Hosts put together: equal screens and viewers are shared, each host has its own windows.
class RigUnion
{
public:
    /// `host` names the windows; empty leaves their names.
    void add(const Rig& part, const std::string& host)
    {
        if (rig.channels.empty()) {
            rig.near = part.near, rig.far = part.far;
            rig.sceneSize = part.sceneSize;
            rig.background = part.background;
        } else if (part.near != rig.near || part.far != rig.far || part.sceneSize != rig.sceneSize ||
                   part.background != rig.background) {
            note(fmt::format(
                "host {} has other values of Near, Far, SceneSize or Background; those of the first host count", host));
        }
        for (Channel channel : part.channels) {
            channel.screen = indexOfScreen(part.screens[channel.screen]);
            channel.viewer = indexOfViewer(part.viewers[channel.viewer]);
            channel.name = rig.screens[channel.screen].name;
            channel.window += int(rig.windows.size());
            rig.channels.push_back(channel);
        }
        for (const Window& window : part.windows)
            addWindow(window, host, part.windows.size());
        for (const std::string& text : part.notes)
            note(text);
    }

    void note(const std::string& text)
    {
        if (std::find(rig.notes.begin(), rig.notes.end(), text) == rig.notes.end())
            rig.notes.push_back(text);
    }

    Rig take()
    {
        nameChannels();
        return std::move(rig);
    }

private:
    Rig rig;

    int indexOfScreen(Screen screen)
    {
        std::vector<std::string> taken;
        for (const Screen& known : rig.screens) {
            if (sameRectangle(known, screen))
                return int(&known - rig.screens.data());
            taken.push_back(known.name);
        }
        screen.name = uniqueName(screen.name, taken);
        rig.screens.push_back(screen);
        return int(rig.screens.size()) - 1;
    }

    int indexOfViewer(Viewer viewer)
    {
        std::vector<std::string> taken;
        for (const Viewer& known : rig.viewers) {
            if (sameViewer(known, viewer) && known.name == viewer.name)
                return int(&known - rig.viewers.data());
            taken.push_back(known.name);
        }
        viewer.name = uniqueName(viewer.name, taken);
        rig.viewers.push_back(viewer);
        return int(rig.viewers.size()) - 1;
    }

    void addWindow(Window window, const std::string& host, std::size_t windowsOfHost)
    {
        std::vector<std::string> taken;
        for (const Window& known : rig.windows)
            taken.push_back(known.name);
        if (!host.empty()) {
            window.name = windowsOfHost == 1 ? host : fmt::format("{}-{}", host, window.name);
            if (window.display.starts_with(":") || window.display.empty())
                window.display = host + (window.display.empty() ? ":0" : window.display);
        }
        window.name = uniqueName(window.name, taken);
        rig.windows.push_back(window);
    }

    /// A screen's channels share its name where the eye tells them apart.
    void nameChannels()
    {
        std::vector<std::string> taken;
        for (Channel& channel : rig.channels) {
            const auto isTaken = [&](const std::string& name) {
                const auto has = [&](Eye eye) {
                    return std::find(taken.begin(), taken.end(), name + "-" + toString(eye)) != taken.end();
                };
                return showsEye(channel, Eye::left)
                           ? has(Eye::left) || (showsEye(channel, Eye::right) && has(Eye::right))
                           : has(showsEye(channel, Eye::right) ? Eye::right : Eye::middle);
            };
            const std::string base = channel.name;
            for (int number = 2; isTaken(channel.name); ++number)
                channel.name = fmt::format("{}-{}", base, number);
            for (const Eye eye : {Eye::middle, Eye::left, Eye::right})
                if (showsEye(channel, eye))
                    taken.push_back(channel.name + "-" + toString(eye));
        }
    }

    static bool showsEye(const Channel& channel, Eye eye)
    {
        switch (channel.stereo) {
        case StereoMode::mono:
            return eye == Eye::middle;
        case StereoMode::left:
            return eye == Eye::left;
        case StereoMode::right:
            return eye == Eye::right;
        default:
            return eye != Eye::middle;
        }
    }
};

bool has(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// All hosts; masters only if nobody else shows anything.
Rig rigOfAllHosts(const CoviseFiles& files, RigScope scope)
{
    RigUnion all, masters;
    std::vector<std::string> withChannels, mastersWithChannels;
    for (const std::string& host : files.hosts()) {
        scope.host = host;
        const Rig part = rigOfCoviseHost(CoviseConfig(files, scope));
        if (part.channels.empty())
            continue;
        const bool isMaster = has(files.masters(), host);
        (isMaster ? masters : all).add(part, host);
        (isMaster ? mastersWithChannels : withChannels).push_back(host);
    }
    if (withChannels.empty() && !mastersWithChannels.empty())
        return masters.take();
    if (withChannels.empty()) {
        scope.host.clear();
        all.add(rigOfCoviseHost(CoviseConfig(files, scope)), "");
        return all.take();
    }
    all.note(fmt::format("the rig puts {} hosts together ({})", withChannels.size(), enumerate(withChannels)));
    if (!mastersWithChannels.empty())
        all.note(fmt::format("the control window of the master {} is left out; ask for that host to have it",
                             enumerate(mastersWithChannels)));
    return all.take();
}

} // namespace

Rig readCovise(const RigXml& file, const RigScope& scope)
{
    const CoviseFiles files(file);
    Rig rig;
    if (scope.host.empty()) {
        rig = rigOfAllHosts(files, scope);
    } else {
        RigUnion one;
        one.add(rigOfCoviseHost(CoviseConfig(files, scope)), "");
        rig = one.take();
    }
    if (!rig.channels.empty())
        return rig;
    if (scope.host.empty())
        throw Error(file.source.file, "expected channels under COCONFIG/GLOBAL/COVER or a LOCAL section, found none");
    throw Error(file.source.file,
                fmt::format("host \"{}\" shows no channels; the file names the hosts {}", scope.host,
                            files.hosts().empty() ? "of no LOCAL section" : enumerate(files.hosts())));
}

} // namespace brickwall
