// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/ColorMapData.h"

#include <array>

// Longer than most files because it is a table: each map's stops as {t, 0xRRGGBB in sRGB}, with its source.
namespace brickwall {
namespace {

// K. Moreland, "Diverging Color Maps for Scientific Visualization", 2009
constexpr ColorStop coolWarm[] = {
    {0.0f, 0x3b4cc0},     {0.03125f, 0x445acc}, {0.0625f, 0x4e68d7},  {0.09375f, 0x5875e1}, {0.125f, 0x6282ea},
    {0.15625f, 0x6c8ef1}, {0.1875f, 0x779af7},  {0.21875f, 0x82a5fb}, {0.25f, 0x8db0fe},    {0.28125f, 0x98b9ff},
    {0.3125f, 0xa3c2ff},  {0.34375f, 0xaec9fd}, {0.375f, 0xb8d0f9},   {0.40625f, 0xc2d5f4}, {0.4375f, 0xccd9ee},
    {0.46875f, 0xd5dbe6}, {0.5f, 0xdddddd},     {0.53125f, 0xe5d8d1}, {0.5625f, 0xecd3c6},  {0.59375f, 0xf1ccb9},
    {0.625f, 0xf5c4ad},   {0.65625f, 0xf7bba0}, {0.6875f, 0xf7b194},  {0.71875f, 0xf7a687}, {0.75f, 0xf49a7b},
    {0.78125f, 0xf18d6f}, {0.8125f, 0xec7f63},  {0.84375f, 0xe57057}, {0.875f, 0xde614c},   {0.90625f, 0xd55042},
    {0.9375f, 0xcb3e38},  {0.96875f, 0xc0282f}, {1.0f, 0xb40426}};

// ParaView "Cool to Warm (Extended)", F. Samsel
constexpr ColorStop coolWarmExtended[] = {
    {0.0f, 0x000059},     {0.03125f, 0x0a1061}, {0.0625f, 0x101e69},  {0.09375f, 0x172f73}, {0.125f, 0x204380},
    {0.15625f, 0x29568a}, {0.1875f, 0x336591},  {0.21875f, 0x3d7499}, {0.25f, 0x4985a6},    {0.28125f, 0x5697b3},
    {0.3125f, 0x63a7bf},  {0.34375f, 0x77bcd1}, {0.375f, 0x92d1e0},   {0.40625f, 0xa7dde8}, {0.4375f, 0xc0eaf0},
    {0.46875f, 0xd2f4f7}, {0.5f, 0xf0fbfc},     {0.5f, 0xfcf5e6},     {0.52f, 0xfcf1d9},    {0.54f, 0xfae5c8},
    {0.5625f, 0xf7d5b2},  {0.59375f, 0xf2bb96}, {0.625f, 0xeda682},   {0.65625f, 0xe8906f}, {0.6875f, 0xe0755a},
    {0.71875f, 0xd66349}, {0.75f, 0xc24b36},    {0.78125f, 0xb3362b}, {0.8125f, 0xa62821},  {0.84375f, 0x991818},
    {0.875f, 0x8c1119},   {0.90625f, 0x800d20}, {0.9375f, 0x730e2c},  {0.96875f, 0x660e31}, {1.0f, 0x591236}};

// matplotlib (CC0), S. van der Walt and N. Smith
constexpr ColorStop viridis[] = {
    {0.0f, 0x440154},      {0.066667f, 0x481a6c}, {0.133333f, 0x472f7d}, {0.2f, 0x414487},
    {0.266667f, 0x39568c}, {0.333333f, 0x31688e}, {0.4f, 0x2a788e},      {0.466667f, 0x23888e},
    {0.533333f, 0x1f988b}, {0.6f, 0x22a884},      {0.666667f, 0x35b779}, {0.733333f, 0x54c568},
    {0.8f, 0x7ad151},      {0.866667f, 0xa5db36}, {0.933333f, 0xd2e21b}, {1.0f, 0xfde725}};

// matplotlib (CC0)
constexpr ColorStop plasma[] = {
    {0.0f, 0x0d0887},      {0.033333f, 0x220690}, {0.066667f, 0x330597}, {0.1f, 0x41049d},      {0.133333f, 0x5002a2},
    {0.166667f, 0x5c01a6}, {0.2f, 0x6a00a8},      {0.233333f, 0x7701a8}, {0.266667f, 0x8405a7}, {0.3f, 0x8f0da4},
    {0.333333f, 0x9c179e}, {0.366667f, 0xa62098}, {0.4f, 0xb12a90},      {0.433333f, 0xba3388}, {0.466667f, 0xc33d80},
    {0.5f, 0xcc4778},      {0.533333f, 0xd35171}, {0.566667f, 0xda5b69}, {0.6f, 0xe16462},      {0.633333f, 0xe76f5a},
    {0.666667f, 0xed7953}, {0.7f, 0xf2844b},      {0.733333f, 0xf68f44}, {0.766667f, 0xfa9b3d}, {0.8f, 0xfca636},
    {0.833333f, 0xfdb42f}, {0.866667f, 0xfec029}, {0.9f, 0xfcce25},      {0.933333f, 0xf9dc24}, {0.966667f, 0xf5eb27},
    {1.0f, 0xf0f921}};

// matplotlib (CC0)
constexpr ColorStop inferno[] = {{0.0f, 0x000004},      {0.1f, 0x160b39}, {0.111111f, 0x1b0c41}, {0.2f, 0x420a68},
                                 {0.222222f, 0x4a0c6b}, {0.3f, 0x6a176e}, {0.333333f, 0x781c6d}, {0.4f, 0x932667},
                                 {0.444444f, 0xa52c60}, {0.5f, 0xbc3754}, {0.555556f, 0xcf4446}, {0.6f, 0xdd513a},
                                 {0.666667f, 0xed6925}, {0.7f, 0xf37819}, {0.777778f, 0xfb9b06}, {0.8f, 0xfca50a},
                                 {0.888889f, 0xf7d13d}, {0.9f, 0xf6d746}, {1.0f, 0xfcffa4}};

// matplotlib (CC0)
constexpr ColorStop magma[] = {
    {0.0f, 0x000004},   {0.1f, 0x140e36}, {0.125f, 0x1d1147}, {0.2f, 0x3b0f70}, {0.25f, 0x51127c},  {0.3f, 0x641a80},
    {0.375f, 0x822681}, {0.4f, 0x8c2981}, {0.5f, 0xb73779},   {0.6f, 0xde4968}, {0.625f, 0xe75263}, {0.7f, 0xf7705c},
    {0.75f, 0xfc8961},  {0.8f, 0xfe9f6d}, {0.875f, 0xfec488}, {0.9f, 0xfecf92}, {1.0f, 0xfcfdbf}};

// ParaView "Black-Body Radiation"
constexpr ColorStop blackBody[] = {{0.0f, 0x000000}, {0.4f, 0xe60000}, {0.8f, 0xe6e600}, {1.0f, 0xffffff}};

// ParaView "Linear Green (Gr4L)", F. Samsel
constexpr ColorStop samselLinearGreen[] = {
    {0.0f, 0x0e1c1f}, {0.05f, 0x132c2e}, {0.1f, 0x163b38}, {0.15f, 0x184740}, {0.2f, 0x1c5947}, {0.25f, 0x1d6647},
    {0.3f, 0x1e7345}, {0.35f, 0x1e7d3e}, {0.4f, 0x1d8534}, {0.45f, 0x1c8c27}, {0.5f, 0x159615}, {0.55f, 0x1ca10d},
    {0.6f, 0x36ad15}, {0.65f, 0x51b81d}, {0.7f, 0x6ec229}, {0.75f, 0x8ecc3d}, {0.8f, 0xaad64b}, {0.85f, 0xc8e065},
    {0.9f, 0xe2eb88}, {0.95f, 0xf5f2ab}, {1.0f, 0xfffbe6}};

// ParaView "Linear YGB 1211g", F. Samsel
constexpr ColorStop samselYgb[] = {
    {0.0f, 0xfffcf7},  {0.02f, 0xfff3e0}, {0.05f, 0xf7e7c6}, {0.1f, 0xf2e5a5}, {0.15f, 0xe6e08e}, {0.2f, 0xd8db7b},
    {0.25f, 0xb0d16f}, {0.3f, 0x83c462},  {0.35f, 0x56b856}, {0.4f, 0x47a864}, {0.45f, 0x3ba36f}, {0.5f, 0x34997c},
    {0.55f, 0x2c9189}, {0.6f, 0x24848c},  {0.65f, 0x22758a}, {0.7f, 0x206587}, {0.75f, 0x1e5285}, {0.8f, 0x1f4282},
    {0.85f, 0x223a80}, {0.9f, 0x25317d},  {0.95f, 0x302a78}, {1.0f, 0x423270}};

// ParaView "erdc_blue2gold_BW"
constexpr ColorStop blueGold[] = {
    {0.0f, 0x000000},      {0.062745f, 0x130b3b}, {0.12549f, 0x20076a},  {0.188236f, 0x250497}, {0.25098f, 0x3610b4},
    {0.313725f, 0x4e24c3}, {0.37647f, 0x643bc5},  {0.439215f, 0x7656b5}, {0.501961f, 0x8a6d96}, {0.564706f, 0x9d8276},
    {0.627451f, 0xb3944f}, {0.690196f, 0xcaa42b}, {0.752941f, 0xdeb51e}, {0.815686f, 0xefc728}, {0.878432f, 0xf6dc69},
    {0.941177f, 0xfbefb6}, {1.0f, 0xffffff}};

// ParaView "erdc_iceFire_H"
constexpr ColorStop iceFire[] = {
    {0.0f, 0x000000},      {0.062745f, 0x001f4d}, {0.12549f, 0x003786},  {0.188236f, 0x0e58a8}, {0.25098f, 0x217eb8},
    {0.313725f, 0x30a4ca}, {0.37647f, 0x54c8df},  {0.439215f, 0x9be4ef}, {0.501961f, 0xe1e9d1}, {0.564706f, 0xf3d573},
    {0.627451f, 0xe7b000}, {0.690196f, 0xda8200}, {0.752941f, 0xc65400}, {0.815686f, 0xac2301}, {0.878432f, 0x820000},
    {0.941177f, 0x4c0000}, {1.0f, 0x040100}};

// ParaView "nic_Edge"
constexpr ColorStop nicEdge[] = {
    {0.0f, 0x313131},      {0.062745f, 0x3d019d}, {0.12549f, 0x3810dc},  {0.188236f, 0x2d47f9}, {0.25098f, 0x2593ff},
    {0.313725f, 0x2adef6}, {0.37647f, 0x60fdfa},  {0.439215f, 0xaefdff}, {0.501961f, 0xf3f3f1}, {0.564706f, 0xfffda9},
    {0.627451f, 0xfafd5b}, {0.690196f, 0xf7da29}, {0.752941f, 0xff8e25}, {0.815686f, 0xf8432d}, {0.878432f, 0xd90d39},
    {0.941177f, 0x97023d}, {1.0f, 0x313131}};

// ParaView "Blue to Red Rainbow": the hue from blue to red
constexpr ColorStop rainbow[] = {
    {0.0f, 0x0000ff}, {0.25f, 0x00ffff}, {0.5f, 0x00ff00}, {0.75f, 0xffff00}, {1.0f, 0xff0000}};

// as in Matlab
constexpr ColorStop jet[] = {{0.0f, 0x00007f},   {0.125f, 0x0000ff}, {0.375f, 0x00ffff},
                             {0.625f, 0xffff00}, {0.875f, 0xff0000}, {1.0f, 0x7f0000}};

// after the standard map of COVISE: blue, red, yellow
constexpr ColorStop covise[] = {{0.0f, 0x0000ff}, {0.5f, 0xff0000}, {1.0f, 0xffff00}};

// ParaView "hsv": the hue all the way round
constexpr ColorStop hsv[] = {{0.0f, 0xff0000},      {0.166667f, 0xff00ff}, {0.333333f, 0x0000ff}, {0.5f, 0x00ffff},
                             {0.666667f, 0x00ff00}, {0.833333f, 0xffff00}, {1.0f, 0xff0000}};

// black to white
constexpr ColorStop grey[] = {{0.0f, 0x000000}, {1.0f, 0xffffff}};

constexpr std::array maps{
    NamedColorMap{"Cool Warm", "cooltowarm paraviewcoolwarm", coolWarm},
    NamedColorMap{"Cool Warm Extended", "cooltowarmextended", coolWarmExtended},
    NamedColorMap{"Viridis", "matplotlibviridis matplotlibvirdis virdis viridismatplotlib", viridis},
    NamedColorMap{"Plasma", "matplotlibplasma plasmamatplotlib", plasma},
    NamedColorMap{"Inferno", "matplotlibinferno infernomatplotlib", inferno},
    NamedColorMap{"Magma", "matplotlibmagma magmamatplotlib", magma},
    NamedColorMap{"Black-Body", "blackbodyradiation", blackBody},
    NamedColorMap{"Samsel Linear Green", "lineargreen lineargreengr4l", samselLinearGreen},
    NamedColorMap{"Samsel Linear YGB 1211g", "linearygb1211g", samselYgb},
    NamedColorMap{"Blue Gold", "erdcblue2goldbw blue2gold", blueGold},
    NamedColorMap{"Ice Fire", "erdcicefireh", iceFire},
    NamedColorMap{"Nic Edge", "", nicEdge},
    NamedColorMap{"Rainbow", "bluetoredrainbow", rainbow},
    NamedColorMap{"Jet", "", jet},
    NamedColorMap{"Covise", "", covise},
    NamedColorMap{"HSV", "", hsv},
    NamedColorMap{"Grey", "gray grayscale greyscale", grey},
};

} // namespace

std::span<const NamedColorMap> namedColorMaps()
{
    return maps;
}

} // namespace brickwall
