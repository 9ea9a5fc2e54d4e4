// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/OutputFile.h"
#include "brickwall/core/io/Writers.h"

#include <openvdb/io/Archive.h>
#include <openvdb/io/GridDescriptor.h>
#include <openvdb/io/io.h>
#include <openvdb/openvdb.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <ostream>
#include <set>
#include <streambuf>
#include <vector>

namespace brickwall {
namespace {

/// A stream into an OutputFile, so that a full disk and Ctrl-C reach the caller through OpenVDB as the exceptions that
/// they are.
class FileBuffer : public std::streambuf
{
public:
    FileBuffer(OutputFile& file, const Progress& progress) : file_(file), progress_(progress), bytes_(1 << 20)
    {
        setp(bytes_.data(), bytes_.data() + bytes_.size());
    }

protected:
    int_type overflow(int_type c) override
    {
        sync();
        if (!traits_type::eq_int_type(c, traits_type::eof()))
            sputc(traits_type::to_char_type(c));
        return traits_type::not_eof(c);
    }

    int sync() override
    {
        progress_.check();
        const auto count = static_cast<std::size_t>(pptr() - pbase());
        file_.writeAt(begin_, std::as_bytes(std::span(pbase(), count)));
        begin_ += count;
        setp(bytes_.data(), bytes_.data() + bytes_.size());
        return 0;
    }

    pos_type seekoff(off_type offset, std::ios_base::seekdir direction, std::ios_base::openmode) override
    {
        const auto here = static_cast<off_type>(begin_) + (pptr() - pbase());
        end_ = std::max(end_, here);
        if (direction == std::ios_base::cur && offset == 0)
            return here;
        const off_type from = direction == std::ios_base::beg ? 0 : direction == std::ios_base::cur ? here : end_;
        sync();
        begin_ = static_cast<std::uint64_t>(from + offset);
        return from + offset;
    }

    pos_type seekpos(pos_type position, std::ios_base::openmode mode) override
    {
        return seekoff(off_type(position), std::ios_base::beg, mode);
    }

private:
    OutputFile& file_;
    const Progress& progress_;
    std::vector<char> bytes_;
    std::uint64_t begin_ = 0; ///< where in the file the buffer begins
    off_type end_ = 0;
};

/// OpenVDB's own writer takes all grids at once; this one takes them one by one, so that one is in memory.
class GridByGrid : public openvdb::io::Archive
{
public:
    void begin(std::ostream& out, std::int32_t gridCount)
    {
        metadata_ = std::make_shared<openvdb::io::StreamMetadata>();
        openvdb::io::setStreamMetadataPtr(out, metadata_, false); // which keeps a pointer to it
        openvdb::io::setDataCompression(out, compression());
        openvdb::io::setWriteGridStatsMetadata(out, isGridStatsMetadataEnabled());
        writeHeader(out, true);
        openvdb::MetaMap metadata;
        metadata.insertMeta("creator", openvdb::StringMetadata("brickwall"));
        metadata.writeMeta(out);
        out.write(reinterpret_cast<const char*>(&gridCount), sizeof gridCount);
    }

    void add(std::ostream& out, const openvdb::FloatGrid::ConstPtr& grid)
    {
        openvdb::io::GridDescriptor descriptor(grid->getName(), grid->type(), false);
        writeGrid(descriptor, grid, out, true);
        openvdb::io::setDataCompression(out, compression()); // which is set for each grid
    }

private:
    openvdb::io::StreamMetadata::Ptr metadata_;
};

/// Writes one FloatGrid per field and level, "NAME_L0" being the coarsest level that there is: active voxels are cells,
/// voxel (i,j,k) is that of the level's index i, j, k in voxel space, its centre at origin + (i+1/2) dx. Memory: the
/// tree of one level besides the field.
class VdbWriter : public Writer
{
public:
    VdbWriter(const Output& output, OutputFiles& files, Progress& progress)
        : output_(output),
          widths_(voxelWidths(output.model, ".vdb", output.path)),
          file_(files.file(output.path), output.path),
          buffer_(file_, progress),
          out_(&buffer_)
    {
        for (const Brick& brick : output.cells.bricks)
            levels_.insert(brick.level);
        if (output.fieldNames.empty())
            throw Error(output.path, "expected fields to write; the cells alone have no place in .vdb");
        openvdb::initialize();
        out_.exceptions(std::ios_base::badbit | std::ios_base::failbit);
        archive_.begin(out_, static_cast<std::int32_t>(levels_.size() * output.fieldNames.size()));
    }

