// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Lists of a million boxes that mean harm: the command refuses them in one line, within a second of its processors and
/// 100 MB.
#include "RunCommand.h"

#include "brickwall/core/base/Box.h"
#include "brickwall/tests/common/EditFile.h"
#include "brickwall/tests/oracles/WriteAmrex.h"
#include "brickwall/tests/oracles/WriteChombo.h"
#include "brickwall/tests/oracles/WriteExa.h"
#include "brickwall/tests/oracles/WriteFlash.h"
#include "brickwall/tests/oracles/WriteHdf5.h"
#include "brickwall/tests/oracles/WriteVtkHdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace brickwall {
namespace {

using namespace oracles;
using namespace brickwall::testing;

constexpr int million = 1'000'000;

#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr bool measured = true;
#else
constexpr bool measured = false; // sanitizers and assertions take what they take
#endif

/// Boxes that are alike; overlap the one before; lie apart, but have 2^35 cells; are fine up to the last, which has
/// none.
enum class Harm { alike, overlapping, huge, negative };

Box3i boxOf(Harm harm, int i)
{
    switch (harm) {
    case Harm::alike:
        return {vec3i(0), vec3i(8)};
    case Harm::overlapping:
        return {vec3i(i, i / 3, 0), vec3i(i, i / 3, 0) + 2};
    case Harm::huge:
        return {vec3i(i % 100, i / 100 % 100, i / 10000) * 32, vec3i(i % 100, i / 100 % 100, i / 10000) * 32 + 32};
    default:
        return {vec3i(i, 0, 0), vec3i(i + 1, i + 1 < million ? 1 : -1, 1)};
    }
}

/// In a process of its own: the peak memory of this one would count as the command's, whose first image it is.
template <class Write>
void writeApart(const Write& write)
{
    const pid_t writer = ::fork();
    if (writer == 0) {
        write();
        ::_exit(0);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(writer, &status, 0), writer);
    ASSERT_EQ(status, 0);
}

struct Refusal
{
    int exitCode = -1;
    std::string message;
    double seconds = 0.0, megabytes = 0.0; ///< of its processors, and at its peak
};

/// Runs `brickwall info PATH`.
Refusal refusalOf(const std::string& path)
{
    const std::string err = (scratchFolder() / "stderr").string();
    const pid_t command = ::fork();
    if (command == 0) {
        const int file = ::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
        ::dup2(file, STDERR_FILENO);
        ::execl(BRICKWALL_COMMAND, BRICKWALL_COMMAND, "info", path.c_str(), static_cast<char*>(nullptr));
        ::_exit(127);
    }
    int status = -1;
    rusage used = {};
    EXPECT_EQ(::wait4(command, &status, 0, &used), command);
    const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, messageOf({0, "", contentOf(err)}),
            seconds(used.ru_utime) + seconds(used.ru_stime), double(used.ru_maxrss) / 1024};
}

/// Expects that the command fails within the limits, with a line that says these words. Not what a clock says counts,
/// as other tests run as well; and since they slow down its processors, the best of three runs.
void expectRefusal(const std::string& path, const std::vector<std::string>& words)
{
    Refusal refusal = refusalOf(path);
    for (int again = 0; again < 2 && refusal.seconds > 1.0; ++again)
        refusal = refusalOf(path);
    EXPECT_EQ(refusal.exitCode, 2);
    const std::string& message = refusal.message;
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
    for (const std::string& word : words)
        EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
    std::cout << fmt::format("{:.2f} s, {:.0f} MB: {}", refusal.seconds, refusal.megabytes, message);
    if (measured) {
        EXPECT_LT(refusal.seconds, 1.0);
        EXPECT_LT(refusal.megabytes, 100.0);
    }
}

std::string chombo(Harm harm)
{
    const std::string path = (scratchFolder() / "plt.hdf5").string();
    writeApart([&] {
        writeChombo(path, {});
        std::vector<std::int64_t> numbers;
        for (int i = 0; i < million; ++i) {
            const Box3i b = boxOf(harm, i);
            numbers.insert(numbers.end(),
                           {b.lower.x, b.lower.y, b.lower.z, b.upper.x - 1, b.upper.y - 1, b.upper.z - 1});
        }
        Hdf5Writer file(path, Hdf5Writer::Mode::edit);
        file.remove("level_0/boxes");
        file.records("level_0/boxes", {"lo_i", "lo_j", "lo_k", "hi_i", "hi_j", "hi_k"}, numbers);
    });
    return path;
}

std::string vtkHdf(Harm harm)
{
    const std::string path = (scratchFolder() / "amr.vtkhdf").string();
    writeApart([&] {
        writeVtkHdf(path, {VtkAmr3{}});
        std::vector<double> numbers;
        for (int i = 0; i < million; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                numbers.push_back(boxOf(harm, i).lower[axis]);
                numbers.push_back(boxOf(harm, i).upper[axis] - 1);
            }
        Hdf5Writer file(path, Hdf5Writer::Mode::edit);
        file.remove("VTKHDF/Level0/AMRBox");
        file.numbers("VTKHDF/Level0/AMRBox", {million, 6}, numbers, Hdf5Number::int32);
    });
    return path;
}

