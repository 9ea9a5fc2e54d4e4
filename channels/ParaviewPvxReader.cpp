// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/ParaviewPvx.h"
#include "brickwall/channels/RigFilesOrientation.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace brickwall {
namespace {

constexpr int defaultLongSide = 1024;

struct StereoWord
{
    std::string_view word;
    StereoMode mode;
};

constexpr std::array<StereoWord, 9> stereoWords{{
    {"Crystal Eyes", StereoMode::quadBuffer},
    {"Red-Blue", StereoMode::anaglyphic},
    {"Interlaced", StereoMode::horizontalInterlace},
    {"Left", StereoMode::left},
    {"Right", StereoMode::right},
    {"Dresden", StereoMode::verticalInterlace},
    {"Anaglyph", StereoMode::anaglyphic},
    {"Checkerboard", StereoMode::checkerboard},
    {"SplitViewportHorizontal", StereoMode::horizontalSplit},
}};

/// Attributes that are read, or that mean something only to ParaView's own windows.
const std::set<std::string_view> knownAttributes{"Name",       "Environment", "Geometry",  "ViewerId",
                                                 "LowerLeft",  "LowerRight",  "UpperLeft", "UpperRight",
                                                 "StereoType", "ShowBorders"};

class PvxReader
{
public:
    explicit PvxReader(const RigXml& xmlFile) : xml(xmlFile) {}

    Rig read()
    {
        readElements(xml.document.child("pvx"));
        if (rig.channels.empty())
            throw Error(xml.placeOf(xml.document.child("pvx")), "expected at least one <Machine>, found none");
        makeViewers();
        for (const auto& [attribute, place] : ignored)
            note(place, fmt::format("attribute {} is not read", attribute));
        return std::move(rig);
    }

private:
    const RigXml& xml;
    Rig rig;
    double eyeSeparation = 0.065;
    std::map<int, double> separationOfViewer;
    std::map<int, std::string> placeOfViewer;
    std::map<std::string, std::string> ignored; ///< attribute, and the first place where it occurs

    void note(const std::string& place, const std::string& text) { rig.notes.push_back(place + ": " + text); }

    void readElements(const pugi::xml_node& parent)
    {
        for (const pugi::xml_node element : parent.children()) {
            if (element.type() != pugi::node_element)
                continue;
            const std::string_view tag = element.name();
            if (tag == "Machine")
                readMachine(element);
            else if (tag == "EyeSeparation")
                eyeSeparation = number(element, "Value");
            else if (tag == "UseOffAxisProjection")
                readOffAxis(element);
            else if (tag == "IndependentViewers")
                readViewers(element);
            else if (tag == "Process")
                readProcess(element);
            else
                note(xml.placeOf(element), fmt::format("element <{}> is not read", tag));
        }
    }

    void readProcess(const pugi::xml_node& element)
    {
        const std::string_view type = element.attribute("Type").value();
        if (type == "client") {
            note(xml.placeOf(element), "<Process Type=\"client\"> shows nothing on the walls and is not read");
            return;
        }
        if (std::string_view(element.parent().name()) == "Process")
            throw Error(xml.placeOf(element), "expected no <Process> within another one");
        note(xml.placeOf(element), "<Process> is deprecated since ParaView 6.1; its contents are read");
        readElements(element);
    }

    void readOffAxis(const pugi::xml_node& element)
    {
        const std::string value = lowerCase(required(element, "Value"));
        if (value != "true" && value != "1")
            note(xml.placeOf(element, "Value"), "UseOffAxisProjection is off, but Brickwall always projects off-axis");
    }

    void readViewers(const pugi::xml_node& parent)
    {
        for (const pugi::xml_node element : parent.children("Viewer")) {
            const int id = viewerId(element, "Id");
            separationOfViewer[id] = number(element, "EyeSeparation");
            placeOfViewer.emplace(id, xml.placeOf(element, "Id"));
        }
    }

