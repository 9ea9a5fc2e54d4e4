// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The careful half of the bounded method: piece by piece between planes through cell centres, each in parts that are
/// as long as the budget allows. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_BOUNDED_PIECES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_BOUNDED_PIECES_H
#undef BRICKWALL_CORE_TRACE_BOUNDED_PIECES_H
#else
#define BRICKWALL_CORE_TRACE_BOUNDED_PIECES_H
#endif

#include "brickwall/core/trace/BoundedRays.h"
#include "brickwall/core/trace/PartColors.h"
#include "brickwall/core/trace/RegionBounds.h"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// Stands for PieceColors where colours are the field's own.
struct NoPieceColors
{
    template <class... Arguments>
    HWY_INLINE explicit NoPieceColors(const Arguments&...)
    {
    }
};

/// Pieces: OneBrickPieces or SeveralBricksPieces. `colored`: by another field.
template <class Pieces, bool shaded, bool colored>
class BoundedPieces
{
public:
    HWY_INLINE BoundedPieces(BoundedRays& rays, const Region& region, std::uint32_t index)
        : rays_(rays),
          bounds_(rays.scene.regionBounds[index]),
          range_(rays.scene.field->regionRanges[index]),
          piece_(*rays.scene.regions, region, rays.scene.field->values.data(), rays.scene.origin, rays.ray),
          colors_(rays.scene, region, rays.ray, rays.colors),
          width_(static_cast<float>(1 << region.finestLevel)),
          carried_(firstLanes(0)),
          last_{range_.lo, 0.0f, rays.lookup.at(range_.lo, carried_), 1.0f}
    {
    }

    /// Through [t0, t1] of the region, in lanes where t0 < t1.
    HWY_INLINE void operator()(MaskN todo, FloatN t0, FloatN t1)
    {
        const Range visible = rays_.scene.integral->visible;
        const FloatN shortest =
            fma(max(abs(t0), abs(t1)), tuning::planeRounding, tuning::planeRoundingInCells * width_);
        FloatN t = t0;
        while (any(todo)) {
            FloatN end = piece_.end(t, shortest);
            end = select(end + shortest < t1, end, t1);
            piece_.load(t, end);
            rays_.counts.fetches += count(todo) * piece_.fetches();
            const FloatN least = piece_.least(), largest = piece_.largest();
            const FloatN noise = FloatN(tuning::valueRounding) * max(abs(least), abs(largest));
            const MaskN seen = todo & (largest + noise >= FloatN(visible.lo)) & (least - noise <= FloatN(visible.hi));
            rays_.counts.piecesSkipped += count(todo) - count(seen);
            const QuadN before = rays_.last;
            rays_.last = select(todo, QuadN{0.0f, 0.0f, 0.0f, 0.0f}, rays_.last);
            if (any(seen)) {
                loadColors(seen, t, end);
                refine(seen, t, end - t);
            }
            carried_ = carried_ & seen;
            suggestStep(todo, before, t, end);
            t = end;
            todo = todo & (t < t1) & rays_.goOn();
        }
    }

private:
    HWY_INLINE void loadColors(MaskN lanes, FloatN t, FloatN end)
    {
        if constexpr (colored) {
            colors_.load(t, end);
            rays_.counts.fetches += count(lanes) * colors_.fetches();
        }
    }

    /// Goes through a piece: a part that does not fit is halved, one that does is followed by one of twice its length.
    HWY_INLINE void refine(MaskN todo, FloatN t0, FloatN length)
    {
        if constexpr (shaded)
            piece_.loadGradient();
        FloatN s = 0.0f, h = 1.0f;
        PlaceN a = startOf(todo);
        ColorPlace ca = colorAt(s, todo);
        if constexpr (shaded)
            chargeJump(todo, t0, a);
        const FloatN perLength = rays_.budget.perLength(t0);
        const MaskN all = todo;
        MaskN split = firstLanes(0);
        while (any(todo)) {
            const PlaceN b = placeAt(s + h, todo);
            const ColorPlace cb = colorAt(s + h, todo);
            const ExtentN extent{piece_.enclosure(s, s + h), range_, bounds_, h, h * length};
            const FloatN t = fma(s, length, t0), most = mostError(extent);
            const auto colorExtent = colorExtentOf(s, h);
            PartN whole =
                wholePart<shaded>(rays_.lookup, todo, a, b, extent, tintsOf(ca, cb, cb, colorExtent, extent.length));
            addColorRounding(whole, todo, ca, cb);
            MaskN good = todo & fits(whole, extent, perLength);
            rays_.add(good, whole, most, t, extent.length);
            const MaskN rest = andNot(todo, good);
            if (any(rest)) {
                const FloatN middle = fma(0.5f, h, s);
                const PlaceN m = placeAt(middle, rest);
                const ColorPlace cm = colorAt(middle, rest);
                PartN halves = halvedPart<shaded>(rays_.lookup, rest, a, m, b, whole.segment, extent,
                                                  tintsOf(ca, cm, cb, colorExtent, extent.length));
                addColorRounding(halves, rest, ca, cb);
                const MaskN better = rest & (fits(halves, extent, perLength) | (h <= FloatN(tuning::shortestPart)));
                rays_.add(better, halves, most, t, extent.length);
                good = good | better;
                split = split | andNot(rest, better);
            }
            s = select(good, s + h, s);
            copyWhere(good, b, a);
            copyWhere(good, cb, ca);
            h = select(good, min(h + h, FloatN(1.0f) - s), FloatN(0.5f) * h);
            todo = todo & (s < FloatN(1.0f - 0.5f * tuning::shortestPart)) & rays_.goOn();
        }
        carry(all, a, ca);
        rays_.counts.piecesSplit += count(split);
    }

