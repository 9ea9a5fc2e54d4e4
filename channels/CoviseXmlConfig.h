// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/RigFiles.h"
#include "brickwall/channels/RigFilesXml.h"

#include <array>
#include <map>
#include <memory>
#include <set>

namespace brickwall {

/// A GLOBAL, CLUSTER or LOCAL element, and the INCLUDE elements that lead to its file (their filters apply to it as
/// well).
struct CoviseSection
{
    const RigXml* file;
    pugi::xml_node element;
    std::vector<pugi::xml_node> includes;
};

/// The sections of a configuration file and of what it includes, in the order in which they count; each file once.
class CoviseFiles
{
public:
    /// `main` has to outlive this. Throws Error for included files that are no COCONFIG.
    explicit CoviseFiles(const RigXml& main);

    const std::vector<CoviseSection>& sections() const { return all; }
    const std::vector<std::string>& notes() const { return remarks; }
    /// Lower-case names in HOST attributes, in the order of their first use, and those in MASTER attributes.
    const std::vector<std::string>& hosts() const { return hostNames; }
    const std::vector<std::string>& masters() const { return masterNames; }

private:
    void collect(const RigXml& file, const std::vector<pugi::xml_node>& includes);
    void include(const RigXml& file, const pugi::xml_node& element, std::vector<pugi::xml_node> includes);
    void collectHosts(const pugi::xml_node& element, int depth);

    std::vector<std::unique_ptr<RigXml>> included;
    std::set<std::string> paths;
    std::vector<CoviseSection> all;
    std::vector<std::string> remarks, hostNames, masterNames;
};

struct CoviseValue
{
    std::string text;
    std::string place; ///< file and line
};

/// What one host sees of the COVER part of the files. Elements are named by their path under COVER, with the element's
/// name or index: "ScreenConfig.Screen:0". Per attribute LOCAL comes before CLUSTER before GLOBAL, and in each of them
/// the first definition counts.
class CoviseConfig
{
public:
    CoviseConfig(const CoviseFiles& files, const RigScope& scope);

    const CoviseValue* find(const std::string& element, const std::string& attribute) const;
    bool has(const std::string& element) const;
    /// The names of elements that begin with `prefix`, sorted.
    std::vector<std::string> elementsWith(const std::string& prefix) const;

    // Typed values as COVISE reads them; `fallback` where the attribute is absent. They throw Error where the text is
    // no such value, and add a note where COVISE changes it (a fraction for a whole number).
    std::string text(const std::string& element, const std::string& attribute, const std::string& fallback = "") const;
    double number(const std::string& element, const std::string& attribute, double fallback) const;
    int integer(const std::string& element, const std::string& attribute, int fallback) const;
    bool flag(const std::string& element, const std::string& attribute, bool fallback) const;
    int count(const std::string& element, int fallback) const; ///< 0 to 50
    /// Where the attribute stands, or the element, or the file.
    std::string placeOf(const std::string& element, const std::string& attribute) const;

    void note(const std::string& text) const;
    const std::vector<std::string>& notes() const { return remarks; }

private:
    using Attributes = std::map<std::string, CoviseValue>;
    void add(const RigXml& file, const pugi::xml_node& parent, const std::string& path, int layer, int depth);
    bool applies(const pugi::xml_node& element) const;

    RigScope wanted;
    std::array<std::map<std::string, Attributes>, 3> layers; ///< LOCAL, CLUSTER, GLOBAL
    std::map<std::string, std::string> placeOfElement;
    std::string file;
    mutable std::vector<std::string> remarks;
};

} // namespace brickwall
