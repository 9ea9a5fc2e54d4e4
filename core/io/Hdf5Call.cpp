// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Hdf5Call.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <type_traits>
#include <utility>

#include <hdf5.h>

namespace brickwall {
namespace {

// The header does without hdf5.h, so that who links Brickwall needs no HDF5 to compile.
static_assert(std::is_same_v<hid_t, std::int64_t> && std::is_same_v<herr_t, int>);

std::recursive_mutex& mutexOfHdf5()
{
    static std::recursive_mutex mutex;
    return mutex;
}

herr_t keepReason(unsigned, const H5E_error2_t* error, void* reason)
{
    if (error->desc)
        *static_cast<std::string*>(reason) = error->desc;
    return 1; // the innermost suffices
}

} // namespace

Hdf5Call::Hdf5Call() : lock_(mutexOfHdf5())
{
    H5open();
    H5Eget_auto2(H5E_DEFAULT, &print_, &printData_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Call::~Hdf5Call()
{
    H5Eset_auto2(H5E_DEFAULT, print_, printData_);
}

Hdf5Id::Hdf5Id(Hdf5Id&& other) noexcept
    : id_(std::exchange(other.id_, -1)), close_(std::exchange(other.close_, nullptr))
{
}

Hdf5Id& Hdf5Id::operator=(Hdf5Id&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
}

void Hdf5Id::reset()
{
    if (!close_ || id_ < 0)
        return;
    const Hdf5Call call;
    close_(id_);
}

void failHdf5(std::string_view place, std::string_view message)
{
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keepReason, &reason);
    throw Error(place, reason.empty() ? std::string(message) : fmt::format("{}: {}", message, reason));
}

Hdf5Id checkHdf5(std::int64_t id, Hdf5Id::Close close, std::string_view place, std::string_view message)
{
    return Hdf5Id(checkHdf5(id, place, message), close);
}

} // namespace brickwall
