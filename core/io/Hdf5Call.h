// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

namespace brickwall {

/// Held while the HDF5 library is called. The library keeps global state and need not have been built for threads, so
/// that one lock of the process serves all files: any number of threads may use Hdf5File and Hdf5Data, one at a time is
/// served. Calls may be nested. The library's own printing of errors is off meanwhile, and as it was afterwards, for
/// the calling thread alone: a host program may use HDF5 itself.
class Hdf5Call
{
public:
    Hdf5Call();
    ~Hdf5Call();
    Hdf5Call(const Hdf5Call&) = delete;
    Hdf5Call& operator=(const Hdf5Call&) = delete;

private:
    std::lock_guard<std::recursive_mutex> lock_;
    int (*print_)(std::int64_t, void*) = nullptr;
    void* printData_ = nullptr;
};

/// An identifier of the HDF5 library (hid_t), closed when it goes.
class Hdf5Id
{
public:
    using Close = int (*)(std::int64_t);

    Hdf5Id() = default;
    Hdf5Id(std::int64_t id, Close close) : id_(id), close_(close) {}
    ~Hdf5Id() { reset(); }
    Hdf5Id(Hdf5Id&& other) noexcept;
    Hdf5Id& operator=(Hdf5Id&& other) noexcept;

    std::int64_t get() const { return id_; }
    bool valid() const { return id_ >= 0; }

private:
    void reset();

    std::int64_t id_ = -1;
    Close close_ = nullptr;
};

/// Throws Error: "PLACE: MESSAGE: what HDF5 gives as the innermost reason of the last call that failed".
[[noreturn]] void failHdf5(std::string_view place, std::string_view message);

/// `status`, which a call returned, or failHdf5 if it says that the call failed.
template <class Status>
Status checkHdf5(Status status, std::string_view place, std::string_view message)
{
    if (status < 0)
        failHdf5(place, message);
    return status;
}

/// The same for an identifier.
Hdf5Id checkHdf5(std::int64_t id, Hdf5Id::Close close, std::string_view place, std::string_view message);

} // namespace brickwall
