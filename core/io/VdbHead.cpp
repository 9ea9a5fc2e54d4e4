// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VdbHead.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/VdbTreeCheck.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace brickwall {
namespace {

/// What the numbers of metadata take, by their types' names in the file; texts and unknown types say it themselves.
constexpr std::pair<std::string_view, std::uint32_t> fixedSizes[] = {
    {"bool", 1},   {"int32", 4},  {"int64", 8},  {"float", 4},  {"double", 8}, {"vec2i", 8},
    {"vec2s", 8},  {"vec2d", 16}, {"vec3i", 12}, {"vec3s", 12}, {"vec3d", 24}, {"vec4i", 16},
    {"vec4s", 16}, {"vec4d", 32}, {"mat4s", 64}, {"mat4d", 128}};

class Walker
{
public:
    explicit Walker(const InputFile& file) : file_(file) {}

    std::uint64_t at() const { return at_; }
    void moveTo(std::uint64_t at, std::string_view what)
    {
        if (at > file_.size())
            fail(fmt::format("{} at byte {} lies beyond the end of the file, {}", what, at, file_.size()));
        at_ = at;
    }

    template <class T>
    T number(std::string_view what)
    {
        T value{};
        file_.readAt(at_, std::span(&value, 1), what);
        at_ += sizeof(T);
        return value;
    }

    std::string text(std::string_view what)
    {
        constexpr std::uint32_t longest = 1 << 16;
        const auto size = number<std::uint32_t>(what);
        if (size > longest)
            fail(fmt::format("expected {} of at most {} characters, found a length of {}", what, longest, size));
        std::string text(size, '\0');
        file_.readAt(at_, std::span<char>(text), what);
        at_ += size;
        return text;
    }

    void skipMetadata()
    {
        const auto count = number<std::uint32_t>("a number of metadata");
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::string name = text("the name of metadata"), type = text("the type of metadata");
            const auto size = number<std::uint32_t>("the size of metadata");
            for (const auto& [fixed, bytes] : fixedSizes)
                if (type == fixed && size != bytes)
                    fail(fmt::format("expected metadata '{}' of {} bytes, as its type {} has, found {}", name, bytes,
                                     type, size));
            const std::uint64_t end = at_ + size;
            if (type == "__delayedload" && size > 0)
                checkDelayedLoad(end);
            moveTo(end, "the end of metadata");
        }
    }

    [[noreturn]] void fail(const std::string& message) const
    {
        throw Error(fmt::format("{}: byte {}", file_.path(), at_), message);
    }

private:
    /// The number of leaves, a byte for each, a size for each; both lists are packed if their length says so.
    void checkDelayedLoad(std::uint64_t end)
    {
        constexpr std::uint64_t leafBytes = 64; // a leaf takes more in the file
        constexpr std::uint64_t padded = 128;   // what short lists are made before they are packed
        const auto leaves = number<std::uint32_t>("a number of leaves");
        if (leaves > file_.size() / leafBytes)
            fail(fmt::format("expected no more leaves than the file has room for, found {}", leaves));
        for (const std::uint64_t each : {1, 8}) {
            const auto bytes = number<std::uint32_t>("the size of a list");
            if (bytes == 0xffffffffu)
                break; // no list
            if (bytes > 0)
                checkBlosc(file_, at_, bytes, std::max(leaves * each, padded), file_.path());
            moveTo(at_ + (bytes > 0 ? bytes : leaves * each), "the end of a list");
        }
        if (at_ > end)
            fail("expected lists within their metadata, found longer ones");
    }

    const InputFile& file_;
    std::uint64_t at_ = 0;
};

void checkHeader(Walker& walker)
{
    constexpr std::uint32_t oldest = 222, newest = 224;
    walker.number<std::int64_t>("the magic number");
    if (const auto version = walker.number<std::uint32_t>("a version"); version < oldest || version > newest)
        walker.fail(fmt::format("expected file version {} to {}, found {}; write it again with OpenVDB 3 to 10", oldest,
                                newest, version));
    walker.number<std::uint64_t>("the library's version");
    if (walker.number<char>("a flag") == 0)
        walker.fail("expected a table of grids, found a file that was written to a pipe; write it again to a file");
    constexpr std::uint64_t identifier = 36;
    walker.moveTo(walker.at() + identifier, "the end of the identifier");
}

} // namespace

std::vector<VdbEntry> readVdbHead(const InputFile& file)
{
    Walker walker(file);
    checkHeader(walker);
    walker.skipMetadata();
    const auto count = walker.number<std::int32_t>("the number of grids");
    std::vector<VdbEntry> entries;
    for (std::int32_t i = 0; i < count; ++i) {
        VdbEntry entry;
        entry.begin = static_cast<std::int64_t>(walker.at());
        entry.name = walker.text("the name of a grid");
        entry.type = walker.text("the type of a grid");
        walker.text("the parent of a grid");
        const auto grid = walker.number<std::uint64_t>("the position of a grid");
        walker.number<std::uint64_t>("the position of a grid's values");
        const auto end = walker.number<std::uint64_t>("the end of a grid");
        if (end <= walker.at())
            walker.fail(
                fmt::format("expected grid '{}' to end behind its description, found byte {}", entry.name, end));
        walker.moveTo(grid, "a grid");
        walker.number<std::uint32_t>("compression flags");
        walker.skipMetadata();
        walker.text("the type of a grid's transform");
        walker.moveTo(end, "the end of a grid");
        entries.push_back(std::move(entry));
    }
    return entries;
}

} // namespace brickwall
