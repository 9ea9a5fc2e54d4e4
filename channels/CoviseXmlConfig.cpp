// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/CoviseXmlConfig.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace brickwall {
namespace {

constexpr int deepest = 64;

std::string shortName(const std::string& host)
{
    const bool address =
        std::all_of(host.begin(), host.end(), [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
    return address ? host : host.substr(0, host.find('.'));
}

/// A comma list against a name, in any case; "vis1.uni.de" and "vis1" are the same host.
bool listHas(const char* list, const std::string& name)
{
    const std::string wanted = lowerCase(name);
    for (const std::string& word : splitWords(lowerCase(list), ", \t\r\n"))
        if (word == wanted || shortName(word) == shortName(wanted))
            return true;
    return false;
}

bool listHasRank(const char* list, int rank)
{
    for (const std::string& word : splitWords(lowerCase(list), ", \t\r\n")) {
        const std::vector<std::string> ends = splitWords(word, "-");
        const std::optional<int> first = ends.empty() ? std::nullopt : parseInteger(ends.front());
        const std::optional<int> last = ends.empty() ? std::nullopt : parseInteger(ends.back());
        if (word == "all" || (first && last && ends.size() <= 2 && *first <= rank && rank <= *last))
            return true;
    }
    return false;
}

/// This program runs on Linux with X11; COVISE's own names of builds come from ARCHSUFFIX.
bool listHasThisArchitecture(const char* list)
{
    const char* suffix = std::getenv("ARCHSUFFIX");
    for (const std::string& word : splitWords(lowerCase(list), ", \t\r\n"))
        if (word == "x11" || word == "unix" || word == "linux" || (suffix && word == lowerCase(suffix)))
            return true;
    return false;
}

} // namespace

CoviseConfig::CoviseConfig(const CoviseFiles& files, const RigScope& scope) : wanted(scope), remarks(files.notes())
{
    for (const CoviseSection& section : files.sections()) {
        if (file.empty())
            file = section.file->source.file;
        const auto yes = [&](const pugi::xml_node& element) { return applies(element); };
        if (!yes(section.element) || !std::all_of(section.includes.begin(), section.includes.end(), yes))
            continue;
        const std::string_view tag = section.element.name();
        const int layer = tag == "LOCAL" ? 0 : tag == "CLUSTER" ? 1 : 2;
        for (const pugi::xml_node cover : section.element.children("COVER"))
            if (applies(cover))
                add(*section.file, cover, "", layer, 0);
    }
}

bool CoviseConfig::applies(const pugi::xml_node& element) const
{
    const pugi::xml_attribute host = element.attribute("HOST"), master = element.attribute("MASTER");
    const pugi::xml_attribute architecture = element.attribute("ARCH"), rank = element.attribute("RANK");
    return (!host || listHas(host.value(), wanted.host)) &&
           (!master || wanted.master.empty() || listHas(master.value(), wanted.master)) &&
           (!architecture || listHasThisArchitecture(architecture.value())) &&
           (!rank || wanted.rank < 0 || listHasRank(rank.value(), wanted.rank));
}

void CoviseConfig::add(const RigXml& from, const pugi::xml_node& parent, const std::string& path, int layer, int depth)
{
    if (depth > deepest)
        throw Error(from.placeOf(parent), fmt::format("elements are nested more than {} deep", deepest));
    for (const pugi::xml_node element : parent.children()) {
        if (element.type() != pugi::node_element || !applies(element))
            continue;
        const pugi::xml_attribute name = element.attribute("name"), index = element.attribute("index");
        std::string key = path + element.name();
        if (name || index)
            key += std::string(":") + (name ? name : index).value();
        placeOfElement.emplace(key, from.placeOf(element));
        Attributes& attributes = layers[layer][key];
        for (const pugi::xml_attribute attribute : element.attributes())
            attributes.try_emplace(attribute.name(),
                                   CoviseValue{attribute.value(), from.placeOf(element, attribute.name())});
        add(from, element, key + ".", layer, depth + 1);
    }
}

const CoviseValue* CoviseConfig::find(const std::string& element, const std::string& attribute) const
{
    for (const auto& layer : layers) {
        const auto attributes = layer.find(element);
        if (attributes == layer.end())
            continue;
        const auto value = attributes->second.find(attribute);
        if (value != attributes->second.end())
            return &value->second;
    }
    return nullptr;
}

bool CoviseConfig::has(const std::string& element) const
{
    return placeOfElement.contains(element);
}

std::vector<std::string> CoviseConfig::elementsWith(const std::string& prefix) const
{
    std::vector<std::string> names;
    for (auto i = placeOfElement.lower_bound(prefix); i != placeOfElement.end() && i->first.starts_with(prefix); ++i)
        names.push_back(i->first);
    return names;
}

std::string CoviseConfig::placeOf(const std::string& element, const std::string& attribute) const
{
    if (const CoviseValue* value = find(element, attribute))
        return value->place;
    const auto place = placeOfElement.find(element);
    return place == placeOfElement.end() ? file : place->second;
}

std::string CoviseConfig::text(const std::string& element, const std::string& attribute,
                               const std::string& fallback) const
{
    const CoviseValue* value = find(element, attribute);
    return value ? value->text : fallback;
}

double CoviseConfig::number(const std::string& element, const std::string& attribute, double fallback) const
{
    const CoviseValue* value = find(element, attribute);
    const std::vector<std::string> words = splitWords(value ? value->text : "", " \t\r\n");
    if (!value || words.empty())
        return fallback;
    const std::optional<double> parsed = words.size() == 1 ? parseNumber(words[0]) : std::nullopt;
    if (!parsed)
        throw Error(value->place,
                    fmt::format("{}, attribute {}: expected a number, found \"{}\"", element, attribute, value->text));
    return *parsed;
}

int CoviseConfig::integer(const std::string& element, const std::string& attribute, int fallback) const
{
    const double value = number(element, attribute, fallback);
    const double whole = std::trunc(value);
    if (std::abs(whole) > 1e9)
        throw Error(placeOf(element, attribute),
                    fmt::format("{}, attribute {}: {} is too large", element, attribute, value));
    if (whole != value)
        note(fmt::format("{}: {}, attribute {}: COVISE reads whole numbers, {} becomes {}", placeOf(element, attribute),
                         element, attribute, value, int(whole)));
    return int(whole);
}

bool CoviseConfig::flag(const std::string& element, const std::string& attribute, bool fallback) const
{
    const CoviseValue* value = find(element, attribute);
    if (!value)
        return fallback;
    const std::string word = lowerCase(value->text);
    const std::optional<double> asNumber = parseNumber(word);
    if (word != "on" && word != "true" && word != "off" && word != "false" && !asNumber)
        note(fmt::format("{}: {}, attribute {}: \"{}\" is neither on nor off; COVISE takes it as off", value->place,
                         element, attribute, value->text));
    return word == "on" || word == "true" || (asNumber && *asNumber > 0.0);
}

int CoviseConfig::count(const std::string& element, int fallback) const
{
    const int value = integer(element, "value", fallback);
    if (value < 0 || value > 50)
        throw Error(placeOf(element, "value"), fmt::format("{}: expected 0 to 50, found {}", element, value));
    return value;
}

void CoviseConfig::note(const std::string& text) const
{
    if (std::find(remarks.begin(), remarks.end(), text) == remarks.end())
        remarks.push_back(text);
}

} // namespace brickwall
