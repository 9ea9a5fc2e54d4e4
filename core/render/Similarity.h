// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Frame.h"

#include <span>

namespace brickwall {

/// The least width and height of pictures that are compared: that of the window.
inline constexpr int similarityWindow = 11;

/// Mean structural similarity (SSIM) of two grey pictures with values in [0, 1]; 1 for equal ones, at least -1. Wang,
/// Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE
/// Transactions on Image Processing 13(4), 2004, with its parameters: a Gaussian window of 11 x 11 pixels with standard
/// deviation 1.5, K1 = 0.01, K2 = 0.03, averaged over all windows that lie inside. Throws Error for pictures smaller
/// than the window.
double structuralSimilarity(std::span<const float> a, std::span<const float> b, int width, int height);

/// Of what people would see: luma (0.299 R + 0.587 G + 0.114 B) of the sRGB picture over black, not rounded to 8 bits.
/// 0 if a component is not finite. Throws Error if the sizes differ.
double structuralSimilarity(const Frame& a, const Frame& b);

} // namespace brickwall
