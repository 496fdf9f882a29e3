#include "evaluate/report_series.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>

#include "evaluate/packed_bytes.h"

namespace headland {
namespace {

// The text back to bytes, by the definition of RFC 4648.
std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = (bits << 6U) | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<char>((bits >> static_cast<unsigned>(count)) & 0xffU));
  }
  return bytes;
}

std::string unpacked(const std::string& text) {
  const std::string stream = decoded(text);
  std::string bytes(1U << 22U, '\0');  // more than any series here has
  uLongf size = bytes.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                       reinterpret_cast<const Bytef*>(stream.data()), stream.size()),
            Z_OK);
  bytes.resize(size);
  return bytes;
}

std::vector<float> floats_of(const std::string& text) {
  const std::string planes = unpacked(text);
  const std::size_t count = planes.size() / 4;
  std::vector<float> numbers(count);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t byte = 0; byte < 4; ++byte) {
      bits += static_cast<std::uint32_t>(static_cast<unsigned char>(planes[byte * count + i]))
              << (8 * byte);
    }
    std::memcpy(&numbers[i], &bits, sizeof bits);
  }
  return numbers;
}

TEST(PackedBytes, Base64IsThatOfTheStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(PackedBytes, NothingIsLost) {
  EXPECT_EQ(unpacked(packed_bytes("")), "");
  const std::string bytes("any\0bytes\xff", 10);
  EXPECT_EQ(unpacked(packed_bytes(bytes)), bytes);
  const std::vector<float> numbers = {0.0F, -1.5F, 3.25e7F, -0.0F, 1e-42F, -3.4e38F};
  EXPECT_EQ(floats_of(packed_floats(numbers)), numbers);
  EXPECT_TRUE(floats_of(packed_floats({})).empty());
  const std::vector<float> none = {1.0F, std::numeric_limits<float>::quiet_NaN(), 2.0F};
  EXPECT_TRUE(std::isnan(floats_of(packed_floats(none))[1]));
  EXPECT_EQ(floats_of(packed_floats(none))[2], 2.0F);
}

TEST(PackedBytes, NeighboursThatAreAlikeTakeLittle) {
  std::vector<float> steady(10000);
  for (std::size_t i = 0; i < steady.size(); ++i) steady[i] = 0.1F * static_cast<float>(i);
  EXPECT_LT(packed_floats(steady).size(), steady.size());  // of 4 bytes a number
}

// So many samples, ten a second, straight at 1 m/s and, after half of them, round and round.
std::vector<RunSample> half_turning(std::size_t count) {
  std::vector<RunSample> samples(count);
  for (std::size_t i = 0; i < count; ++i) {
    samples[i].time_s = samples[i].travel_m = 0.1 * static_cast<double>(i);
    if (2 * i > count)
      samples[i].yaw_rad = std::remainder(0.02 * static_cast<double>(i), 6.2831853);
  }
  return samples;
}

TEST(ReportSeries, BucketsAreFewAndTheLastSampleHasItsOwn) {
  EXPECT_TRUE(bucket_starts({}, 10).empty());
  EXPECT_THAT(bucket_starts(half_turning(1), 10), testing::ElementsAre(0));
  EXPECT_THAT(bucket_starts(half_turning(4), 10), testing::ElementsAre(0, 1, 2, 3));
  for (const std::size_t count : {11U, 100U, 12345U}) {
    const std::vector<std::size_t> starts = bucket_starts(half_turning(count), 10);
    EXPECT_LE(starts.size(), 11U);
    EXPECT_EQ(starts.front(), 0U);
    EXPECT_EQ(starts.back(), count - 1);
    EXPECT_TRUE(std::is_sorted(starts.begin(), starts.end()));
  }
}

TEST(ReportSeries, TurnsAreGivenInSmallerSteps) {
  const auto starts = bucket_starts(half_turning(80000), 1000);
  const auto turning =
      std::count_if(starts.begin(), starts.end(), [](std::size_t start) { return start > 40000; });
  // Half of the half that samples get, and all of the half that turning gets.
  EXPECT_NEAR(static_cast<double>(turning), 750.0, 5.0);
}

// The negative control of a page that would grow with the run for ever.
TEST(ReportSeries, ARunTenTimesAsLongTakesNoMoreAndLosesNoExtreme) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<std::size_t> bytes;
  for (const std::size_t times : {2U, 20U}) {
    std::vector<RunSample> samples = half_turning(times * kMostReportBuckets);
    for (RunSample& sample : samples) sample.slip = noise(random);
    samples[samples.size() / 3].slip = 77.0;  // one sample long
    samples[samples.size() / 5].slip = -55.0;
    const auto json = series_json(samples, {});
    EXPECT_LE(json["count"], kMostReportBuckets + 1);
    const std::vector<float> high = floats_of(json["envelopes"]["slip"]["high"]);
    const std::vector<float> low = floats_of(json["envelopes"]["slip"]["low"]);
    EXPECT_EQ(*std::max_element(high.begin(), high.end()), 77.0F);
    EXPECT_EQ(*std::min_element(low.begin(), low.end()), -55.0F);
    bytes.push_back(json.dump().size());
  }
  EXPECT_LT(static_cast<double>(bytes[1]), 1.1 * static_cast<double>(bytes[0]));
}

