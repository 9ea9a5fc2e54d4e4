// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/io/ConvertTesting.h"
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/RealFiles.h"

#include <glm/gtc/matrix_transform.hpp>

#include <atomic>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <span>

namespace brickwall {
namespace {

using namespace convert_test;
using namespace oracles;

/// Three levels that touch, away from the origin, cells wider along x, with values that formats like to lose.
Model oracleModel()
{
    std::vector<Brick> bricks = oneLevelBricks(vec3i(-2, 0, 1), vec3i(2), vec3i(2), 2); // x -8..0
    for (const Brick& b : oneLevelBricks(vec3i(0, 0, 2), vec3i(5, 3, 4), vec3i(3), 1))  // x 0..10
        bricks.push_back(b);
    for (const Brick& b : oneLevelBricks(vec3i(10, 1, 3), vec3i(7, 5, 3), vec3i(4), 0)) // x 10..17
        bricks.push_back(b);
    const mat4d transform = glm::scale(glm::translate(mat4d(1.0), vec3d(0.1, -3, 1e5)), vec3d(0.75, 0.5, 0.5));
    Model model = modelOf(
        bricks, [](const vec3d& p) { return p.x + 100 * p.y + 0.1 * p.z; }, transform);
    model.name = "oracle";
    Field& first = model.fields[0];
    first.unit = "cm/s";
    first.preferredRange = {-1.5f, 2.5f};
    first.values[0] = -0.0f;
    first.values[1] = 0.0f;
    first.values[2] = std::numeric_limits<float>::denorm_min();
    first.values[3] = std::numeric_limits<float>::max();
    first.range = rangeOf(first.values);
    Field second = first;
    second.name = "second & <field>";
    for (float& v : second.values)
        v = -v;
    second.range = rangeOf(second.values);
    model.fields.push_back(second);
    return model;
}

/// Whether there is a reader for what was written; other readers are somebody else's file.
bool canBeRead(const std::string& file)
{
    Progress silent;
    try {
        openDataSet(file);
    } catch (const Error& error) {
        return std::string(error.what()).find("is of no format") == std::string::npos;
    }
    return true;
}

/// A conversion into each format, and back.
class Convert : public testing::TestWithParam<const char*>
{
protected:
    std::string destination() const { return testFolder() + "/out" + GetParam(); }

