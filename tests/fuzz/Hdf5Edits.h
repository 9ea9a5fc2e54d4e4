// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/tests/fuzz/Hdf5Objects.h"
#include "brickwall/tests/fuzz/Scratch.h"

#include <functional>
#include <string>
#include <vector>

namespace brickwall::fuzz {

/// Sound HDF5 files that say something wrong: the first number of an input chooses one of some valid files, every
/// further group of bytes changes something in it through the HDF5 library. An input of one byte is a valid file.
///
/// Bytes are not mutated, as the library itself does not survive that (docs/decisions/0023-fuzzing.md).
class Hdf5Edits
{
public:
    using Write = std::function<void(const std::string& path)>;

    /// Each of these writes one of the valid files.
    explicit Hdf5Edits(const std::vector<Write>& files);

    /// Makes the file of an input; returns its path.
    std::string make(Input input) const;

private:
    void edit(hid_t file, FuzzedDataProvider& input) const;
    std::string path(FuzzedDataProvider& input) const;

    std::vector<std::string> files_; ///< their bytes
    Hdf5Objects objects_;            ///< of all files
};

/// Makes the file of an input and reads it.
void readEdited(const Hdf5Edits& edits, Input input);

} // namespace brickwall::fuzz
