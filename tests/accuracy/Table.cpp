// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <vector>

namespace brickwall::test {
namespace {

struct Row
{
    std::string subject, transferFunction;
    KeptOfShading off, headlight;
};

std::vector<Row>& rows()
{
    static std::vector<Row> all;
    return all;
}

std::string tolerance(std::size_t e)
{
    return tolerances[e] == 1.0f / 255.0f ? "1/255" : fmt::format("{:.0e}", tolerances[e]);
}

/// Of several rows, per tolerance: the largest error in E with the transfer function and shading that has it, and the
/// sum of the pixels that are admitted to be beyond.
void writeWorst(std::ostream& out, const std::string& subject)
{
    out << "| " << subject << " |";
    for (std::size_t e = 0; e < tolerances.size(); ++e) {
        double largest = -1.0;
        std::string whose;
        std::uint64_t admitted = 0, over = 0;
        for (const Row& row : rows()) {
            if (row.subject != subject)
                continue;
            for (const KeptOfShading* kept : {&row.off, &row.headlight}) {
                const Kept& k = kept->of[e];
                admitted += k.admitted;
                over += k.over;
                if (k.largest <= largest)
                    continue;
                largest = k.largest;
                whose = row.transferFunction + (kept == &row.off ? "" : ", lit");
            }
        }
        out << fmt::format(" {:.2f} ({}); {} of {} |", largest / tolerances[e], whose, over, admitted);
    }
    out << '\n';
}

void writeHeading(std::ostream& out, const std::string& first, const char* perTolerance, int columns)
{
    std::string names = first, line;
    for (std::size_t e = 0; e < tolerances.size(); ++e)
        names += fmt::format(fmt::runtime(perTolerance), tolerance(e));
    for (int i = 0; i < columns; ++i)
        line += "|---";
    out << names << "\n" << line << "|\n";
}

/// Shading off / headlight.
template <class Member>
std::string both(const Row& row, std::size_t e, const Member& member, const char* format)
{
    return fmt::format(fmt::runtime(format), member(row.off.of[e]), member(row.headlight.of[e]));
}

void writeRow(std::ostream& out, const Row& row)
{
    out << "| " << row.subject << " | " << row.transferFunction << " |";
    for (std::size_t e = 0; e < tolerances.size(); ++e)
        out << both(
                   row, e, [&](const Kept& k) { return k.largest / tolerances[e]; }, " {:.2f} / {:.2f} |")
            << both(
                   row, e, [&](const Kept& k) { return k.rms / tolerances[e]; }, " {:.3f} / {:.3f} |")
            << both(
                   row, e, [&](const Kept& k) { return k.over; }, " {} / {}")
            << ", "
            << both(
                   row, e, [&](const Kept& k) { return k.admitted; }, "{} / {} |");
    out << '\n';
}

/// Writes the tables when all tests are done.
class TableOfTolerances : public testing::Environment
{
public:
    void TearDown() override
    {
        const char* file = std::getenv("BRICKWALL_ACCURACY_TABLE");
        if (!file || rows().empty())
            return;
        std::ofstream out(file);
        writeHeading(out, "| data |", " E = {} |", 1 + int(tolerances.size()));
        std::string last;
        for (const Row& row : rows()) {
            if (row.subject != last)
                writeWorst(out, row.subject);
            last = row.subject;
        }
        out << '\n';
        writeHeading(out, "| data | transfer function |", " E = {0}: largest / E | rms / E | pixels over, admitted |",
                     2 + 3 * int(tolerances.size()));
        for (const Row& row : rows())
            writeRow(out, row);
        if (!out)
            ADD_FAILURE() << "cannot write " << file;
    }
};

const auto* const table = testing::AddGlobalTestEnvironment(new TableOfTolerances);

} // namespace

void addToTable(const std::string& subject, const std::string& transferFunction, const KeptOfShading& off,
                const KeptOfShading& headlight)
{
    rows().push_back({subject, transferFunction, off, headlight});
}

} // namespace brickwall::test