    void expectRoundTrip(const DataSet& source, const Texts& fields, ConvertOptions options = {})
    {
        options.fields = fields;
        options.overwrite = true;
        convertTo(destination(), source, options);
        if (!canBeRead(destination()))
            GTEST_SKIP() << "there is no reader for " << GetParam();
        const auto back = openDataSet(destination());
        ASSERT_EQ(back->fieldNames().size(), fields.size());
        expectSame(loaded(*back, back->fieldNames()), loaded(source, fields));
    }
};

TEST_P(Convert, ThereAndBackKeepsEveryCellOfSeveralLevels)
{
    const ModelData source(oracleModel());
    expectRoundTrip(source, source.fieldNames());
}

TEST_P(Convert, ThereAndBackKeepsTheSamples)
{
    for (const char* sample : {"sample:wake:60k", "sample:cloud:60k", "sample:impact:100k"}) {
        SCOPED_TRACE(sample);
        const auto source = openDataSet(sample);
        expectRoundTrip(*source, source->fieldNames());
    }
}

TEST_P(Convert, ThereAndBackKeepsRealData)
{
    const std::string folder = BRICKWALL_SOURCE_DIR "/../shared/data/";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no sample data in " << folder;
    for (const std::string& file : realFiles) {
        SCOPED_TRACE(file);
        if (!std::filesystem::exists(folder + file) || !canBeRead(folder + file))
            continue;
        const auto source = openDataSet(folder + file);
        expectRoundTrip(*source, {source->defaultField()});
    }
}

TEST_P(Convert, WritesTheFieldsThatAreNamedInTheirOrder)
{
    const auto source =
        deriveFields(openDataSet("sample:wake:60k"), parseDerivedFields(Texts{"twice = 2 * speed"}, ""), "");
    expectRoundTrip(*source, {"twice", "speed"});
}

TEST_P(Convert, CutsCellsOutOfBricks)
{
    const ModelData source(oracleModel());
    const mat4d m = oracleModel().worldFromVoxel;
    ConvertOptions options;
    options.fields = {"f"};
    // Faces of level 0 cells, but within cells of level 1 and 2: those are taken whole.
    options.cells.box = Box3d{transformPoint(m, vec3d(-3, 2, 5)), transformPoint(m, vec3d(12, 5, 6))};
    convertTo(destination(), source, options);
    if (!canBeRead(destination()))
        GTEST_SKIP() << "there is no reader for " << GetParam();
    std::vector<std::array<int, 4>> expected;
    for (const auto& [cell, value] : cellValues(loaded(source, {"f"}))) {
        const Box3i box{vec3i(cell[0], cell[1], cell[2]), vec3i(cell[0], cell[1], cell[2]) + (1 << cell[3])};
        if (box.overlaps({{-3, 2, 5}, {12, 5, 6}}))
            expected.push_back({cell[0] + 4, cell[1], cell[2] - 4, cell[3]});
    }
    std::sort(expected.begin(), expected.end());
    std::vector<std::array<int, 4>> found;
    for (const PlacedValue& value : placedValues(loadData(destination()), 0))
        found.push_back(value.cell);
    EXPECT_EQ(found, expected);
}

TEST_P(Convert, LeavesOutLevels)
{
    const ModelData source(oracleModel());
    ConvertOptions options;
    options.fields = {"f"};
    options.cells.finestLevel = 1;
    options.cells.coarsestLevel = 2;
    convertTo(destination(), source, options);
    if (!canBeRead(destination()))
        GTEST_SKIP() << "there is no reader for " << GetParam();
    const auto cells = cellsPerLevel(loaded(source, {"f"}).bricks);
    EXPECT_EQ(loadData(destination()).cellCount, cells[1] + cells[2]);
    options.overwrite = true;
    options.cells.finestLevel = options.cells.coarsestLevel = 3;
    EXPECT_TRUE(says(errorOf([&] { convertTo(destination(), source, options); }), {"out", "no cells"}));
}

TEST_P(Convert, ReplacesNothingUnasked)
{
    const ModelData source(oracleModel());
    convertTo(destination(), source);
    const auto before = filesIn(testFolder());
    EXPECT_TRUE(says(errorOf([&] { convertTo(destination(), source); }), {"out", "there already", "--overwrite"}));
    ConvertOptions options;
    options.overwrite = true;
    convertTo(destination(), source, options);
    EXPECT_EQ(filesIn(testFolder()), before);
}

TEST_P(Convert, LeavesWhatWasThereWhenItFails)
{
    const ModelData source(oracleModel());
    convertTo(destination(), source);
    const auto before = filesIn(testFolder());
    ConvertOptions options;
    options.overwrite = true;
    options.fields = {"f", "nosuch"};
    EXPECT_TRUE(says(errorOf([&] { convertTo(destination(), source, options); }), {"nosuch"}));
    EXPECT_EQ(filesIn(testFolder()), before);
    if (canBeRead(destination()))
        expectSame(loadData(destination()), loaded(source, source.fieldNames()));
}

/// Stops at a given number of calls.
class StopsAfter : public Progress
{
public:
    explicit StopsAfter(int calls) : left_(calls) {}
    void advance(std::uint64_t) override { step(); }
    void begin(std::string_view, std::uint64_t) override { step(); }
    bool stopped() const { return cancelled(); }

private:
    void step()
    {
        if (--left_ < 0)
            cancel();
    }
    std::atomic<int> left_;
};

TEST_P(Convert, LeavesNothingWhenItIsStopped)
{
    const ModelData source(oracleModel());
    for (int calls = 0;; ++calls) {
        StopsAfter progress(calls);
        try {
            convert(source, destination(), {}, Executor(1), progress);
        } catch (const Cancelled&) {
            ASSERT_TRUE(filesIn(testFolder()).empty()) << "after " << calls;
            continue;
        }
        EXPECT_GT(calls, 4);
        break;
    }
}

TEST_P(Convert, IsTheSameWithAnyNumberOfThreads)
{
    const auto bytesAfter = [&](int threads) {
        Progress silent;
        ConvertOptions options;
        options.overwrite = true;
        convert(*openDataSet("sample:wake:60k"), destination(), options, Executor(threads), silent);
        std::uintmax_t bytes = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(testFolder()))
            bytes += entry.is_regular_file() ? entry.file_size() : 0;
        return bytes;
    };
    EXPECT_EQ(bytesAfter(1), bytesAfter(3));
}

/// A data set that is never loaded.
class OnlyStreamed : public ModelData
{
public:
    using ModelData::ModelData;
    Model load(std::span<const std::string>, const Executor&, Progress&, NonFinite) const override
    {
        throw Error("test", "was loaded");
    }
    std::optional<StreamedModel> stream(std::span<const std::string> fields, const Executor& executor,
                                        Progress& progress) const override
    {
        auto whole = std::make_shared<Model>(ModelData::load(fields, executor, progress, NonFinite::error));
        StreamedModel streamed{*whole, {}};
        for (std::size_t f = 0; f < fields.size(); ++f) {
            streamed.model.fields[f].values = {};
            streamed.values.push_back([whole, f](std::size_t brick, std::uint64_t first, std::span<float> out) {
                std::copy_n(whole->fields[f].values.begin() + std::ptrdiff_t(whole->bricks[brick].begin + first),
                            out.size(), out.begin());
            });
        }
        return streamed;
    }
};

TEST_P(Convert, StreamsWhatNeedNotBeInMemory)
{
    const OnlyStreamed source(oracleModel());
    ConvertOptions options;
    options.overwrite = true;
    convertTo(destination(), source, options);
    if (!canBeRead(destination()))
        GTEST_SKIP() << "there is no reader for " << GetParam();
    expectSame(loaded(*openDataSet(destination()), openDataSet(destination())->fieldNames()), oracleModel());
    options.cells.box = Box3d{vec3d(-1, -2.4, 1e5), vec3d(9, -1, 2e5)}; // cuts bricks
    convertTo(destination(), source, options);
    const Model cut = loadData(destination());
    convertTo(destination(), ModelData(oracleModel()), options);
    expectSame(cut, loadData(destination()));
}

INSTANTIATE_TEST_SUITE_P(Formats, Convert, testing::Values(".exa", ".vdb", ".vthb", ".brickwall"),
                         [](const auto& info) { return std::string(info.param).substr(1); });

TEST(ConvertFormats, AreChosenByTheExtensionAlone)
{
    const ModelData source(oracleModel());
    EXPECT_TRUE(says(errorOf([&] { convertTo(testFolder() + "/a.vtk", source); }), {"a.vtk", ".exa", ".vdb", ".vthb"}));
    EXPECT_TRUE(says(errorOf([&] { convertTo(testFolder() + "/no/a.exa", source); }), {"a.exa", "a folder"}));
    ConvertOptions twice;
    twice.fields = {"f", "f"};
    EXPECT_TRUE(says(errorOf([&] { convertTo(testFolder() + "/a.exa", source, twice); }), {"'f' twice"}));
}

TEST(ConvertFormats, HaveNoPlaceForTurnedAxesButOurOwn)
{
    Model model = oracleModel();
    model.worldFromVoxel = glm::rotate(model.worldFromVoxel, 0.5, vec3d(0, 0, 1));
    const ModelData source(model);
    for (const char* extension : {".exa", ".vdb", ".vthb"})
        EXPECT_TRUE(
            says(errorOf([&] { convertTo(testFolder() + "/a" + extension, source); }), {"turned", ".brickwall"}))
            << extension;
    EXPECT_TRUE(filesIn(testFolder()).empty());
    convertTo(testFolder() + "/a.brickwall", source);
    EXPECT_EQ(loadData(testFolder() + "/a.brickwall").worldFromVoxel, model.worldFromVoxel);
}

TEST(ConvertToExa, KeepsRangesMeshesAndGivesFieldsNamesThatAreWords)
{
    Model model = oracleModel();
    model.meshes = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}};
    convertTo(testFolder() + "/with blank.exa", ModelData(model));
    EXPECT_EQ(filesIn(testFolder()),
              (std::set<std::string>{"with blank.exa", "with_blank.bricks", "with_blank.f.scalars",
                                     "with_blank.second____field_.scalars", "with_blank.tris"}));
    const auto back = openDataSet(testFolder() + "/with blank.exa");
    EXPECT_EQ(back->fieldNames(), (Texts{"f", "second____field_"}));
    const Model found = loaded(*back, back->fieldNames());
    EXPECT_EQ(found.fields[0].preferredRange, model.fields[0].preferredRange);
    ASSERT_EQ(found.meshes.size(), 1u);
    EXPECT_EQ(found.meshes[0].vertices, model.meshes[0].vertices);
    EXPECT_EQ(found.meshes[0].triangles, model.meshes[0].triangles);
}

