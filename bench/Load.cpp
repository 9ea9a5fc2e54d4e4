// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What it takes to load a field of an AMReX plotfile on all cores, against reading the same bytes by one: that is
/// "ratio", the median, with the least and the most. Both take turns; the files are in memory after the first turn.
#include "brickwall/bench/Clock.h"
#include "brickwall/core/io/AmrexFab.h"
#include "brickwall/core/io/AmrexLevels.h"
#include "brickwall/core/io/DataSet.h"
#include "brickwall/tests/oracles/WriteAmrex.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

namespace brickwall {
namespace {

namespace fs = std::filesystem;

std::vector<Box3i> blocks(const vec3i& size, int width)
{
    std::vector<Box3i> boxes;
    for (int z = 0; z < size.z; z += width)
        for (int y = 0; y < size.y; y += width)
            for (int x = 0; x < size.x; x += width)
                boxes.push_back({vec3i(x, y, z), vec3i(x, y, z) + width});
    return boxes;
}

/// Three levels in two fields: the second covers half of the first, the third a quarter of the second's half.
oracles::Plotfile3 plotfile(int coarseWidth, bool floats)
{
    const int n = coarseWidth, box = n >= 256 ? 64 : 32;
    oracles::Plotfile3 p;
    p.components = {"density", "pressure"};
    p.domain = {vec3i(0), vec3i(n)};
    p.ratios = {2, 2};
    p.boxes = {blocks(vec3i(n), box), blocks({2 * n, 2 * n, n}, box), blocks({2 * n, n, n}, box)};
    p.value = [](int level, int component, const vec3i& c) {
        return level + 0.5 * component + 1e-3 * (c.x ^ c.y ^ c.z);
    };
    p.floats = floats;
    return p;
}

/// A file in a folder of its own that goes with it.
class WrittenPlotfile
{
public:
    WrittenPlotfile(int coarseWidth, bool floats)
    {
        std::string name = (fs::temp_directory_path() / "brickwall_bench_XXXXXX").string();
        if (!mkdtemp(name.data()))
            throw std::runtime_error("cannot make a temporary folder");
        folder_ = name;
        oracles::writePlotfile(path(), plotfile(coarseWidth, floats));
    }
    ~WrittenPlotfile() { fs::remove_all(folder_); }
    WrittenPlotfile(const WrittenPlotfile&) = delete;
    WrittenPlotfile& operator=(const WrittenPlotfile&) = delete;

    std::string path() const { return (folder_ / "plt").string(); }

private:
    fs::path folder_;
};

struct Piece
{
    std::string file;
    std::uint64_t offset = 0, bytes = 0;
};

/// Where the values of the first field lie that loading it has to read.
std::vector<Piece> piecesOf(const std::string& folder)
{
    Progress silent;
    const Executor serial(1);
    const AmrexLevels levels = readAmrexLevels(folder, readAmrexHeader(folder + "/Header"), silent);
    const LeafPlan plan = planLeaves(levels.boxes, folder, serial, silent);
    std::vector<Piece> pieces;
    for (const LeafJob& job : plan.jobs) {
        const AmrexCells& cells = levels.cells[job.levelIndex];
        const AmrexFab& fab = cells.fabs[job.box];
        const std::string file = levels.folders[job.levelIndex] + "/" + cells.files[fab.file];
        const FabLayout layout = readFabLayout(InputFile(file), fab.offset);
        pieces.push_back({file, layout.offset, std::uint64_t(volume(layout.box)) * std::uint64_t(layout.bytes)});
    }
    return pieces;
}

void readAll(const std::vector<Piece>& pieces)
{
    std::vector<std::byte> buffer(std::size_t(1) << 20);
    std::unique_ptr<InputFile> file;
    for (const Piece& piece : pieces) {
        if (!file || file->path() != piece.file)
            file = std::make_unique<InputFile>(piece.file);
        for (std::uint64_t done = 0; done < piece.bytes;) {
            const std::uint64_t n = std::min<std::uint64_t>(buffer.size(), piece.bytes - done);
            file->readAt(piece.offset + done, std::span(buffer).first(n), "bytes");
            done += n;
        }
    }
    benchmark::DoNotOptimize(buffer.data());
}

/// state.range(0) is the width of the coarsest level: 128 makes 13 million cells that are not covered, 256 105 million.
void loadPlotfile(benchmark::State& state, bool floats)
{
    const WrittenPlotfile written(static_cast<int>(state.range(0)), floats);
    const std::vector<Piece> pieces = piecesOf(written.path());
    const std::vector<std::string> wanted{"density"};
    const Executor all;
    Progress silent;
    std::vector<double> reads, ratios;
    std::uint64_t cells = 0;
    readAll(pieces);
    for (auto _ : state) {
        reads.push_back(bench::secondsOf(CLOCK_MONOTONIC, [&] { readAll(pieces); }));
        const double load = bench::secondsOf(CLOCK_MONOTONIC, [&] {
            const Model model = openDataSet(written.path())->load(wanted, all, silent);
            cells = model.cellCount;
        });
        ratios.push_back(load / reads.back());
        state.SetIterationTime(load);
    }
    std::sort(reads.begin(), reads.end());
    std::sort(ratios.begin(), ratios.end());
    using benchmark::Counter;
    state.counters["cells"] = Counter(double(cells) * double(ratios.size()), Counter::kIsRate);
    state.counters["read"] = reads[reads.size() / 2];
    state.counters["ratio"] = ratios[ratios.size() / 2];
    state.counters["least"] = ratios.front();
    state.counters["most"] = ratios.back();
}

// So many turns at once, as each call writes the file anew.
BENCHMARK_CAPTURE(loadPlotfile, doubles, false)
    ->Arg(128)
    ->Arg(256)
    ->Iterations(31)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(loadPlotfile, floats, true)->Arg(128)->Iterations(31)->UseManualTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace brickwall
