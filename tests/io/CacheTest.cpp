// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/CacheFile.h"
#include "brickwall/tests/io/ConvertTesting.h"
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

namespace brickwall {
namespace {

using namespace convert_test;
using namespace oracles;

Model smallModel()
{
    Model model = modelOf(oneLevelBricks(vec3i(0), vec3i(4, 3, 2), vec3i(3), 1), [](const vec3d& p) { return p.x; });
    model.fields[0].unit = "K";
    model.fields[0].preferredRange = {1, 2};
    model.meshes = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}};
    model.worldFromVoxel[3][0] = 0.1;
    return model;
}

std::string writtenCache()
{
    const std::string path = testFolder() + "/a.brickwall";
    ConvertOptions options;
    options.overwrite = true;
    convertTo(path, ModelData(smallModel()), options);
    return path;
}

std::string bytesOfFile(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// What is said about a cache in which something was changed.
std::string errorAfter(const std::function<void(std::string& bytes)>& change)
{
    const std::string path = writtenCache();
    std::string bytes = bytesOfFile(path);
    change(bytes);
    writeText(path, bytes);
    return loadError(path);
}

/// The number of type T at a byte of the file becomes `value`.
template <class T>
std::string errorWith(std::size_t at, T value)
{
    return errorAfter([&](std::string& bytes) { std::memcpy(bytes.data() + at, &value, sizeof value); });
}

std::uint64_t tableOffset()
{
    CacheHeader header;
    std::memcpy(static_cast<void*>(&header), bytesOfFile(writtenCache()).data(), sizeof header);
    return header.tableOffset;
}

TEST(Cache, HasEverythingOfAModel)
{
    const Model model = smallModel(), found = loadData(writtenCache());
    expectSame(found, model);
    ASSERT_EQ(found.bricks.size(), model.bricks.size());
    EXPECT_EQ(found.fields[0].values, model.fields[0].values);
    EXPECT_EQ(found.fields[0].name, "f");
    EXPECT_EQ(found.fields[0].unit, "K");
    EXPECT_EQ(found.fields[0].preferredRange, model.fields[0].preferredRange);
    EXPECT_EQ(found.worldFromVoxel, model.worldFromVoxel);
    ASSERT_EQ(found.meshes.size(), 1u);
    EXPECT_EQ(found.meshes[0].vertices, model.meshes[0].vertices);
    EXPECT_EQ(openDataSet(writtenCache())->format(), "Brickwall cache");
}

TEST(Cache, IsKnownByItsContent)
{
    const std::string path = writtenCache();
    std::filesystem::rename(path, testFolder() + "/a.txt");
    EXPECT_EQ(loadData(testFolder() + "/a.txt").cellCount, 24u);
    writeText(path, "a text");
    EXPECT_TRUE(says(loadError(path), {"of no format", "a file .brickwall"}));
}

TEST(Cache, MayHoldCellsWithoutFields)
{
    Model model = smallModel();
    model.fields.clear();
    convertTo(testFolder() + "/a.brickwall", ModelData(model));
    EXPECT_EQ(loadData(testFolder() + "/a.brickwall").cellCount, 24u);
}

TEST(Cache, OfOtherVersionsIsRefused)
{
    EXPECT_TRUE(says(errorWith(offsetof(CacheHeader, version), std::uint32_t(2)),
                     {"a.brickwall", "version 1, found version 2", "convert the original again"}));
}

TEST(Cache, ThatIsTruncatedIsRefusedAtEveryLength)
{
    const std::string whole = bytesOfFile(writtenCache());
    for (std::size_t size = cacheMagic.size(); size < whole.size(); size += size < 300 ? 1 : 37)
        EXPECT_TRUE(says(errorAfter([&](std::string& bytes) { bytes.resize(size); }), {"a.brickwall", "truncated"}));
    EXPECT_TRUE(says(errorAfter([](std::string& bytes) { bytes += 'x'; }), {"damaged"}));
}

TEST(Cache, ThatWasNotFinishedIsNone)
{
    EXPECT_TRUE(says(errorAfter([](std::string& bytes) { std::fill_n(bytes.begin(), sizeof(CacheHeader), '\0'); }),
                     {"of no format"}));
}

TEST(Cache, WithNumbersThatDoNotFitIsRefused)
{
    const std::uint64_t far = std::uint64_t(1) << 60, table = tableOffset();
    EXPECT_TRUE(says(errorWith(offsetof(CacheHeader, tableOffset), far), {"expected a table"}));
    EXPECT_TRUE(says(errorWith(offsetof(CacheHeader, tableOffset), std::uint64_t(0)), {"expected a table"}));
    EXPECT_TRUE(says(errorWith(offsetof(CacheHeader, brickCount), far), {"expected bricks", "bytes left"}));
    EXPECT_TRUE(says(errorWith(offsetof(CacheHeader, brickCount), ~std::uint64_t(0)), {"expected bricks"}));
    EXPECT_TRUE(says(errorWith(offsetof(CacheHeader, cellCount), far), {"cells, as its header says"}));
    EXPECT_TRUE(says(errorWith(offsetof(CacheHeader, fieldCount), far), {"expected", "field"}));
    EXPECT_TRUE(says(errorWith(offsetof(CacheHeader, fieldCount), std::uint64_t(0)), {"expected"}));
    EXPECT_TRUE(says(errorWith(offsetof(CacheHeader, meshCount), std::uint32_t(0)), {"end of the table"}));
    EXPECT_TRUE(says(errorWith(offsetof(CacheHeader, worldFromVoxel), 0.0), {"invertible"}));
    EXPECT_TRUE(says(errorWith(table + offsetof(CacheBrick, size), -3), {"brick 0"}));
    EXPECT_TRUE(says(errorWith(table + offsetof(CacheBrick, size), 1 << 30), {"brick 0"}));
    EXPECT_TRUE(says(errorWith(table + offsetof(CacheBrick, level), 99), {"brick 0", "level"}));
    EXPECT_TRUE(says(errorWith(table + sizeof(CacheBrick) + offsetof(CacheBrick, lower), 0), {"overlap"}));
    const std::uint64_t field = table + 2 * sizeof(CacheBrick);
    EXPECT_TRUE(says(errorWith(field + offsetof(CacheField, offset), far), {"values of field 'f'"}));
    EXPECT_TRUE(says(errorWith(field + offsetof(CacheField, offset), std::uint64_t(0)), {"values of field 'f'"}));
    EXPECT_TRUE(says(errorWith(field + offsetof(CacheField, nameSize), ~std::uint32_t(0)), {"a field's name"}));
    const std::uint64_t mesh = field + sizeof(CacheField) + 2;
    EXPECT_TRUE(says(errorWith(mesh + offsetof(CacheMesh, vertexCount), far), {"vertices"}));
    EXPECT_TRUE(says(errorWith(mesh + sizeof(CacheMesh) + 36, 3), {"mesh 0", "vertex from 0 to 2"}));
}

TEST(Cache, WithValuesThatAreNotFiniteIsAnErrorOrHasHoles)
{
    const auto change = [](std::string& bytes) {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        std::memcpy(bytes.data() + cacheAlignment, &nan, sizeof nan);
    };
    EXPECT_TRUE(says(errorAfter(change), {"a.brickwall", "finite values in field 'f'", "brick 0"}));
    Progress silent;
    const auto cache = openDataSet(testFolder() + "/a.brickwall");
    EXPECT_EQ(cache->load(Texts{"f"}, Executor(1), silent, NonFinite::empty).cellCount, 23u);
}

} // namespace
} // namespace brickwall
