#pragma once

#include "viz/image.h"

namespace citrine::viz {

inline constexpr Colour kUnknown{15, 18, 24};    ///< never observed: the background
inline constexpr Colour kKnownFree{27, 32, 41};  ///< observed, and no surface in it
inline constexpr Colour kStrip{21, 25, 33};
inline constexpr Colour kRule{48, 55, 68};
inline constexpr Colour kText{232, 236, 241};
inline constexpr Colour kTextDim{146, 156, 170};
inline constexpr Colour kOutline{8, 10, 14};
inline constexpr Colour kIncomplete{255, 255, 255};
inline constexpr Colour kLowQuality{255, 196, 87};

/// One colour a UAV (ids from 1), cycling after seven: Okabe & Ito (2008), told apart by colour-blind readers
/// too.
Colour UavColour(int uav);

/// Colour of a share in [0, 1]: seaborn's "mako", whose lightness rises evenly, so it reads in grey as well.
Colour ShareColour(double share);

/// `a` where t = 0, `b` where t = 1.
Colour Mix(Colour a, Colour b, double t);
/// Darker (factor < 1) or lighter, clipped.
Colour Shaded(Colour colour, double factor);

}  // namespace citrine::viz
