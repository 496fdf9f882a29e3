// Colours of the pictures, told apart by lightness as well as hue.
#pragma once

#include <cstdint>

namespace headland {

struct Rgba {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;
  bool operator==(const Rgba&) const = default;
};

// From `from` (t <= 0) to `to` (t >= 1), linear in sRGB values.
Rgba mix(Rgba from, Rgba to, double t);

// The viridis scale: dark violet (t <= 0) over green to yellow (t >= 1), lightness rising evenly.
// Nine of matplotlib's published nodes (CC0), linear between them.
Rgba viridis(double t);

// Energy per metre: viridis for consumption; regeneration from pale to strong magenta with
// `share` -1 being the strongest and +1 the largest consumption.
Rgba energy_colour(double share);

namespace colours {
inline constexpr Rgba kPaper{252, 252, 250};
inline constexpr Rgba kInk{28, 32, 36};
inline constexpr Rgba kInkSoft{96, 102, 108};
inline constexpr Rgba kRule{198, 202, 204};
inline constexpr Rgba kSky{222, 232, 238};

// Ground of the maps.
inline constexpr Rgba kGround{231, 228, 219};
inline constexpr Rgba kGreyGround{226, 226, 226};

// Times covered, light to dark, and missed ground (vermilion of Okabe and Ito).
inline constexpr Rgba kOnce{186, 226, 190};
inline constexpr Rgba kTwice{65, 158, 190};
inline constexpr Rgba kThrice{28, 56, 120};
inline constexpr Rgba kMissed{213, 94, 0};

inline constexpr Rgba kBoundary{28, 32, 36};
inline constexpr Rgba kPlannedPass{255, 255, 255};
inline constexpr Rgba kPlannedTurn{226, 120, 196};
inline constexpr Rgba kDriven{40, 40, 52};
inline constexpr Rgba kStart{0, 140, 90};
inline constexpr Rgba kEnd{178, 24, 43};
// Verdicts; each is also said in words.
inline constexpr Rgba kPass{0, 114, 88};
inline constexpr Rgba kWarn{176, 110, 0};
inline constexpr Rgba kFail{178, 24, 43};

inline constexpr Rgba kTree{38, 92, 44};
inline constexpr Rgba kRock{140, 134, 128};

// Soil and grass of the perspective view.
inline constexpr Rgba kMeadow{158, 176, 118};
inline constexpr Rgba kUnworked{204, 186, 134};
inline constexpr Rgba kWorked{152, 116, 82};
inline constexpr Rgba kWorkedTwice{108, 76, 54};
inline constexpr Rgba kWorkedThrice{62, 45, 38};
inline constexpr Rgba kBlockSide{196, 180, 156};
}  // namespace colours

}  // namespace headland
