// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ProceduralNoise.h"

#include <algorithm>
#include <bit>

namespace brickwall {
namespace {

/// Perlin's twelve directions, from the centre of a cube to its edges, four of them twice to fill sixteen.
constexpr double directions[16][3] = {{1, 1, 0},  {-1, 1, 0},  {1, -1, 0}, {-1, -1, 0}, {1, 0, 1},  {-1, 0, 1},
                                      {1, 0, -1}, {-1, 0, -1}, {0, 1, 1},  {0, -1, 1},  {0, 1, -1}, {0, -1, -1},
                                      {1, 1, 0},  {-1, 1, 0},  {0, -1, 1}, {0, -1, -1}};

/// The upper bits of the result depend on all bits of the key.
std::uint32_t mix(std::uint32_t h)
{
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    return h * 0x297a2d39u;
}

double along(std::uint32_t direction, const double* offset)
{
    const double* d = directions[direction & 15u];
    return d[0] * offset[0] + d[1] * offset[1] + d[2] * offset[2];
}

double fade(double t)
{
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double mixed(double a, double b, double t)
{
    return a + t * (b - a);
}

/// Rounds down without a call into the mathematical library.
int floorToInt(double x)
{
    const int i = int(x);
    return i - (x < double(i));
}

/// A point in its cell of the lattice: hashes of the eight corners, offsets from them, and the weights of the upper
/// ones.
struct Lattice
{
    std::uint32_t hash[8];
    double offset[8][3];
    double u, v, w;

    Lattice(const vec3d& p, std::uint32_t seed)
    {
        const int i = floorToInt(p.x), j = floorToInt(p.y), k = floorToInt(p.z);
        const double x = p.x - i, y = p.y - j, z = p.z - k;
        const std::uint32_t kx[2] = {std::uint32_t(i) * 0x9e3779b1u, std::uint32_t(i + 1) * 0x9e3779b1u};
        const std::uint32_t ky[2] = {std::uint32_t(j) * 0x85ebca77u, std::uint32_t(j + 1) * 0x85ebca77u};
        const std::uint32_t kz[2] = {std::uint32_t(k) * 0xc2b2ae3du, std::uint32_t(k + 1) * 0xc2b2ae3du};
        for (int n = 0; n < 8; ++n) {
            const int a = n & 1, b = (n >> 1) & 1, c = n >> 2;
            hash[n] = mix((kx[a] ^ ky[b] ^ kz[c]) + seed * 0x27d4eb2fu);
            offset[n][0] = x - a;
            offset[n][1] = y - b;
            offset[n][2] = z - c;
        }
        u = fade(x);
        v = fade(y);
        w = fade(z);
    }

    /// Noise whose directions are the four bits of the hashes from `shift` on.
    double noise(int shift) const
    {
        double c[8];
        for (int n = 0; n < 8; ++n)
            c[n] = along(hash[n] >> shift, offset[n]);
        const double low = mixed(mixed(c[0], c[1], u), mixed(c[2], c[3], u), v);
        const double high = mixed(mixed(c[4], c[5], u), mixed(c[6], c[7], u), v);
        return mixed(low, high, w);
    }
};

} // namespace

double gradientNoise(const vec3d& p, std::uint32_t seed)
{
    return Lattice(p, seed).noise(28);
}

vec3d gradientNoise3(const vec3d& p, std::uint32_t seed)
{
    const Lattice lattice(p, seed);
    return {lattice.noise(28), lattice.noise(24), lattice.noise(20)};
}

double smoothStep(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double portableExp2(double x)
{
    const int whole = floorToInt(x + 0.5);
    const double y = (x - whole) * 0.6931471805599453; // |y| <= ln(2)/2: the 12th term of the series is below 1e-14
    double sum = 1.0;
    for (int n = 12; n > 0; --n)
        sum = 1.0 + sum * (y * (1.0 / n));
    return sum * std::bit_cast<double>(std::uint64_t(1023 + whole) << 52);
}

} // namespace brickwall