std::string amrex(Harm harm)
{
    const std::string folder = (scratchFolder() / "plt00000").string();
    writeApart([&] {
        writePlotfile(folder, {});
        std::string bounds, cells = fmt::format("1\n1\n1\n0\n({} 0\n", million);
        for (int i = 0; i < million; ++i) {
            const Box3i b = boxOf(harm, i);
            bounds += "0 0.125\n0 0.125\n0 0.125\n";
            cells += fmt::format("(({},{},{}) ({},{},{}) (0,0,0))\n", b.lower.x, b.lower.y, b.lower.z, b.upper.x - 1,
                                 b.upper.y - 1, b.upper.z - 1);
        }
        cells += fmt::format(")\n{}\n", million);
        for (int i = 0; i < million; ++i)
            cells += fmt::format("FabOnDisk: Cell_D_00000 {}\n", i);
        editFile(folder + "/Header", "\n0 1 0.25\n7\n0 8\n0 8\n0 8\n",
                 fmt::format("\n0 {} 0.25\n7\n{}", million, bounds));
        writeText(folder + "/Level_0/Cell_H", cells);
    });
    return folder;
}

TEST(LongTables, OfChombo)
{
    expectRefusal(chombo(Harm::alike), {"/level_0/boxes", "boxes 0 and 1", "overlap"});
    expectRefusal(chombo(Harm::overlapping), {"/level_0/boxes", "boxes 0 and 1", "overlap"});
    expectRefusal(chombo(Harm::huge), {"plt.hdf5", "2^32 cells", "32768000000"});
    expectRefusal(chombo(Harm::negative), {"/level_0/boxes", "box 999999", "from low to high"});
}

TEST(LongTables, OfVtkHdf)
{
    expectRefusal(vtkHdf(Harm::alike), {"/AMRBox", "boxes 0 and 1", "overlap"});
    expectRefusal(vtkHdf(Harm::overlapping), {"/AMRBox", "boxes 0 and 1", "overlap"});
    expectRefusal(vtkHdf(Harm::huge), {"amr.vtkhdf", "2^32 cells", "32768000000"});
    expectRefusal(vtkHdf(Harm::negative), {"/AMRBox", "box 999999", "from low to high"});
}

TEST(LongTables, OfAmrex)
{
    expectRefusal(amrex(Harm::alike), {"Level_0/Cell_H", "boxes 0 and 1", "overlap"});
    expectRefusal(amrex(Harm::overlapping), {"Level_0/Cell_H", "boxes 0 and 1", "overlap"});
    expectRefusal(amrex(Harm::huge), {"Level_0/Cell_H", "2^32 cells", "32768000000"});
    expectRefusal(amrex(Harm::negative), {"Level_0/Cell_H:1000005", "expected a box with cells", "0 to -2 along y"});
}

TEST(LongTables, OfFlash)
{
    const std::string path = (scratchFolder() / "plt_cnt_0001").string();
    const auto write = [&](bool refined) {
        writeApart([&] {
            writeFlash(path, {});
            Hdf5Writer file(path, Hdf5Writer::Mode::edit);
            for (const char* name : {"refine level", "node type", "bounding box", "dens"})
                file.remove(name);
            std::vector<double> levels(million, 1.0), bounds;
            for (int i = 0; i < million; ++i)
                bounds.insert(bounds.end(), {0, 1, 0, 1, 0, 1});
            if (refined)
                levels.back() = 40;
            file.numbers("refine level", {million}, levels, Hdf5Number::int32);
            file.numbers("node type", {million}, std::vector<double>(million, 1.0), Hdf5Number::int32);
            file.numbers("bounding box", {million, 3, 2}, bounds, Hdf5Number::float32);
            file.numbers("dens", {million, 2, 2, 2}, std::vector<double>(8 * million), Hdf5Number::float32);
        });
    };
    write(false);
    expectRefusal(path, {"leaves that do not overlap", "box 0", "box 1 of"});
    write(true);
    expectRefusal(path, {"/refine level", "at most 25 levels", "1 to 40"});
}

TEST(LongTables, OfBricks)
{
    const std::string path = (scratchFolder() / "data.bricks").string();
    const auto write = [&](const BrickRecord& last) {
        writeApart([&] {
            std::vector<BrickRecord> records;
            for (int i = 0; i < million; ++i)
                records.push_back({vec3i(1), vec3i(0), 0, {i}});
            records.back() = last;
            writeBricks(path, records);
            writeScalars((scratchFolder() / "data.scalars").string(), std::vector<float>(million));
        });
    };
    write({vec3i(1), vec3i(0), 0, {0}});
    expectRefusal(path, {"data.bricks", "disjoint bricks", "brick 0", "brick 1"});
    write({vec3i(1, -1, 1), vec3i(0), 0, {0}});
    expectRefusal(path, {"data.bricks", "brick record 999999", "positive size"});
}

TEST(LongTables, OfVtkLists)
{
    const std::string path = (scratchFolder() / "amr.vthb").string();
    const auto write = [&](int pieces) {
        writeApart([&] {
            std::string list =
                "<VTKFile type=\"vtkOverlappingAMR\" version=\"1.1\">\n<vtkOverlappingAMR origin=\"0 0 0\" "
                "grid_description=\"XYZ\">\n<Block level=\"0\" spacing=\"1 1 1\">\n";
            for (int i = 0; i < pieces; ++i)
                list += fmt::format("<DataSet index=\"{}\" amr_box=\"0 7 0 7 0 7\" file=\"a/a_{}.vti\"/>\n", i, i);
            writeText(path, list + "</Block>\n</vtkOverlappingAMR>\n</VTKFile>\n");
        });
    };
    write(million);
    expectRefusal(path, {"amr.vthb", "at most", "bytes"});
    write(million / 9);
    expectRefusal(path, {"amr.vthb", "boxes 0 and 1", "overlap"});
}

} // namespace
} // namespace brickwall
