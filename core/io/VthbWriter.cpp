// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/VtiPieces.h"
#include "brickwall/core/io/Writers.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

namespace brickwall {
namespace {

/// Writes BASE.vthb, vtkOverlappingAMR 1.1, and a folder BASE with a piece BASE_N.vti for each brick. VTK's levels
/// count from the coarsest that there is. Boxes are leaves: there are no coarse data under fine ones.
class VthbWriter : public Writer
{
public:
    VthbWriter(const Output& output, OutputFiles& files, const Executor& executor, Progress& progress)
        : output_(output), executor_(executor), widths_(voxelWidths(output.model, ".vthb", output.path))
    {
        const std::filesystem::path base = std::filesystem::path(output.path).replace_extension();
        stem_ = base.filename().string();
        const std::string folder = files.folder(base.string(), stem_ + "_", ".vti");
        vthb_ = files.file(output.path);
        placeOrigin();
        for (std::size_t b = 0; b < output.cells.bricks.size(); ++b)
            pieces_.push_back(pieceOf(b, folder, base.string()));
        forEachBrick([&](std::size_t b) {
            progress.check();
            pieces_[b].create();
        });
    }

    void write(const SelectedValues& values, const Executor&, Progress& progress) override
    {
        progress.begin(fmt::format("writing {}", values.field().name), output_.cells.cellCount);
        forEachBrick([&](std::size_t b) { pieces_[b].append(written_, values, b, progress); });
        ++written_;
        progress.end();
    }

    void finish() override
    {
        forEachBrick([&](std::size_t b) { pieces_[b].finish(); });
        OutputFile file(vthb_, output_.path);
        file.append(bytesOf(head()));
        file.close();
    }

private:
    void forEachBrick(const std::function<void(std::size_t)>& body) const
    {
        executor_.forEach(pieces_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b)
                body(b);
        });
    }

    /// VTK's boxes count from the origin, which the cells of all levels share a corner with.
    void placeOrigin()
    {
        int coarsest = 0;
        for (const Brick& brick : output_.cells.bricks)
            coarsest = std::max(coarsest, brick.level);
        const vec3i lower = voxelBounds(output_.cells.bricks).lower;
        for (int axis = 0; axis < 3; ++axis)
            origin_[axis] = (lower[axis] >> coarsest) * (1 << coarsest); // towards minus infinity
    }

    vec3d world(const vec3i& voxel) const { return transformPoint(output_.model.worldFromVoxel, vec3d(voxel)); }

    std::string pieceName(std::size_t brick) const { return fmt::format("{}_{}.vti", stem_, brick); }

    VtiPiece pieceOf(std::size_t brick, const std::string& folder, const std::string& finalFolder) const
    {
        const Brick& b = output_.cells.bricks[brick];
        const std::string name = pieceName(brick);
        return {(std::filesystem::path(folder) / name).string(),
                (std::filesystem::path(finalFolder) / name).string(),
                b.size,
                world(b.lower),
                widths_ * double(b.cellWidth()),
                output_.fieldNames,
                output_.compress};
    }

    std::string head() const
    {
        const vec3d origin = world(origin_);
        std::string text = fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkOverlappingAMR\" version=\"1.1\" "
                                       "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
                                       "  <vtkOverlappingAMR origin=\"{} {} {}\" grid_description=\"XYZ\">\n",
                                       origin.x, origin.y, origin.z);
        std::map<int, std::vector<std::size_t>, std::greater<>> byLevel; // coarse to fine
        for (std::size_t b = 0; b < output_.cells.bricks.size(); ++b)
            byLevel[output_.cells.bricks[b].level].push_back(b);
        int number = 0;
        for (const auto& [level, bricks] : byLevel) {
            const vec3d spacing = widths_ * double(1 << level);
            text += fmt::format("    <Block level=\"{}\" spacing=\"{} {} {}\">\n", number++, spacing.x, spacing.y,
                                spacing.z);
            for (std::size_t i = 0; i < bricks.size(); ++i)
                text += dataSet(i, bricks[i]);
            text += "    </Block>\n";
        }
        return text + "  </vtkOverlappingAMR>\n</VTKFile>\n";
    }

    std::string dataSet(std::size_t index, std::size_t brick) const
    {
        const Brick& b = output_.cells.bricks[brick];
        const vec3i low = (b.lower - origin_) / b.cellWidth(), high = low + b.size - 1;
        return fmt::format("      <DataSet index=\"{}\" amr_box=\"{} {} {} {} {} {}\" file=\"{}/{}\"/>\n", index, low.x,
                           high.x, low.y, high.y, low.z, high.z, xmlAttribute(stem_), xmlAttribute(pieceName(brick)));
    }

    const Output& output_;
    const Executor& executor_;
    vec3d widths_; ///< of voxels
    std::string stem_, vthb_;
    vec3i origin_{0};
    std::vector<VtiPiece> pieces_;
    std::size_t written_ = 0;
};

} // namespace

std::unique_ptr<Writer> makeVthbWriter(const Output& output, OutputFiles& files, const Executor& executor,
                                       Progress& progress)
{
    return std::make_unique<VthbWriter>(output, files, executor, progress);
}

} // namespace brickwall