    void readMachine(const pugi::xml_node& element)
    {
        for (const pugi::xml_attribute attribute : element.attributes())
            if (!knownAttributes.contains(attribute.name()))
                ignored.emplace(attribute.name(), xml.placeOf(element, attribute.name()));
        const int index = int(rig.channels.size());
        Screen screen = readScreen(element, nameOf(element, index));
        Window window = readWindow(element, screen);
        Channel channel;
        channel.name = screen.name;
        channel.screen = channel.window = index;
        channel.viewport = {0, 0, window.width, window.height};
        channel.stereo = readStereo(element);
        window.quadBuffer = channel.stereo == StereoMode::quadBuffer;
        if (element.attribute("ViewerId")) {
            channel.viewer = viewerId(element, "ViewerId");
            placeOfViewer.emplace(channel.viewer, xml.placeOf(element, "ViewerId"));
        }
        rig.screens.push_back(std::move(screen));
        rig.windows.push_back(std::move(window));
        rig.channels.push_back(std::move(channel));
    }

    std::string nameOf(const pugi::xml_node& element, int index)
    {
        std::string name = lowerCase(element.attribute("Name").value());
        std::replace(name.begin(), name.end(), ' ', '-');
        if (name.empty())
            name = fmt::format("machine-{}", index);
        std::vector<std::string> taken;
        for (const Screen& screen : rig.screens)
            taken.push_back(screen.name);
        return uniqueName(name, taken);
    }

    Screen readScreen(const pugi::xml_node& element, const std::string& name)
    {
        Screen screen;
        screen.name = name;
        const bool upperRight = element.attribute("UpperRight"), upperLeft = element.attribute("UpperLeft");
        if (!element.attribute("LowerLeft") && !element.attribute("LowerRight") && !upperRight && !upperLeft) {
            placeScreen(screen, vec3d(0.0, 0.5, 0.0), 1.0, 1.0, glm::dmat3(1.0));
            note(xml.placeOf(element), fmt::format("machine \"{}\" has no corners: ParaView's default screen, 1 x 1 m, "
                                                   "half a metre in front of the origin",
                                                   name));
            return screen;
        }
        screen.lowerLeft = corner(element, "LowerLeft");
        screen.lowerRight = corner(element, "LowerRight");
        screen.upperRight = upperRight  ? corner(element, "UpperRight")
                            : upperLeft ? corner(element, "UpperLeft") + screen.lowerRight - screen.lowerLeft
                                        : corner(element, "UpperRight");
        if (upperRight && upperLeft)
            note(xml.placeOf(element, "UpperLeft"), "UpperLeft is implied by the other corners and is not read");
        return screen;
    }

    /// pvx (x, y up, z towards the viewer) to the room (x, y forward, z up).
    vec3d corner(const pugi::xml_node& element, const char* attribute)
    {
        const std::string text = required(element, attribute);
        const std::vector<std::string> words = splitWords(text, " \t\r\n");
        vec3d value(0.0);
        for (int i = 0; i < std::min<int>(3, int(words.size())); ++i) {
            const std::optional<double> component = parseNumber(words[i]);
            if (!component)
                throw Error(xml.placeOf(element, attribute),
                            fmt::format("machine \"{}\", attribute {}: expected three numbers, found \"{}\" in \"{}\"",
                                        element.attribute("Name").value(), attribute, words[i], text));
            value[i] = *component;
        }
        if (words.size() != 3)
            throw Error(xml.placeOf(element, attribute),
                        fmt::format("machine \"{}\", attribute {}: expected three numbers, found {} in \"{}\"",
                                    element.attribute("Name").value(), attribute, words.size(), text));
        return {value.x, 0.0 - value.z, value.y};
    }

    Window readWindow(const pugi::xml_node& element, const Screen& screen)
    {
        Window window;
        window.name = screen.name;
        window.decoration = std::string_view(element.attribute("ShowBorders").value()) == "1";
        for (const std::string& word : splitWords(element.attribute("Environment").value(), " \t")) {
            if (word.starts_with("DISPLAY="))
                window.display = word.substr(8);
            else
                note(xml.placeOf(element, "Environment"), fmt::format("environment {} is not set", word));
        }
        if (element.attribute("Geometry")) {
            readGeometry(element, window);
            return window;
        }
        const double width = widthOf(screen), height = heightOf(screen);
        const double longer = std::max({width, height, 1e-300});
        window.width = std::max(1, int(std::lround(defaultLongSide * (width / longer))));
        window.height = std::max(1, int(std::lround(defaultLongSide * (height / longer))));
        note(xml.placeOf(element), fmt::format("machine \"{}\" has no Geometry: a window of {} x {} pixels",
                                               screen.name, window.width, window.height));
        return window;
    }