    // What colours of another field add to all that; nothing if there are none.
    struct NoColor
    {
    };
    using ColorPlace = std::conditional_t<colored, ColorPlaceN, NoColor>;
    HWY_INLINE static void copyWhere(MaskN, NoColor, NoColor) {}
    template <class Place>
    HWY_INLINE static void copyWhere(MaskN lanes, const Place& from, Place& to)
    {
        brickwall::HWY_NAMESPACE::copyWhere(lanes, from, to);
    }

    HWY_INLINE ColorPlace colorAt(FloatN s, MaskN lanes)
    {
        if constexpr (colored) {
            rays_.counts.samples += count(lanes);
            return colors_.at(s, lanes);
        } else {
            return {};
        }
    }

    HWY_INLINE auto colorExtentOf(FloatN s, FloatN h) const
    {
        if constexpr (colored)
            return ColorExtentN{colors_.enclosure(s, s + h), h, bounds_.colorSlope};
        else
            return NoColor();
    }

    template <class Extent>
    HWY_INLINE auto tintsOf(const ColorPlace& a, const ColorPlace& m, const ColorPlace& b, const Extent& extent,
                            FloatN length) const
    {
        if constexpr (colored)
            return TintsN{rays_.colors, a, m, b, extent, length};
        else
            return NoTints();
    }

    HWY_INLINE void addColorRounding(PartN& part, MaskN lanes, const ColorPlace& a, const ColorPlace& b) const
    {
        if constexpr (colored)
            part.rounding =
                fma(part.segment.opacity, tintRounding(rays_.colors, lanes, a, b, bounds_.colorSlope), part.rounding);
    }

    /// Of a part, per transmittance, if nothing of what was taken to be there is.
    HWY_INLINE FloatN mostError(const ExtentN& extent) const
    {
        return min(FloatN(bounds_.extinction) * extent.length, 1.0f);
    }

    HWY_INLINE MaskN fits(const PartN& part, const ExtentN& extent, FloatN perLength) const
    {
        const FloatN through = rays_.radiance.transmittance, opacity = part.segment.opacity;
        const FloatN allowed = max(rays_.budget.share(perLength, extent.length, opacity),
                                   through * opacity * FloatN(tuning::opacityRounding));
        return through * min(part.error, mostError(extent)) <= allowed;
    }

    HWY_INLINE PlaceN placeAt(FloatN s, MaskN lanes)
    {
        PlaceN place;
        piece_.at(s, place.value, place.slope);
        place.look = rays_.lookup.at(place.value, lanes);
        place.shade = shadeAt(s);
        rays_.counts.samples += count(lanes);
        return place;
    }

    HWY_INLINE FloatN shadeAt(FloatN s) const
    {
        if constexpr (shaded)
            return rays_.headlight.cosine(piece_.gradientAt(s));
        else
            return 1.0f;
    }

    /// The place at the start of a piece: B is continuous, so that what the last piece looked up at its end is still
    /// true. Its slope and the light are not.
    HWY_INLINE PlaceN startOf(MaskN lanes)
    {
        if (any(andNot(lanes, carried_))) {
            PlaceN place = placeAt(0.0f, lanes);
            copyWhere(lanes & carried_, last_.look, place.look);
            return place;
        }
        PlaceN place = last_;
        piece_.at(0.0f, place.value, place.slope);
        place.shade = shadeAt(0.0f);
        return place;
    }

    /// At a plane through cell centres the gradient jumps, and the light with it: rounding decides where that is.
    HWY_INLINE void chargeJump(MaskN lanes, FloatN t, const PlaceN& start)
    {
        const FloatN jump = abs(abs(start.shade) - rays_.lastLight), density = start.look.density().d;
        const FloatN error = min(density * piece_.roundingAt(t), 1.0f) * jump;
        rays_.rounding += valueOrZero(lanes & (rays_.lastAt == t) & (rays_.lastStep == FloatN(0.0f)),
                                      rays_.radiance.transmittance * error);
    }

    /// Keeps the end of a piece for the next one, and for steps.
    HWY_INLINE void carry(MaskN lanes, const PlaceN& end, const ColorPlace& color)
    {
        QuadN density = end.look.density();
        if constexpr (colored)
            density = withColor(density, color.look.limit);
        const FloatN shade = abs(end.shade);
        if constexpr (shaded)
            rays_.lastLight = select(lanes, shade, rays_.lastLight);
        rays_.last =
            select(lanes, QuadN{density.a * shade, density.b * shade, density.c * shade, density.d}, rays_.last);
        copyWhere(lanes, end, last_);
        carried_ = lanes;
    }

    /// What the change over a piece says of steps with samples.
    HWY_INLINE void suggestStep(MaskN lanes, const QuadN& before, FloatN t, FloatN end)
    {
        BoundedRays& r = rays_;
        const FloatN h = end - t, change = r.changeTo(before) + (shaded ? r.last.d : FloatN(0.0f));
        const FloatN errs = r.radiance.transmittance * h * FloatN(0.25f) * change;
        const FloatN allowed = r.budget.squares(r.budget.perLength(t)) * h;
        const FloatN wanted = cubeRoot(allowed / max(errs * errs, FloatN(1e-30f)));
        r.step = select(lanes, h * min(wanted, 2.0f), r.step);
        r.lastAt = select(lanes, end, r.lastAt);
        r.lastStep = select(lanes, 0.0f, r.lastStep);
    }

    BoundedRays& rays_;
    const RegionBounds& bounds_;
    const Range& range_;
    Pieces piece_;
    std::conditional_t<colored, PieceColors<Pieces>, NoPieceColors> colors_;
    float width_;   ///< of a cell
    MaskN carried_; ///< where last_ is the end of the piece before
    PlaceN last_;
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