    void write(const SelectedValues& values, const Executor&, Progress& progress) override
    {
        progress.begin(fmt::format("writing {}", values.field().name), output_.cells.cellCount);
        int number = 0;
        for (const int level : levels_) {
            const openvdb::FloatGrid::Ptr grid = gridOf(level, number, values, progress);
            grid->setName(fmt::format("{}_L{}", values.field().name, number++));
            archive_.add(out_, grid);
        }
        progress.end();
    }

    void finish() override
    {
        out_.flush();
        file_.close();
    }

private:
    openvdb::FloatGrid::Ptr gridOf(int level, int number, const SelectedValues& values, Progress& progress) const
    {
        const auto grid = openvdb::FloatGrid::create(0.0f);
        fill(*grid, level, values, progress);
        const vec3d size = widths_ * double(1 << level);
        const vec3d origin = transformPoint(output_.model.worldFromVoxel, vec3d(0));
        const vec3d centre = origin + size / 2.0;
        const bool cubes = size.x == size.y && size.x == size.z;
        openvdb::math::MapBase::Ptr map;
        if (cubes)
            map.reset(new openvdb::math::UniformScaleTranslateMap(size.x, {centre.x, centre.y, centre.z}));
        else
            map.reset(new openvdb::math::ScaleTranslateMap({size.x, size.y, size.z}, {centre.x, centre.y, centre.z}));
        grid->setTransform(openvdb::math::Transform::Ptr(new openvdb::math::Transform(map)));
        grid->setGridClass(openvdb::GRID_FOG_VOLUME);
        grid->insertMeta("amr_level", openvdb::Int32Metadata(number));
        if (cubes)
            grid->insertMeta("dx", openvdb::DoubleMetadata(size.x));
        else
            grid->insertMeta("dx", openvdb::Vec3DMetadata({size.x, size.y, size.z}));
        grid->insertMeta("origin", openvdb::Vec3DMetadata({origin.x, origin.y, origin.z}));
        grid->insertMeta("refinement_ratio", openvdb::Int32Metadata(ratioBelow(level)));
        if (!values.field().unit.empty())
            grid->insertMeta("unit", openvdb::StringMetadata(values.field().unit));
        return grid;
    }

    /// How much finer the next level is; 2 for the finest.
    int ratioBelow(int level) const
    {
        const auto next = std::next(levels_.find(level));
        return next == levels_.end() ? 2 : 1 << (level - *next);
    }

    void fill(openvdb::FloatGrid& grid, int level, const SelectedValues& values, Progress& progress) const
    {
        auto accessor = grid.getAccessor();
        std::vector<float> piece;
        for (std::size_t b = 0; b < output_.cells.bricks.size(); ++b) {
            const Brick& brick = output_.cells.bricks[b];
            if (brick.level != level)
                continue;
            const vec3i lower = brick.lower / brick.cellWidth();
            const std::uint64_t count = brick.cellCount();
            for (std::uint64_t first = 0; first < count; first += piece.size()) {
                progress.check();
                piece.resize(std::min<std::uint64_t>(cellsAtOnce, count - first));
                values.read(b, first, piece);
                for (std::size_t i = 0; i < piece.size(); ++i) {
                    const std::uint64_t cell = first + i, row = cell / brick.size.x;
                    const vec3i at = lower + vec3i(cell % brick.size.x, row % brick.size.y, row / brick.size.y);
                    accessor.setValueOn({at.x, at.y, at.z}, piece[i]);
                }
                progress.advance(piece.size());
            }
        }
    }

    const Output& output_;
    vec3d widths_;                         ///< of voxels
    std::set<int, std::greater<>> levels_; ///< that have cells, coarse to fine
    OutputFile file_;
    FileBuffer buffer_;
    GridByGrid archive_; // before the stream that points to it
    std::ostream out_;
};

} // namespace

std::unique_ptr<Writer> makeVdbWriter(const Output& output, OutputFiles& files, const Executor&, Progress& progress)
{
    return std::make_unique<VdbWriter>(output, files, progress);
}

} // namespace brickwall
