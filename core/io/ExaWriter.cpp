// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/OutputFile.h"
#include "brickwall/core/io/Writers.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>
#include <set>

namespace brickwall {
namespace {

/// Writes BASE.exa with BASE.bricks, a BASE.NAME.scalars for each field and, if there are meshes, BASE.tris. The cell
/// ID of a cell is the number of its value.
class ExaWriter : public Writer
{
public:
    ExaWriter(const Output& output, OutputFiles& files, Progress& progress)
        : output_(output), progress_(progress), base_(baseOf(output.path))
    {
        constexpr std::uint64_t mostCells = std::numeric_limits<std::int32_t>::max();
        if (output.cells.cellCount > mostCells)
            throw Error(output.path, fmt::format("ExaBrick has no more than {} cells, found {}; choose fewer, or write "
                                                 ".brickwall",
                                                 mostCells, output.cells.cellCount));
        // The order of appearance: .bricks alone could be opened too, with the .scalars that happen to be there.
        for (const std::string& name : output.fieldNames)
            addScalars(name, files);
        if (!output.model.meshes.empty())
            triangles_ = files.file(base_ + ".tris");
        bricks_ = files.file(base_ + ".bricks");
        exa_ = files.file(output.path);
        text_ = "# written by brickwall\n" + remap();
    }

    void write(const SelectedValues& values, const Executor& executor, Progress& progress) override
    {
        const Scalars& scalars = scalars_[written_++];
        progress.begin(fmt::format("writing {}", values.field().name), output_.cells.cellCount);
        OutputFile file(scalars.temporary, scalars.path);
        forEachPiece(output_.cells, values, executor, progress,
                     [&](std::size_t brick, std::uint64_t first, std::span<const float> piece) {
                         file.writeAt((output_.cells.bricks[brick].begin + first) * sizeof(float), bytesOf(piece));
                     });
        file.close();
        progress.end();
        text_ += fmt::format("scalar {} {}\n", scalars.name, std::filesystem::path(scalars.path).filename().string());
        const Range& shown = values.field().preferredRange;
        if (!shown.empty() && shown.lo < shown.hi)
            text_ += fmt::format("value_range {} {}\n", shown.lo, shown.hi);
    }

    void finish() override
    {
        writeBricks();
        text_ += fmt::format("bricks {}.bricks\n", stem());
        if (!triangles_.empty())
            writeTriangles();
        OutputFile file(exa_, output_.path);
        file.append(bytesOf(text_));
        file.close();
    }

private:
    struct Scalars
    {
        std::string name; ///< a word: the .exa file is made of words
        std::string path, temporary;
    };

    /// The parts' names are words too.
    static std::string baseOf(const std::string& exa)
    {
        const std::filesystem::path path(exa);
        return (path.parent_path() / fileNamePart(path.stem().string())).string();
    }

    std::string stem() const { return std::filesystem::path(base_).filename().string(); }

    void addScalars(const std::string& name, OutputFiles& files)
    {
        const auto known = [&](const std::string& candidate) {
            return std::ranges::any_of(scalars_, [&](const Scalars& s) { return s.name == candidate; });
        };
        std::string word = fileNamePart(name);
        for (int n = 2; known(word); ++n)
            word = fmt::format("{}_{}", fileNamePart(name), n);
        if (word != name)
            progress_.note(fmt::format("{}: field '{}' is called {} there", output_.path, name, word));
        const std::string path = fmt::format("{}.{}.scalars", base_, word);
        scalars_.push_back({word, path, files.file(path)});
    }

    /// The transform as two boxes. One starts at voxel 0 and has a power of two as its width, which keeps the numbers
    /// exact where the other starts at 0 as well, and to the last digits otherwise.
    std::string remap() const
    {
        const mat4d& m = output_.model.worldFromVoxel;
        if (m == mat4d(1.0))
            return {};
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r)
                if (c != r && m[c][r] != 0.0)
                    throw Error(output_.path, "ExaBrick has no place for data whose axes are turned against the world; "
                                              "write .brickwall");
        const Box3i voxels = voxelBounds(output_.cells.bricks);
        int width = 1;
        for (int axis = 0; axis < 3; ++axis)
            while (width < voxels.upper[axis] && width < coordinateLimit)
                width *= 2;
        const vec3d a = transformPoint(m, vec3d(0)), b = transformPoint(m, vec3d(width));
        return fmt::format("remap_from 0 0 0 {0} {0} {0}\nremap_to {1} {2} {3} {4} {5} {6}\n", width, a.x, a.y, a.z,
                           b.x, b.y, b.z);
    }

    void writeBricks()
    {
        progress_.begin("writing bricks", output_.cells.cellCount);
        OutputFile file(bricks_, base_ + ".bricks");
        std::vector<std::int32_t> ids;
        for (const Brick& b : output_.cells.bricks) {
            const std::array<std::int32_t, 7> header{b.size.x,  b.size.y,  b.size.z, b.lower.x,
                                                     b.lower.y, b.lower.z, b.level};
            file.append(bytesOf(std::span(header)));
            for (std::uint64_t first = 0; first < b.cellCount(); first += ids.size()) {
                progress_.check();
                ids.resize(std::min<std::uint64_t>(cellsAtOnce, b.cellCount() - first));
                std::iota(ids.begin(), ids.end(), static_cast<std::int32_t>(b.begin + first));
                file.append(bytesOf(std::span(ids)));
                progress_.advance(ids.size());
            }
        }
        file.close();
        progress_.end();
    }

    void writeTriangles()
    {
        OutputFile file(triangles_, base_ + ".tris");
        for (const TriangleMesh& mesh : output_.model.meshes) {
            const auto count = [&](std::size_t n) {
                const std::array<std::int32_t, 1> number{static_cast<std::int32_t>(n)};
                file.append(bytesOf(std::span(number)));
            };
            count(mesh.vertices.size());
            file.append(bytesOf(std::span(mesh.vertices)));
            count(mesh.triangles.size());
            file.append(bytesOf(std::span(mesh.triangles)));
        }
        file.close();
        text_ += fmt::format("triangles {}.tris\n", stem());
    }

    const Output& output_;
    Progress& progress_;
    std::string base_;
    std::vector<Scalars> scalars_;
    std::string bricks_, triangles_, exa_; ///< temporary names
    std::size_t written_ = 0;
    std::string text_;
};

} // namespace

std::unique_ptr<Writer> makeExaWriter(const Output& output, OutputFiles& files, const Executor&, Progress& progress)
{
    return std::make_unique<ExaWriter>(output, files, progress);
}

} // namespace brickwall
