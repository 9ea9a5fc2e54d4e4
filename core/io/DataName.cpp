// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/DataName.h"

#include "brickwall/core/io/InputFile.h"

#include <algorithm>
#include <filesystem>

namespace brickwall {

std::string DataName::valueOf(std::string_view key) const
{
    for (const std::string& option : options)
        if (option.starts_with(key) && option.size() > key.size() && option[key.size()] == '=')
            return option.substr(key.size() + 1);
    return {};
}

DataName splitDataName(const std::string& data)
{
    std::error_code ignored;
    if (std::filesystem::exists(data, ignored))
        return {data, {}};
    std::size_t colon = data.rfind(':');
    while (colon != std::string::npos && colon > 0 && !isRegularFile(data.substr(0, colon)))
        colon = data.rfind(':', colon - 1);
    if (colon == std::string::npos || colon == 0)
        return {data, {}};
    DataName name{data.substr(0, colon), {}};
    for (std::size_t begin = colon + 1; begin <= data.size();) {
        const std::size_t end = std::min(data.find(':', begin), data.size());
        name.options.push_back(data.substr(begin, end - begin));
        begin = end + 1;
    }
    return name;
}

} // namespace brickwall
