// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "ReprojectionTable.h"
#include "TestDisplay.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace brickwall::test {
namespace {

/// The tables of docs/reprojection.md, if BRICKWALL_REPROJECTION_TABLE names a folder for them.
class Document
{
public:
    explicit operator bool() const { return folder_ != nullptr; }

    void add(const std::string& sample, const WarpErrors& errors, const Image& picture) const
    {
        std::ofstream out(fmt::format("{}/{}.md", folder_, sample));
        for (const auto selection : {MultiChannelDrawer::Same, MultiChannelDrawer::MatchingEye}) {
            out << fmt::format("| {}, `{}` | 1 cm | 2 cm | 5 cm | 10 cm |\n|---|---|---|---|---|\n", sample,
                               selection == MultiChannelDrawer::Same ? "Same" : "MatchingEye");
            for (const auto& [name, mode] : comparedModes()) {
                out << "| `" << name << '`';
                for (const double offset : eyeOffsets) {
                    const WarpError& error = errors.at({selection, mode, offset});
                    out << fmt::format(" | {:.1f} dB, {:.2f} %", error.psnr(), 100.0 * error.holeShare());
                }
                out << " |\n";
            }
            out << '\n';
        }
        EXPECT_TRUE(out) << folder_;
        writePng(picture, fmt::format("{}/{}.png", folder_, sample));
    }

private:
    const char* folder_ = std::getenv("BRICKWALL_REPROJECTION_TABLE");
};

/// Decibels: the root of the mean square is half of 1/255. A few pixels of a small picture decide which mode is the
/// best beyond that (impact, 60 x 60 per screen: 58.7 against 59.3).
constexpr double invisible = 54.15;

/// `most` holes, and at most `behind` decibels worse than any other mode, as far as that can be seen.
void expectThatTheMeshPays(const std::string& sample, double most = 0.001, double behind = 0.1)
{
    BRICKWALL_NEEDS_DISPLAY();
    const Document document;
    Image picture;
    const WarpErrors errors =
        measureWarp("sample:" + sample + (document ? "" : ":200k"), document ? 200 : 60, document ? &picture : nullptr);
    if (document)
        document.add(sample, errors, picture);
    using Drawer = MultiChannelDrawer;
    for (const auto selection : {Drawer::Same, Drawer::MatchingEye}) {
        for (const double offset : eyeOffsets) {
            SCOPED_TRACE(fmt::format("views to render {}, {} m", int(selection), offset));
            const WarpError& mesh = errors.at({selection, Drawer::ReprojectMesh, offset});
            EXPECT_LT(mesh.holeShare(), most);
            for (const auto& [name, mode] : comparedModes()) {
                const double other = errors.at({selection, mode, offset}).psnr();
                EXPECT_GE(mesh.psnr(), std::min(other, invisible) - behind) << name;
            }
        }
    }
}

TEST(Reprojection, LongNoModeIsNearerToTheTruthThanTheMeshForTheWake)
{
    expectThatTheMeshPays("wake");
}

TEST(Reprojection, LongNoModeIsNearerToTheTruthThanTheMeshForTheCloud)
{
    // The head is in the haze, which goes on beyond all edges: far from where it was nothing makes up for that.
    expectThatTheMeshPays("cloud", 0.06, 0.5);
}

TEST(Reprojection, LongNoModeIsNearerToTheTruthThanTheMeshForTheImpact)
{
    expectThatTheMeshPays("impact");
}

} // namespace
} // namespace brickwall::test
