// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// An expression of an .exa file in postfix notation, evaluated per cell in float, as the original does:
/// `%k` (the k-th field declared before, from 0), constants, `+ - * / **`, `== != < > <= >=` (1 or 0), `log` (natural),
/// `abs`, `sqrt`, and `select`: of a condition c and values a b, a if c, truncated to an integer, is not 0, otherwise
/// b.
class Postfix
{
public:
    /// Throws Error at `place`, naming the token and its number, for what is no token, for missing or left operands,
    /// and for fields that have not been declared.
    Postfix(std::span<const std::string> tokens, std::size_t declaredFields, const std::string& place);

    /// Indices of the fields that are used, ascending, each once.
    const std::vector<std::size_t>& fields() const { return fields_; }

    /// One value per element; inputs[i] are the values of fields()[i], at least as many as `out` has elements.
    void evaluate(std::span<const std::span<const float>> inputs, std::span<float> out) const;

private:
    struct Step
    {
        enum Kind { Field, Constant, Binary, Unary, Select } kind;
        std::size_t input = 0; ///< in `inputs`
        float constant = 0;
        float (*binary)(float, float) = nullptr;
        float (*unary)(float) = nullptr;
    };
    static Step parseToken(const std::string& token, std::size_t declaredFields);
    void checkStack(std::span<const std::string> tokens, const std::string& place);

    std::vector<Step> steps_;
    std::vector<std::size_t> fields_;
    std::size_t depth_ = 0; ///< of the stack
};

} // namespace brickwall
