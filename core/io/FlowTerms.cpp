// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/FlowTerms.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/VectorFields.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace brickwall {
namespace {

/// "there is no vector 'dens' for qcriterion (those there are: velocity)"
std::string noVector(const FlowCall& call, std::span<const VectorFields> vectors)
{
    std::vector<std::string> names;
    for (const VectorFields& vector : vectors)
        names.push_back(vector.name);
    return fmt::format("there is no vector '{}' for {} ({})", call.argument, flowOperatorNames[std::size_t(call.op)],
                       names.empty() ? "no three fields have names such as velx vely velz or u v w"
                                     : fmt::format("those there are: {}", fmt::join(names, ", ")));
}

} // namespace

std::vector<FlowTerm> flowTerms(const Expression& expression, const std::string& text,
                                std::span<const std::string> known, const std::string& place)
{
    const std::vector<VectorFields> vectors = findVectors(known);
    std::vector<FlowTerm> terms;
    for (const FlowCall& call : expression.calls()) {
        const auto vector = std::ranges::find(vectors, call.argument, &VectorFields::name);
        if (componentsOf(call.op) == 3) {
            if (vector == vectors.end())
                throw TextError(place, noVector(call, vectors), text, call.position);
            terms.push_back({call.op, {vector->components.begin(), vector->components.end()}});
        } else {
            if (std::find(known.begin(), known.end(), call.argument) == known.end())
                throw TextError(place,
                                fmt::format("there is no field '{}'{} (those there are: {})", call.argument,
                                            vector == vectors.end() ? "" : ", which is a vector,",
                                            fmt::join(known, ", ")),
                                text, call.position);
            terms.push_back({call.op, {call.argument}});
        }
    }
    return terms;
}

} // namespace brickwall