TEST(ConvertToVthb, CompressesOnRequest)
{
    const ModelData source(
        modelOf(oneLevelBricks(vec3i(0), vec3i(64, 64, 40), vec3i(64, 64, 40), 0), [](const vec3d& p) { return p.z; }));
    const std::string raw = testFolder() + "/raw.vthb", packed = testFolder() + "/packed.vthb";
    ConvertOptions options;
    convertTo(raw, source, options);
    options.compress = true;
    convertTo(packed, source, options);
    EXPECT_LT(10 * std::filesystem::file_size(testFolder() + "/packed/packed_0.vti"),
              std::filesystem::file_size(testFolder() + "/raw/raw_0.vti"));
    if (!canBeRead(packed))
        GTEST_SKIP() << "there is no reader for .vthb";
    expectSame(loadData(packed), loaded(source, {"f"}));
}

TEST(ConvertToVthb, DoesNotReplaceFoldersOfOthers)
{
    const ModelData source(oracleModel());
    std::filesystem::create_directory(testFolder() + "/a");
    ConvertOptions options;
    EXPECT_TRUE(says(errorOf([&] { convertTo(testFolder() + "/a.vthb", source); }), {"/a:", "there already"}));
    options.overwrite = true;
    for (const char* name : {"thesis.tex", "a_.vti", "a_x.vti", "a_1.vtu"}) {
        std::ofstream(testFolder() + "/a/" + name) << "mine";
        EXPECT_TRUE(
            says(errorOf([&] { convertTo(testFolder() + "/a.vthb", source, options); }), {"not replaced", name}));
        std::filesystem::remove(testFolder() + "/a/" + name);
    }
    convertTo(testFolder() + "/a.vthb", source, options);
}

TEST(ConvertWithHoles, LeavesOutCellsWithoutAValueInAnyOfTheFields)
{
    Model model = oracleModel();
    model.fields[0].values[5] = std::numeric_limits<float>::quiet_NaN();
    const ModelData source(model);
    EXPECT_TRUE(says(errorOf([&] {
                         convertTo(testFolder() + "/a.brickwall", source);
                         loadData(testFolder() + "/a.brickwall");
                     }),
                     {"a.brickwall", "finite values in field 'f'"}));
    Progress silent;
    const auto cache = openDataSet(testFolder() + "/a.brickwall");
    ConvertOptions options;
    options.nonFinite = NonFinite::empty;
    convertTo(testFolder() + "/b.brickwall", *cache, options);
    const Model back = loadData(testFolder() + "/b.brickwall");
    EXPECT_EQ(back.cellCount, model.cellCount - 1);
    EXPECT_EQ(back.fields.size(), 2u);
}

} // namespace
} // namespace brickwall
