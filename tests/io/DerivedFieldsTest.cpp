// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/DerivedFields.h"

#include "brickwall/core/io/VectorFields.h"
#include "brickwall/tests/io/IoTest.h"
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <cmath>
#include <functional>

namespace brickwall {
namespace {

using namespace oracles;

using Texts = std::vector<std::string>;

/// Two levels with fields that are functions of position. Returns the path.
std::string writeData(const std::vector<std::pair<std::string, std::function<double(const vec3d&)>>>& fields)
{
    std::vector<Brick> bricks = oneLevelBricks(vec3i(0), vec3i(4), vec3i(4), 1);
    for (const Brick& fine : oneLevelBricks(vec3i(8, 0, 0), vec3i(8), vec3i(4), 0))
        bricks.push_back(fine);
    Model model;
    for (const auto& [name, value] : fields) {
        Model one = modelOf(bricks, value);
        one.fields[0].name = name;
        one.fields.insert(one.fields.begin(), model.fields.begin(), model.fields.end());
        model = std::move(one);
    }
    return writeExa(testFolder(), "t", model);
}

std::string writeVelocity()
{
    return writeData({{"velx", [](const vec3d& p) { return p.x; }},
                      {"vely", [](const vec3d& p) { return p.y * p.y; }},
                      {"velz", [](const vec3d& p) { return -p.z; }},
                      {"dens", [](const vec3d& p) { return 1 + p.x; }}});
}

std::unique_ptr<DataSet> derived(const std::string& data, const Texts& definitions)
{
    return deriveFields(openDataSet(data), parseDerivedFields(definitions, "--derive"), data);
}

Model loadDerived(const std::string& data, const Texts& definitions, const Texts& fields, int threads = 2,
                  NonFinite nonFinite = NonFinite::error)
{
    Progress silent;
    return derived(data, definitions)->load(fields, Executor(threads), silent, nonFinite);
}

/// What a definition is refused with: the line, and the text with the caret.
TextError refusal(const std::string& definition, const std::string& data = {})
{
    try {
        if (data.empty())
            parseDerivedFields(Texts{definition}, "--derive");
        else
            derived(data, {definition});
    } catch (const TextError& error) {
        return error;
    }
    ADD_FAILURE() << "nothing wrong with " << definition;
    return {"", "", "", 0};
}

/// The refusal says this, and its caret is under the character at index `at`.
void expectRefused(const std::string& definition, std::size_t at, const std::string& said)
{
    const TextError error = refusal(definition);
    EXPECT_TRUE(says(error.what(), {"--derive: " + said, definition}));
    EXPECT_EQ(error.excerpt(), definition + "\n" + std::string(at, ' ') + "^");
}

TEST(DerivedFields, AreWhatTheirExpressionSaysInEveryCell)
{
    const std::string data = writeVelocity();
    const Model model = loadDerived(data, {"speed = sqrt(velx^2+vely^2+velz^2)"}, {"speed", "velx", "vely", "velz"});
    ASSERT_EQ(model.fields.size(), 4u);
    EXPECT_EQ(model.fields[0].name, "speed");
    EXPECT_EQ(model.cellCount, 576u);
    for (std::uint64_t i = 0; i < model.cellCount; ++i) {
        const double x = model.fields[1].values[i], y = model.fields[2].values[i], z = model.fields[3].values[i];
        EXPECT_EQ(model.fields[0].values[i], static_cast<float>(std::sqrt(x * x + y * y + z * z)));
    }
    EXPECT_EQ(model.fields[0].range, rangeOf(model.fields[0].values));
}

TEST(DerivedFields, AreTheSameWithAnyNumberOfThreads)
{
    const Texts definition{"a = sin(x_velocity) + density / 7"};
    const std::string sample = "sample:cloud:200k";
    const Texts names = openDataSet(sample)->fieldNames();
    const Texts use{"a = sin(" + names[0] + ") / 7"};
    EXPECT_EQ(loadDerived(sample, use, {"a"}, 1).fields[0].values, loadDerived(sample, use, {"a"}, 3).fields[0].values);
}

TEST(DerivedFields, MayUseThoseBeforeThem)
{
    const std::string data = writeVelocity();
    const Model model =
        loadDerived(data, {"twice = 2 * velx", "more = twice + dens", "last = more - twice"}, {"last", "dens"});
    EXPECT_EQ(model.fields[0].values, model.fields[1].values);
    EXPECT_TRUE(says(refusal("a = b + 1", data).what(), {"there is no field 'b'"}));
    EXPECT_TRUE(says(errorOf([&] { derived(data, {"a = b", "b = velx"}); }), {"no field 'b'", "character 5"}));
    EXPECT_TRUE(says(errorOf([&] { derived(data, {"a = a + 1"}); }), {"no field 'a'"}));
}

TEST(DerivedFields, AreListedBehindTheStoredOnes)
{
    const auto set = derived(writeVelocity(), {"b = 1", "a = 2"});
    EXPECT_EQ(set->fieldNames(), (Texts{"velx", "vely", "velz", "dens", "b", "a"}));
    EXPECT_EQ(set->defaultField(), "velx");
}

TEST(DerivedFields, ReadOnlyWhatTheyNeed)
{
    const std::string data = writeVelocity();
    std::filesystem::remove(testFolder() + "/t.vely.scalars"); // after it was found
    writeText(testFolder() + "/t.vely.scalars", "x");
    EXPECT_TRUE(says(errorOf([&] { loadDerived(data, {"a = vely"}, {"a"}); }), {"t.vely.scalars"}));
    EXPECT_EQ(loadDerived(data, {"a = velx", "b = vely"}, {"a"}).fields.size(), 1u);
}

TEST(DerivedFields, MayBeAskedForTwice)
{
    const Model model = loadDerived(writeVelocity(), {"a = velx"}, {"a", "velx", "a"});
    ASSERT_EQ(model.fields.size(), 3u);
    EXPECT_EQ(model.fields[0].values, model.fields[1].values);
    EXPECT_EQ(model.fields[0].values, model.fields[2].values);
}

TEST(DerivedFields, TakeNamesInQuotes)
{
    const std::string data = writeData({{"x-velocity", [](const vec3d& p) { return p.x; }},
                                        {"2nd", [](const vec3d& p) { return p.y; }},
                                        {"sin", [](const vec3d& p) { return p.z; }},
                                        {"_pi", [](const vec3d&) { return 7; }},
                                        {"größe", [](const vec3d&) { return 9; }}});
    const Model model = loadDerived(
        data, {"'a sum' = 'x-velocity' + \"2nd\" + sin(0) * sin + 0 * `sin`", "seven = '_pi' + 0 * _pi", "g = größe"},
        {"a sum", "x-velocity", "2nd", "seven", "g"});
    for (std::uint64_t i = 0; i < model.cellCount; ++i) {
        EXPECT_EQ(model.fields[0].values[i], model.fields[1].values[i] + model.fields[2].values[i]);
        EXPECT_EQ(model.fields[3].values[i], 7.0f);
        EXPECT_EQ(model.fields[4].values[i], 9.0f);
    }
}

TEST(DerivedFields, KnowOperatorsFunctionsAndConstants)
{
    const std::string data = writeVelocity();
    const auto value = [&](const std::string& expression) {
        return loadDerived(data, {"a = " + expression}, {"a"}).fields[0].values[0];
    };
    EXPECT_EQ(value("2^3^2"), 512.0f);
    EXPECT_EQ(value("-2^2"), -4.0f);
    EXPECT_EQ(value("1e-1 + 1E+1 + .5"), 10.6f);
    EXPECT_EQ(value("velx <= 1 && velx != 3 ? 5 : 6"), 5.0f);
    EXPECT_EQ(value("pow(2, 0.5)"), std::sqrt(2.0f));
    EXPECT_EQ(value("log(_e) + log10(100) + log2(8) + min(3,1,2) + max(1,2)"), 9.0f);
    EXPECT_EQ(value("atan2(1, 1) - _pi/4"), 0.0f);
}

TEST(DerivedFields, PointAtTheCharacterThatIsWrong)
{
    expectRefused("speed = sqrt(velx^2+)", 20, "unexpected parenthesis )");
    expectRefused("a = b * / c", 8, "expected a value, found the operator /");
    expectRefused("a = b +", 7, "expected a value, found the end of the expression");
    expectRefused("a = (b + c", 10, "expected a closing parenthesis");
    expectRefused("a = root(b)", 4, "there is no function root");
    expectRefused("a = b = c", 6, "expected ==");
    expectRefused("a = b, c", 5, "expected one expression");
    expectRefused("a = 2nd", 4, "expected an operator behind the number");
    expectRefused("a = 'x + 1", 4, "expected a closing quote");
    expectRefused("a = ''", 4, "expected a name between the quotes");
    expectRefused("a + 1", 2, "expected = behind the name");
    expectRefused("a", 1, "expected = behind the name");
    expectRefused("", 0, "expected a name");
    expectRefused("= 3", 0, "expected a name");
    expectRefused("a =", 3, "expected an expression");
    expectRefused("a = b $ c", 6, "this cannot be understood");
    expectRefused("a = 'long name' c", 16, "expected an operator before");
    expectRefused("a = b ? 1", 9, "expected : and a value");
    EXPECT_TRUE(says(refusal("a = sqrt()").what(), {"too few arguments of sqrt"}));
    EXPECT_TRUE(says(refusal("a = sqrt(b, c)").what(), {"too many arguments of sqrt"}));
    EXPECT_TRUE(says(refusal("a = " + std::string(20000, '1')).what(), {"at most 10000 characters"}));
}

TEST(DerivedFields, PointAtNamesThatAreNotThereCountingCharactersNotBytes)
{
    const TextError error = refusal("größe = velx + 'no such'", writeVelocity());
    EXPECT_TRUE(says(error.what(), {"t.exa: there is no field 'no such'", "velx, vely, velz, dens", "character 16"}));
    EXPECT_EQ(error.excerpt(), "größe = velx + 'no such'\n" + std::string(15, ' ') + "^");
}

TEST(DerivedFields, HaveNamesOfTheirOwn)
{
    EXPECT_TRUE(says(errorOf([] {
                         parseDerivedFields(Texts{"a = 1", "a = 2"}, "--derive");
                     }),
                     {"'a' is defined twice"}));
    EXPECT_TRUE(says(errorOf([] { derived(writeVelocity(), {"dens = 2"}); }), {"has a field 'dens' already"}));
}

TEST(DerivedFields, ThatAreNotFiniteAreAnErrorOrHoles)
{
    const std::string data = writeVelocity();
    const Texts definition{"inverse = 1 / (velx - 1)"}; // velx is 1 in the cells at x = 0 of level 1
    EXPECT_TRUE(says(errorOf([&] { loadDerived(data, definition, {"inverse"}, 1); }),
                     {"1 / (velx - 1)", "found inf in field 'inverse'", "voxel (0,0,0) of level 1"}));
    const Model model = loadDerived(data, definition, {"inverse"}, 2, NonFinite::empty);
    EXPECT_EQ(model.cellCount, 576u - 16u);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_TRUE(says(model.notes[0], {"16 cells without a finite value left out"}));
    // What is not asked for itself makes no holes.
    EXPECT_EQ(loadDerived(data, {definition[0], "a = velx"}, {"a"}).cellCount, 576u);
}

TEST(DerivedFields, CanBeStopped)
{
    Progress stopped;
    stopped.cancel();
    const auto set = derived(writeVelocity(), {"a = velx"});
    EXPECT_THROW(set->load(Texts{"a"}, Executor(2), stopped), Cancelled);
}

TEST(FlowTerms, AreDerivativesOfVectorsAndFields)
{
    // (x, y^2, -z): divergence 2 y, Q of the diagonal gradient, no vorticity.
    const Model model = loadDerived(writeVelocity(),
                                    {"q = qcriterion(vel)", "d = divergence( 'vel' )", "w = vorticity_magnitude(vel)",
                                     "l = lambda2(vel)", "g = gradient_magnitude(vely)"},
                                    {"q", "d", "w", "l", "g", "vely"});
    for (std::uint64_t i = 0; i < model.cellCount; ++i) {
        const auto value = [&](int field) { return model.fields[std::size_t(field)].values[i]; };
        const float y = std::sqrt(value(5));
        EXPECT_NEAR(value(0), -1.0f - 2.0f * y * y, 1e-3f * y * y + 1e-4f);
        EXPECT_NEAR(value(1), 2.0f * y, 1e-3f);
        EXPECT_NEAR(value(2), 0.0f, 1e-3f);
        EXPECT_NEAR(value(3), std::min(4.0f * y * y, 1.0f), 2e-3f); // eigenvalues 1, 1 and 4 y^2, the middle one
        EXPECT_NEAR(value(4), 2.0f * y, 1e-3f);
    }
    EXPECT_EQ(model.fields[0].range, rangeOf(model.fields[0].values));
}

TEST(FlowTerms, StandInExpressionsLikeValues)
{
    const Model model = loadDerived(writeVelocity(),
                                    {"q = qcriterion(vel)", "a = -2 * qcriterion(vel) + dens/qcriterion(vel)",
                                     "b = ( gradient_magnitude(dens)^divergence(vel) )", "d = divergence(vel)"},
                                    {"q", "a", "b", "dens", "d"});
    for (std::uint64_t i = 0; i < model.cellCount; ++i) {
        const double q = model.fields[0].values[i], dens = model.fields[3].values[i];
        EXPECT_EQ(model.fields[1].values[i], static_cast<float>(-2 * q + dens / q));
        EXPECT_NEAR(model.fields[2].values[i], 1.0f, 1e-2f);
    }
}

TEST(FlowTerms, TakeDefinitionsBeforeThemAlsoAsVectors)
{
    const std::string data = writeVelocity();
    const Model model = loadDerived(data,
                                    {"m_x = 2 * velx", "m_y = 2 * vely", "m_z = 2 * velz", "twice = divergence(m)",
                                     "once = divergence(vel)", "speed = vel_magnitude", "g = gradient_magnitude(speed)",
                                     "h = gradient_magnitude(vel_magnitude)"},
                                    {"twice", "once", "g", "h"});
    for (std::uint64_t i = 0; i < model.cellCount; ++i)
        EXPECT_NEAR(model.fields[0].values[i], 2.0f * model.fields[1].values[i], 1e-4f);
    EXPECT_EQ(model.fields[2].values, model.fields[3].values);
    EXPECT_GT(model.fields[2].range.hi, 1.0f);
}

TEST(FlowTerms, ThatCannotBeUnderstoodArePointedAt)
{
    expectRefused("q = qcriterion()", 15, "expected the name of a vector");
    expectRefused("q = 1 + qcriterion(vel * 2)", 23, "expected ) behind the name of a vector");
    expectRefused("q = gradient_magnitude(sqrt(dens))", 27, "expected ) behind the name of a field; what is computed");
    expectRefused("q = lambda2(vel", 15, "expected ) behind");
    expectRefused("q = lambda2('vel)", 12, "expected a closing quote");
    expectRefused("q = lambda2(vel) vel", 17, "expected an operator before");
    const std::string data = writeVelocity();
    const TextError scalar = refusal("a = 1 + qcriterion(dens)", data);
    EXPECT_TRUE(says(scalar.what(), {"t.exa: there is no vector 'dens' for qcriterion", "those there are: vel"}));
    EXPECT_EQ(scalar.excerpt(), "a = 1 + qcriterion(dens)\n" + std::string(19, ' ') + "^");
    EXPECT_TRUE(says(refusal("a = gradient_magnitude(vel)", data).what(), {"no field 'vel', which is a vector"}));
    EXPECT_TRUE(says(refusal("a = gradient_magnitude(a)", data).what(), {"no field 'a'"}));
    const std::string scalars = writeData({{"dens", [](const vec3d& p) { return p.x; }}});
    EXPECT_TRUE(says(refusal("q = qcriterion(velocity)", scalars).what(), {"no three fields have names such as"}));
}

TEST(FlowTerms, SeeHolesWhereAValueIsNotFinite)
{
    // 1 / (x - 1) has no value in the cells at x = 0 of level 1; those beside have neighbours on one side alone.
    const std::string data = writeVelocity();
    const Texts definitions{"inverse = 1 / (velx - 1)", "g = gradient_magnitude(inverse)",
                            "x = gradient_magnitude(velx)"};
    EXPECT_TRUE(says(errorOf([&] { loadDerived(data, definitions, {"g"}); }), {"found inf in field 'inverse'"}));
    const Model model = loadDerived(data, definitions, {"g", "x"}, 2, NonFinite::empty);
    EXPECT_EQ(model.cellCount, 576u - 16u);
    EXPECT_EQ(model.notes.size(), 1u);
    for (const float slope : model.fields[1].values)
        EXPECT_NEAR(slope, 1.0f, 1e-4f);
}

TEST(FlowTerms, AreInTheUnitsOfTheWorld)
{
    const std::string sphere = BRICKWALL_SOURCE_DIR "/../shared/data/amrex/sphere_laminar_3lev_plt00360";
    if (!std::filesystem::exists(sphere))
        GTEST_SKIP() << "no sample data in " << sphere;
    const Model model = loadDerived(sphere, {"w = vorticity_magnitude(velocity)"}, {"w", "x_velocity"});
    // About the change of the velocity over the boundary layer, some cells of 1/16 cm.
    EXPECT_GT(model.fields[0].range.hi, 0.5f * model.fields[1].range.hi / 0.0625f);
    EXPECT_LT(model.fields[0].range.hi, 3.0f * model.fields[1].range.hi / 0.0625f);
}

TEST(VectorFields, AreRecognisedByTheirNames)
{
    const auto vectorIn = [](const Texts& names) {
        const auto found = findVectors(names);
        return found.size() == 1 ? found[0] : VectorFields{};
    };
    const auto expect = [&](const Texts& names, const std::string& name) {
        const VectorFields vector = vectorIn(names);
        EXPECT_EQ(vector.name, name) << names[0];
        EXPECT_EQ(Texts(vector.components.begin(), vector.components.end()), names);
    };
    expect({"x_velocity", "y_velocity", "z_velocity"}, "velocity");
    expect({"velx", "vely", "velz"}, "vel");
    expect({"u", "v", "w"}, "velocity");
    expect({"Velocity_x", "Velocity_y", "Velocity_z"}, "Velocity");
    expect({"Velocity_X", "Velocity_Y", "Velocity_Z"}, "Velocity");
    expect({"VectorXYZ_0", "VectorXYZ_1", "VectorXYZ_2"}, "VectorXYZ");
    expect({"B.x", "B.y", "B.z"}, "B");
    expect({"X-momentum", "Y-momentum", "Z-momentum"}, "momentum");
    EXPECT_EQ(vectorIn({"velz", "dens", "velx", "vely"}).components[2], "velz");
}

TEST(VectorFields, NeedAllThreeComponentsAndAName)
{
    EXPECT_TRUE(findVectors(Texts{"velx", "vely", "u", "v", "x", "y", "z", "dye0", "dye1", "dye2"}).empty());
    EXPECT_TRUE(findVectors(Texts{}).empty());
}

TEST(VectorFields, HaveAMagnitudeThatIsAField)
{
    const std::string data = writeVelocity();
    const Model model = loadDerived(data, {"speed = sqrt(velx^2+vely^2+velz^2)", "half = vel_magnitude / 2"},
                                    {"vel_magnitude", "speed", "half"});
    EXPECT_EQ(model.fields[0].name, "vel_magnitude");
    EXPECT_EQ(model.fields[0].values, model.fields[1].values);
    EXPECT_EQ(model.fields[2].values[0], model.fields[0].values[0] / 2);
    EXPECT_EQ(derived(data, {})->fieldNames().size(), 4u);
    EXPECT_TRUE(says(errorOf([&] { loadDerived(data, {}, {"nosuch"}); }), {"no field 'nosuch'", "vel_magnitude"}));
    // The user's definition goes first.
    EXPECT_EQ(loadDerived(data, {"vel_magnitude = 3"}, {"vel_magnitude"}).fields[0].range, (Range{3, 3}));
}

TEST(VectorFields, OfPlotfilesAreTheirVelocity)
{
    const std::string sphere = BRICKWALL_SOURCE_DIR "/../shared/data/amrex/sphere_laminar_3lev_plt00360";
    if (!std::filesystem::exists(sphere))
        GTEST_SKIP() << "no sample data in " << sphere;
    const auto vectors = findVectors(openDataSet(sphere)->fieldNames());
    ASSERT_EQ(vectors.size(), 1u);
    EXPECT_EQ(vectors[0].magnitude(), "velocity_magnitude");
    const Texts names{"velocity_magnitude", "x_velocity", "y_velocity", "z_velocity"};
    const Model model = loadDerived(sphere, {}, names);
    for (std::uint64_t i = 0; i < model.cellCount; ++i) {
        const double x = model.fields[1].values[i], y = model.fields[2].values[i], z = model.fields[3].values[i];
        ASSERT_EQ(model.fields[0].values[i], static_cast<float>(std::sqrt(x * x + y * y + z * z)));
    }
    EXPECT_EQ(model.fields[0].range.lo, 0.0f); // in the ball
}

} // namespace
} // namespace brickwall