TEST(ReportSeries, NoExtremeIsLost) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<double> values(50000);
  for (double& value : values) value = noise(random);
  values[12345] = 77.0;  // one sample long
  values[54321 % 50000] = -55.0;
  const auto starts = bucket_starts(half_turning(values.size()), 300);
  const Envelope envelope = envelope_of(values, starts);
  EXPECT_EQ(*std::max_element(envelope.high.begin(), envelope.high.end()), 77.0F);
  EXPECT_EQ(*std::min_element(envelope.low.begin(), envelope.low.end()), -55.0F);
  for (std::size_t bucket = 0; bucket < starts.size(); ++bucket) {
    const std::size_t end = bucket + 1 < starts.size() ? starts[bucket + 1] : values.size();
    const auto [low, high] =
        std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(starts[bucket]),
                            values.begin() + static_cast<std::ptrdiff_t>(end));
    ASSERT_EQ(envelope.low[bucket], static_cast<float>(*low));
    ASSERT_EQ(envelope.high[bucket], static_cast<float>(*high));
  }
}

TEST(ReportSeries, WhatIsNoNumberHidesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> values = {1.0, nan, 3.0, nan, nan, nan};
  const std::vector<std::size_t> starts = {0, 3};
  const Envelope envelope = envelope_of(values, starts);
  EXPECT_EQ(envelope.low[0], 1.0F);
  EXPECT_EQ(envelope.high[0], 3.0F);
  EXPECT_TRUE(std::isnan(envelope.low[1]));
}

TEST(ReportSeries, ShortRunsAreGivenWhole) {
  std::vector<RunSample> samples(5);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].time_s = 0.5 * static_cast<double>(i);
    samples[i].slip = i == 3 ? 0.25 : 0.0;
  }
  const auto json = series_json(samples, {});
  EXPECT_EQ(json["count"], 5);
  EXPECT_THAT(floats_of(json["poses"]["time_s"]), testing::ElementsAre(0, 0.5, 1, 1.5, 2));
  EXPECT_THAT(floats_of(json["envelopes"]["slip"]["low"]), testing::ElementsAre(0, 0, 0, 0.25, 0));
  EXPECT_FALSE(json["envelopes"]["slip"].contains("high"));
  EXPECT_FALSE(json["envelopes"].contains("energy_wh_per_m"));
  EXPECT_EQ(series_json({}, {})["count"], 0);
}

TEST(ReportSeries, FootprintsKeepTheEndsOfStrips) {
  std::vector<FootprintSample> footprints;
  for (int strip = 0; strip < 2; ++strip) {
    for (int i = 0; i <= 99; ++i) {
      FootprintSample footprint;
      footprint.travel_m = 20.0 * strip + 0.1 * i;
      footprint.time_s = footprint.travel_m;
      footprint.starts_strip = i == 0;
      footprints.push_back(footprint);
    }
  }
  const auto json = footprints_json(footprints);
  const std::vector<float> times = floats_of(json["time_s"]);
  const std::vector<float> starts = floats_of(json["starts_strip"]);
  EXPECT_LT(times.size(), 60U);
  EXPECT_EQ(std::count(starts.begin(), starts.end(), 1.0F), 2);
  EXPECT_THAT(times, testing::IsSupersetOf({0.0F, 9.9F, 20.0F, 29.9F}));
}

TEST(ReportSeries, TheHistogramIsOfTheDistance) {
  std::vector<RunSample> samples(5);
  const double errors_m[] = {0.0, 0.012, 0.012, -0.03, 4.9};
  const double travel_m[] = {0.0, 6.0, 6.0, 9.0, 10.0};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].cross_track_error_m = errors_m[i];
    samples[i].travel_m = travel_m[i];
    samples[i].implement_down = i < 4;
  }
  const auto json = tracking_histogram_json(samples);
  const auto edges_m = json["edges_m"].get<std::vector<double>>();
  const auto working = json["working"].get<std::vector<double>>();
  const auto turning = json["turning"].get<std::vector<double>>();
  const auto share_at = [&](const std::vector<double>& shares, double error_m) {
    const auto edge = std::upper_bound(edges_m.begin(), edges_m.end(), error_m);
    return shares[static_cast<std::size_t>(edge - edges_m.begin()) - 1];
  };
  EXPECT_LE(edges_m.front(), -4.9);
  EXPECT_GE(edges_m.back(), 4.9);
  EXPECT_DOUBLE_EQ(share_at(working, 0.012), 60.0);
  EXPECT_DOUBLE_EQ(share_at(working, -0.03), 30.0);
  EXPECT_DOUBLE_EQ(share_at(turning, 4.9), 10.0);
  EXPECT_DOUBLE_EQ(std::accumulate(working.begin(), working.end(), 0.0), 90.0);
}

}  // namespace
}  // namespace headland
