// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ExaDataSet.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/EmptyCells.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/model/CheckModel.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace brickwall {
namespace {

class ExaDataSet : public DataSet
{
public:
    explicit ExaDataSet(ExaParts parts) : parts_(std::move(parts)) {}

    std::string format() const override { return "ExaBrick"; }

    std::vector<std::string> fieldNames() const override
    {
        std::vector<std::string> names;
        for (const ExaField& field : parts_.fields)
            names.push_back(field.name);
        return names;
    }

    std::string defaultField() const override { return parts_.fields.empty() ? "" : parts_.fields[0].name; }

    std::vector<std::string> files() const override
    {
        std::vector<std::string> files{parts_.data};
        if (parts_.geometry != parts_.data)
            files.push_back(parts_.geometry);
        for (const ExaField& field : parts_.fields)
            files.insert(files.end(), field.files.begin(), field.files.end());
        if (!parts_.triangles.empty())
            files.push_back(parts_.triangles);
        return files;
    }

    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        const auto wanted = fieldIndices(fieldNames(), fields, parts_.data);
        ExaGeometry geometry = parts_.cells ? readCells(parts_.geometry, executor, progress)
                                            : readBricks(parts_.geometry, executor, progress);
        Model model;
        model.name = stemOf(parts_.data);
        model.fields = readExaFields(parts_.fields, wanted, geometry, nonFinite, executor, progress);
        if (!parts_.triangles.empty())
            model.meshes = readTriangles(parts_.triangles, progress);
        model.worldFromVoxel = parts_.worldFromVoxel;
        model.bricks = std::move(geometry.bricks);
        model.cellCount = geometry.cellCount;
        model.notes = std::move(geometry.notes);
        if (nonFinite == NonFinite::empty)
            leaveOutNonFinite(model, parts_.geometry, executor, progress);
        for (const std::string& note : model.notes)
            progress.note(note);
        checkLayout(model, parts_.geometry); // every value has been looked at
        return model;
    }

private:
    ExaParts parts_;
};

/// "NAME" of BASE.NAME.scalars, "scalar" of BASE.scalars, nothing for any other file.
std::string companionName(const std::string& base, const std::string& file)
{
    for (const std::string_view end : {".scalars", ".scalar"}) {
        if (!file.starts_with(base) || !file.ends_with(end) || file.size() < base.size() + end.size())
            continue;
        const std::string between = file.substr(base.size(), file.size() - base.size() - end.size());
        if (between.empty())
            return "scalar";
        if (between[0] == '.' && between.size() > 1)
            return between.substr(1);
    }
    return {};
}

/// What to open for a file that says nothing alone.
std::string advice(const std::string& part)
{
    const std::filesystem::path path(part);
    const std::string name = path.filename().string();
    std::error_code ignored;
    std::set<std::string> found;
    for (const auto& entry :
         std::filesystem::directory_iterator(path.has_parent_path() ? path.parent_path() : ".", ignored))
        for (const char* end : {".exa", ".bricks", ".cells"})
            if (entry.path().extension() == end && name.starts_with(entry.path().stem().string() + "."))
                found.insert(entry.path().filename().string());
    return found.empty() ? "open the .exa, .bricks or .cells file that it belongs to"
                         : fmt::format("open {} beside it", fmt::join(found, " or "));
}

std::unique_ptr<DataSet> openBeside(const std::string& data, bool cells)
{
    ExaParts parts;
    parts.data = parts.geometry = data;
    parts.cells = cells;
    parts.fields = companionFields(data);
    return makeExaDataSet(std::move(parts));
}

} // namespace

std::unique_ptr<DataSet> makeExaDataSet(ExaParts parts)
{
    return std::make_unique<ExaDataSet>(std::move(parts));
}

std::vector<ExaField> companionFields(const std::string& geometry)
{
    const std::filesystem::path file(geometry);
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    const std::string base = file.stem().string();
    std::set<std::string> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        files.insert(entry.path().filename().string());
    if (error)
        throw Error(folder.string(), fmt::format("cannot look for scalar files: {}", error.message()));
    std::vector<ExaField> fields;
    for (const std::string& candidate : files) {
        const std::string name = companionName(base, candidate);
        const std::string owner = base + "." + name;
        const bool othersFile = files.contains(owner + ".bricks") || files.contains(owner + ".cells");
        const bool known = std::any_of(fields.begin(), fields.end(), [&](const ExaField& f) { return f.name == name; });
        if (name.empty() || othersFile)
            continue;
        const std::filesystem::path scalars = folder / candidate;
        const std::string shown = known ? name + scalars.extension().string() : name;
        fields.push_back({shown, scalars.string(), {scalars.string()}, {}, {}});
    }
    return fields;
}

// .bricks and .cells have no magic number: the extension says what a file claims to be, and its first record has to
// make sense, with a size or level that is plausible and an end within the file.
std::unique_ptr<DataSet> openBricks(const std::string& data)
{
    if (extensionOf(data) != ".bricks" || !isRegularFile(data))
        return nullptr;
    checkFirstBrick(data);
    return openBeside(data, false);
}

std::unique_ptr<DataSet> openCells(const std::string& data)
{
    if (extensionOf(data) != ".cells" || !isRegularFile(data))
        return nullptr;
    checkFirstCell(data);
    return openBeside(data, true);
}

std::unique_ptr<DataSet> openExaPart(const std::string& data)
{
    const std::string extension = extensionOf(data);
    if (!isRegularFile(data))
        return nullptr;
    if (extension == ".scalars" || extension == ".scalar")
        throw Error(data, "has values but no cells; " + advice(data));
    if (extension == ".tris")
        throw Error(data, "has triangles but no cells; name it in an .exa file, with the keyword triangles");
    return nullptr;
}

} // namespace brickwall
