// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/DerivedFields.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/EmptyCells.h"
#include "brickwall/core/io/ExpressionScanner.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/FlowTerms.h"
#include "brickwall/core/io/VectorFields.h"
#include "brickwall/core/model/Differentiate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace brickwall {
namespace {

constexpr std::size_t grain = 1 << 16; // cells that are evaluated at a time

bool contains(std::span<const std::string> names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

DerivedField parse(const std::string& text, const std::string& place)
{
    const auto skipBlanks = [&](std::size_t at) {
        return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    };
    std::size_t at = skipBlanks(0);
    const std::string name = scanName(text, at, place);
    at = skipBlanks(at);
    if (at == text.size() || text[at] != '=')
        throw TextError(place, "expected = behind the name of the field", text, at);
    return {name, text, Expression(text, at + 1, place)};
}

DerivedField magnitudeOf(const VectorFields& vector, const std::string& place)
{
    std::string text = vector.magnitude() + " = sqrt(";
    const std::size_t begin = text.size() - 5;
    for (const std::string& component : vector.components)
        text += fmt::format("{}`{}`^2", text.ends_with('(') ? "" : " + ", component);
    text += ")";
    return {vector.magnitude(), text, Expression(text, begin, place)};
}

/// A definition, and what its calls are of in these data.
struct Definition : DerivedField
{
    std::vector<FlowTerm> terms;

    std::vector<std::string> usedNames() const
    {
        std::vector<std::string> names = expression.names();
        for (const FlowTerm& term : terms)
            names.insert(names.end(), term.fields.begin(), term.fields.end());
        return names;
    }
};

/// "the cell at voxel (8,0,16) of level 1"
std::string describeCell(std::span<const Brick> bricks, std::uint64_t slot)
{
    const auto after = std::upper_bound(bricks.begin(), bricks.end(), slot,
                                        [](std::uint64_t s, const Brick& b) { return s < b.begin; });
    const Brick& brick = *(after - 1);
    const std::uint64_t i = slot - brick.begin;
    const vec3i cell(i % brick.size.x, i / brick.size.x % brick.size.y, i / brick.size.x / brick.size.y);
    const vec3i lower = brick.lower + cell * brick.cellWidth();
    return fmt::format("the cell at voxel ({},{},{}) of level {}", lower.x, lower.y, lower.z, brick.level);
}

class DerivedDataSet : public DataSet
{
public:
    DerivedDataSet(std::unique_ptr<DataSet> stored, std::vector<DerivedField> definitions, std::string place)
        : stored_(std::move(stored)), storedNames_(stored_->fieldNames()), place_(std::move(place))
    {
        for (const VectorFields& vector : findVectors(storedNames_)) {
            const std::string name = vector.magnitude();
            const bool taken = contains(storedNames_, name) ||
                               std::ranges::any_of(definitions, [&](const auto& d) { return d.name == name; });
            if (!taken && !contains(knownNames(), name) &&
                std::none_of(name.begin(), name.end(), [](char c) { return c == '`'; }))
                definitions_.push_back({magnitudeOf(vector, place_), {}});
        }
        magnitudes_ = definitions_.size();
        for (DerivedField& definition : definitions) {
            check(definition);
            std::vector<FlowTerm> terms = flowTerms(definition.expression, definition.text, knownNames(), place_);
            definitions_.push_back({std::move(definition), std::move(terms)});
        }
    }

    std::string format() const override { return stored_->format(); }
    std::string defaultField() const override { return stored_->defaultField(); }

    std::vector<std::string> fieldNames() const override
    {
        std::vector<std::string> names = storedNames_;
        for (std::size_t d = magnitudes_; d < definitions_.size(); ++d)
            names.push_back(definitions_[d].name);
        return names;
    }

    std::vector<std::string> files() const override { return stored_->files(); }

    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        fieldIndices(knownNames(), fields, place_);
        const Needed needed = neededFor(fields);
        Model model = stored_->load(needed.stored, executor, progress, nonFinite);
        const std::size_t said = model.notes.size();
        for (const std::size_t d : needed.definitions) {
            if (nonFinite == NonFinite::empty && !definitions_[d].terms.empty())
                leaveOutNonFinite(model, place_, executor, progress); // no neighbours to take differences with
            Field field = evaluate(definitions_[d], model, nonFinite, executor, progress);
            if (d < magnitudes_)
                field.unit = fieldNamed(model, definitions_[d].expression.names().front()).unit;
            model.fields.push_back(std::move(field));
        }
        order(model, fields);
        if (nonFinite == NonFinite::empty && !needed.definitions.empty())
            leaveOutNonFinite(model, place_, executor, progress);
        for (std::size_t n = said; n < model.notes.size(); ++n)
            progress.note(model.notes[n]);
        return model;
    }

    /// Fields that are computed need values of others.
    std::optional<StreamedModel> stream(std::span<const std::string> fields, const Executor& executor,
                                        Progress& progress) const override
    {
        fieldIndices(knownNames(), fields, place_);
        const bool stored = std::ranges::all_of(fields, [&](const auto& name) { return contains(storedNames_, name); });
        return stored ? stored_->stream(fields, executor, progress) : std::nullopt;
    }

private:
    struct Needed
    {
        std::vector<std::string> stored;
        std::vector<std::size_t> definitions; ///< in the order in which they can be evaluated
    };

    std::vector<std::string> knownNames() const
    {
        std::vector<std::string> names = storedNames_;
        for (const Definition& definition : definitions_)
            names.push_back(definition.name);
        return names;
    }

    void check(const DerivedField& definition) const
    {
        if (contains(storedNames_, definition.name))
            throw Error(place_,
                        fmt::format("has a field '{}' already; give the derived one another name", definition.name));
        const std::vector<std::string> known = knownNames();
        const std::vector<std::string>& used = definition.expression.names();
        for (std::size_t i = 0; i < used.size(); ++i)
            if (!contains(known, used[i]))
                throw TextError(
                    place_,
                    fmt::format("there is no field '{}' (those there are: {})", used[i], fmt::join(known, ", ")),
                    definition.text, definition.expression.positionOf(i));
    }

    /// Definitions use only what comes before them, so that one pass from the last to the first finds all.
    Needed neededFor(std::span<const std::string> fields) const
    {
        std::vector<std::string> names(fields.begin(), fields.end());
        Needed needed;
        for (std::size_t d = definitions_.size(); d-- > 0;) {
            if (!contains(names, definitions_[d].name))
                continue;
            needed.definitions.insert(needed.definitions.begin(), d);
            const std::vector<std::string> used = definitions_[d].usedNames();
            names.insert(names.end(), used.begin(), used.end());
        }
        for (const std::string& name : names)
            if (contains(storedNames_, name) && !contains(needed.stored, name))
                needed.stored.push_back(name);
        return needed;
    }

    static std::vector<float> valuesOf(const FlowTerm& term, const Model& model, const Executor& executor,
                                       Progress& progress)
    {
        std::vector<std::span<const float>> fields;
        for (const std::string& name : term.fields)
            fields.push_back(fieldNamed(model, name).values);
        progress.begin(fmt::format("differentiating {}", fmt::join(term.fields, " ")), model.cellCount);
        return differentiate(term.op, model.bricks, fields, model.worldFromVoxel, executor, progress);
    }

    Field evaluate(const Definition& definition, const Model& model, NonFinite nonFinite, const Executor& executor,
                   Progress& progress) const
    {
        std::vector<std::vector<float>> terms;
        for (const FlowTerm& term : definition.terms)
            terms.push_back(valuesOf(term, model, executor, progress));
        Field field;
        field.name = definition.name;
        if (definition.expression.isOneCall())
            field.values = std::move(terms[0]);
        else
            compute(field, definition.expression, terms, model, executor, progress);
        progress.end();
        if (nonFinite == NonFinite::error)
            checkFinite(definition, field, model);
        field.range = rangeOf(field.values);
        return field;
    }

    static void compute(Field& field, const Expression& expression, const std::vector<std::vector<float>>& terms,
                        const Model& model, const Executor& executor, Progress& progress)
    {
        std::vector<std::span<const float>> inputs;
        for (const std::string& name : expression.names())
            inputs.push_back(fieldNamed(model, name).values);
        inputs.insert(inputs.end(), terms.begin(), terms.end());
        field.values.resize(model.cellCount);
        progress.begin(fmt::format("evaluating {}", field.name), model.cellCount);
        executor.forEach(model.cellCount, grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; i += grain) {
                progress.check();
                const std::size_t n = std::min(grain, end - i);
                std::vector<std::span<const float>> parts;
                for (const auto& input : inputs)
                    parts.push_back(input.subspan(i, n));
                expression.evaluate(parts, std::span(field.values).subspan(i, n));
                progress.advance(n);
            }
        });
    }

    void checkFinite(const DerivedField& definition, const Field& field, const Model& model) const
    {
        const auto bad = std::ranges::find_if(field.values, [](float v) { return !std::isfinite(v); });
        if (bad != field.values.end())
            failNotFinite(*bad, fmt::format("{}: \"{}\"", place_, definition.text), field.name,
                          describeCell(model.bricks, static_cast<std::uint64_t>(bad - field.values.begin())));
    }

    /// The fields that were asked for, in their order; others go.
    static void order(Model& model, std::span<const std::string> fields)
    {
        std::vector<Field> ordered;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            const auto found = std::ranges::find(model.fields, fields[i], &Field::name);
            if (contains(fields.subspan(i + 1), fields[i]))
                ordered.push_back(*found);
            else
                ordered.push_back(std::move(*found));
        }
        model.fields = std::move(ordered);
    }

    std::unique_ptr<DataSet> stored_;
    std::vector<std::string> storedNames_;
    std::string place_;
    std::vector<Definition> definitions_; ///< magnitudes, then those of the user
    std::size_t magnitudes_ = 0;
};

} // namespace

std::vector<DerivedField> parseDerivedFields(std::span<const std::string> definitions, const std::string& place)
{
    std::vector<DerivedField> fields;
    for (const std::string& text : definitions) {
        DerivedField field = parse(text, place);
        for (const DerivedField& known : fields)
            if (known.name == field.name)
                throw TextError(place, fmt::format("field '{}' is defined twice", field.name), text, 0);
        fields.push_back(std::move(field));
    }
    return fields;
}

std::unique_ptr<DataSet> deriveFields(std::unique_ptr<DataSet> stored, std::vector<DerivedField> definitions,
                                      const std::string& place)
{
    return std::make_unique<DerivedDataSet>(std::move(stored), std::move(definitions), place);
}

} // namespace brickwall