    /// X11's WxH or WxH+X+Y.
    void readGeometry(const pugi::xml_node& element, Window& window)
    {
        const std::string text = required(element, "Geometry");
        const std::size_t cross = text.find('x');
        const std::size_t first = std::min(text.find_first_of("+-", cross), text.size());
        const std::size_t second = std::min(text.find_first_of("+-", first + 1), text.size());
        std::optional<int> width, height, x = 0, y = 0;
        if (cross != text.npos) {
            width = parseInteger(text.substr(0, cross));
            height = parseInteger(text.substr(cross + 1, first - cross - 1));
        }
        if (first < text.size()) {
            x = parseInteger(text.substr(first, second - first));
            y = parseInteger(text.substr(second));
        }
        if (!width || !height || !x || !y || *width < 1 || *height < 1)
            throw Error(
                xml.placeOf(element, "Geometry"),
                fmt::format("machine \"{}\", attribute Geometry: expected WIDTHxHEIGHT+X+Y in pixels, found \"{}\"",
                            element.attribute("Name").value(), text));
        window.width = *width;
        window.height = *height;
        window.x = *x;
        window.y = *y;
    }

    StereoMode readStereo(const pugi::xml_node& element)
    {
        const std::string_view word = element.attribute("StereoType").value();
        if (word.empty())
            return StereoMode::mono;
        const auto known =
            std::find_if(stereoWords.begin(), stereoWords.end(), [&](auto& w) { return w.word == word; });
        if (known == stereoWords.end()) {
            note(xml.placeOf(element, "StereoType"),
                 fmt::format("StereoType \"{}\" is unknown; as in ParaView the machine shows no stereo", word));
            return StereoMode::mono;
        }
        if (word == "Red-Blue")
            note(xml.placeOf(element, "StereoType"), "Red-Blue is shown as Anaglyph (right eye green and blue)");
        return known->mode;
    }

    void makeViewers()
    {
        const int count = placeOfViewer.empty() ? 1 : placeOfViewer.rbegin()->first + 1;
        for (int id = 0; id < count; ++id) {
            if (!placeOfViewer.empty() && !placeOfViewer.contains(id))
                throw Error(
                    placeOfViewer.rbegin()->second,
                    fmt::format("expected viewer ids 0, 1, 2, ... without gaps, found {} but no {}", count - 1, id));
            const auto own = separationOfViewer.find(id);
            const double separation = own == separationOfViewer.end() ? eyeSeparation : own->second;
            Viewer viewer;
            viewer.name = count == 1 ? "viewer" : fmt::format("viewer-{}", id);
            viewer.leftEye = {-separation / 2.0, 0.0, 0.0};
            viewer.rightEye = {separation / 2.0, 0.0, 0.0};
            rig.viewers.push_back(viewer);
        }
    }

    int viewerId(const pugi::xml_node& element, const char* attribute)
    {
        const std::string text = required(element, attribute);
        const std::optional<int> id = parseInteger(text);
        if (!id || *id < 0 || *id > 99)
            throw Error(xml.placeOf(element, attribute),
                        fmt::format("attribute {}: expected a viewer id from 0 to 99, found \"{}\"", attribute, text));
        return *id;
    }

    double number(const pugi::xml_node& element, const char* attribute)
    {
        const std::string text = required(element, attribute);
        const std::vector<std::string> words = splitWords(text, " \t\r\n");
        const std::optional<double> value = words.size() == 1 ? parseNumber(words[0]) : std::nullopt;
        if (!value)
            throw Error(
                xml.placeOf(element, attribute),
                fmt::format("<{}>, attribute {}: expected a number, found \"{}\"", element.name(), attribute, text));
        return *value;
    }

    std::string required(const pugi::xml_node& element, const char* attribute)
    {
        if (!element.attribute(attribute))
            throw Error(xml.placeOf(element), fmt::format("<{} Name=\"{}\"> has no attribute {}", element.name(),
                                                          element.attribute("Name").value(), attribute));
        return element.attribute(attribute).value();
    }
};

} // namespace

Rig readPvx(const RigXml& file)
{
    return PvxReader(file).read();
}

} // namespace brickwall
