// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/LargeArray.h"

#include <algorithm>
#include <cstdint>

#include <sys/mman.h>
#include <unistd.h>

namespace brickwall {
namespace {

constexpr std::size_t largePage = std::size_t(2) << 20;

#ifndef MADV_POPULATE_WRITE
constexpr int populate = 23; // of Linux 5.14, which may be newer than the headers
#else
constexpr int populate = MADV_POPULATE_WRITE;
#endif

/// Nothing depends on whether the system does what it is advised to.
void advise(std::uintptr_t begin, std::uintptr_t end, int advice)
{
    if (begin < end)
        static_cast<void>(::madvise(reinterpret_cast<void*>(begin), end - begin, advice));
}

std::uintptr_t pageSize()
{
    return static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
}

/// Asks for the memory of the whole pages from `first` to `last`, before it is written to by one thread.
void populatePages(std::uintptr_t first, std::uintptr_t last, const Executor& executor)
{
    const std::uintptr_t start = first / largePage * largePage; // pieces end where large pages do
    executor.forEach((last - start) / largePage + 1, 8, [&](std::size_t begin, std::size_t end) {
        advise(std::max(first, start + begin * largePage), std::min(last, start + end * largePage), populate);
    });
}

} // namespace

std::vector<float> makeLargeArray(std::size_t count, const Executor& executor)
{
    std::vector<float> values = roomForLargeArray(count);
    growLargeArray(values, count, executor);
    return values;
}

std::vector<float> roomForLargeArray(std::size_t count)
{
    std::vector<float> values;
    values.reserve(count);
    const std::uintptr_t page = pageSize();
    const auto memory = reinterpret_cast<std::uintptr_t>(values.data());
    const std::uintptr_t first = (memory + page - 1) / page * page;
    const std::uintptr_t last = (memory + count * sizeof(float)) / page * page;
    if (last > first + 4 * largePage)
        advise(first, last, MADV_HUGEPAGE);
    return values;
}

void growLargeArray(std::vector<float>& values, std::size_t count, const Executor& executor)
{
    const std::uintptr_t page = pageSize();
    const auto memory = reinterpret_cast<std::uintptr_t>(values.data());
    const std::uintptr_t first = (memory + values.size() * sizeof(float) + page - 1) / page * page;
    const std::uintptr_t last = (memory + count * sizeof(float)) / page * page;
    if (last > first + 4 * largePage)
        populatePages(first, last, executor);
    values.resize(count);
}

void releaseValues(std::span<float> values)
{
    const std::uintptr_t page = pageSize();
    const auto memory = reinterpret_cast<std::uintptr_t>(values.data());
    advise((memory + page - 1) / page * page, (memory + values.size_bytes()) / page * page, MADV_DONTNEED);
}

} // namespace brickwall
