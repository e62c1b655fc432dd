// The tree finds each pair of moving boxes that meet, once, among boxes of all
// sizes and speeds. Exact arithmetic checks the pairs that it calls apart.
// SPDX-License-Identifier: MIT
#include "broad_phase/box_tree.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "numbers/integers/exact_number.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using broad_phase::BoundsByAxis;
using broad_phase::MovingBox;
using numbers::Exact;
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

namespace {

/// Boxes of up to 0.2, and about `large` larger ones of up to 20; all fly by up to `speed` together, and each a little
/// on its own.
std::vector<MovingBox> random_boxes(seeded::Rng& random, std::size_t count, std::size_t large, double speed) {
  std::vector<MovingBox> boxes;
  const double flight[3] = {speed * random.symmetric(), speed * random.symmetric(), speed * random.symmetric()};
  for (std::size_t i = 0; i < count; ++i) {
    MovingBox box;
    const double size = random.between(1, static_cast<int>(count)) <= static_cast<int>(large) ? 20 : 0.2;
    for (std::size_t k = 0; k < 3; ++k) {
      box.start.low[k] = 2 * random.symmetric();
      box.start.high[k] = box.start.low[k] + (random.one_in(9) ? 0 : size * random.unit());
      box.end.low[k] = box.start.low[k] + flight[k] + 0.1 * random.symmetric();
      box.end.high[k] = box.end.low[k] + (random.one_in(9) ? 0 : size * random.unit());
    }
    boxes.push_back(box);
  }
  return boxes;
}

/// Whether the boxes share a point at some time of the step: an interval of times, so if at all, then at one of the
/// step's ends or where some bound of one box passes one of the other.
bool meet_exactly(const MovingBox& a, const MovingBox& b) {
  std::array<std::pair<Exact, Exact>, 6> room;  // at both ends of the step
  for (std::size_t k = 0; k < 3; ++k) {
    room[2 * k] = {Exact(b.start.high[k]) - Exact(a.start.low[k]), Exact(b.end.high[k]) - Exact(a.end.low[k])};
    room[2 * k + 1] = {Exact(a.start.high[k]) - Exact(b.start.low[k]), Exact(a.end.high[k]) - Exact(b.end.low[k])};
  }
  const Exact zero(0);
  const auto share_at = [&](const Exact& p, const Exact& q) {  // t = p / q, q > 0
    for (const auto& [at_start, at_end] : room) {
      if (at_start * (q - p) + at_end * p < zero) return false;
    }
    return true;
  };
  if (share_at(zero, Exact(1)) || share_at(Exact(1), Exact(1))) return true;
  for (const auto& [at_start, at_end] : room) {
    const Exact turn = at_end - at_start;
    if ((at_start < zero) == (at_end < zero)) continue;
    if (turn < zero ? share_at(at_start, -turn) : share_at(-at_start, turn)) return true;
  }
  return false;
}

/// Two boxes that overlap while f = high - low of one pair of bounds and g of another pair are not negative. f rises
/// and g falls, and both are zero at the same time except for one rounding. So the boxes barely meet, or miss.
std::pair<MovingBox, MovingBox> barely_meeting(seeded::Rng& random) {
  MovingBox a, b;
  for (std::size_t k = 0; k < 3; ++k) {
    for (MovingBox* box : {&a, &b}) {
      box->start.low[k] = box->end.low[k] = -1e9;
      box->start.high[k] = box->end.high[k] = 1e9;
    }
  }
  const auto number = [&] { return std::ldexp(random.symmetric(), random.between(-6, 6)); };
  // Along x, b's upper bound begins below a's lower one.
  double &low0 = a.start.low[0], &low1 = a.end.low[0], &high0 = b.start.high[0], &high1 = b.end.high[0];
  low0 = number();
  high0 = low0 - std::fabs(number());
  low1 = number();
  high1 = low1 + std::fabs(number());
  // Along y, a's upper bound ends below b's lower one.
  double &top0 = a.start.high[1], &top1 = a.end.high[1], &bottom0 = b.start.low[1], &bottom1 = b.end.low[1];
  top0 = number();
  bottom0 = top0 - std::fabs(number());
  bottom1 = number();
  const double t = (low0 - high0) / ((low0 - high0) + (high1 - low1));
  top1 = bottom1 - (top0 - bottom0) * (1 - t) / t;
  return {a, b};
}

Pairs brute_force(const std::vector<MovingBox>& boxes) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (broad_phase::meet(boxes[i], boxes[j])) pairs.insert({i, j});
    }
  }
  return pairs;
}

/// Each pair with its lesser number first.
void put_in_order(std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
  for (auto& [i, j] : pairs) {
    if (j < i) std::swap(i, j);
  }
}

}  // namespace

TEST_CASE("each pair of boxes that meet is found once, and no other") {
  seeded::Rng random(11);
  std::size_t found_in_all = 0;
  for (const std::size_t large : {0, 1, 5, 200}) {
    for (int round = 0; round < 20; ++round) {
      const double speed = round % 4 == 0 ? 0 : 10.0 * round;
      const auto a = random_boxes(random, 200, large, speed), b = random_boxes(random, 150, large / 2, speed);
      Pairs across_expected, found, across;
      for (std::uint32_t i = 0; i < a.size(); ++i) {
        for (std::uint32_t j = 0; j < b.size(); ++j) {
          if (broad_phase::meet(a[i], b[j])) across_expected.insert({i, j});
        }
      }
      broad_phase::for_each_pair(a, [&](std::uint32_t i, std::uint32_t j) { CHECK(found.insert({i, j}).second); });
      broad_phase::for_each_pair(a, b, [&](std::uint32_t i, std::uint32_t j) { CHECK(across.insert({i, j}).second); });
      CHECK(found == brute_force(a));
      CHECK(across == across_expected);
      found_in_all += found.size() + across.size();
    }
  }
  CHECK(found_in_all > 1000);
  broad_phase::for_each_pair({}, [](std::uint32_t, std::uint32_t) { FAIL("there is nothing"); });
  broad_phase::for_each_pair({}, {broad_phase::empty_moving_box()},
                             [](std::uint32_t, std::uint32_t) { FAIL("there is nothing"); });
}

TEST_CASE("blocks of pairs hold each pair once, whatever the threads, and those that meet by a time") {
  seeded::Rng random(13);
  for (const std::size_t count : {1, 8, 9, 3000, 6000, 40'000}) {
    const auto a = random_boxes(random, count, count / 1000, 1), b = random_boxes(random, count / 2 + 1, 1, 1);
    const auto tree_of = [](const std::vector<MovingBox>& boxes, int threads) {
      return broad_phase::BoxTree<BoundsByAxis>(
          boxes.size(), [&](std::uint32_t i) { return broad_phase::by_axis(boxes[i]); }, threads);
    };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> in_order;
    broad_phase::for_each_pair(a, [&](std::uint32_t i, std::uint32_t j) { in_order.push_back({i, j}); });
    const Pairs expected(in_order.begin(), in_order.end());
    Pairs expected_across;
    broad_phase::for_each_pair(a, b, [&](std::uint32_t i, std::uint32_t j) { expected_across.insert({i, j}); });
    for (const int threads : {1, 2, 5, 64}) {
      CAPTURE(count, threads);
      std::mutex lock;
      std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
      const auto take = [&](const broad_phase::Pair* pairs, std::size_t size) {
        const std::lock_guard<std::mutex> guard(lock);
        for (std::size_t i = 0; i < size; ++i) found.push_back({pairs[i][0], pairs[i][1]});
      };
      broad_phase::PairSearch search;
      search.threads = threads;
      const auto tree = tree_of(a, threads), other = tree_of(b, threads);
      broad_phase::for_each_pair_block(tree, search, take);
      put_in_order(found);
      if (threads == 1) CHECK(found == in_order);
      CHECK(found.size() == expected.size());
      CHECK(Pairs(found.begin(), found.end()) == expected);

      found.clear();
      broad_phase::for_each_pair_block(tree, other, search, take);
      CHECK(found.size() == expected_across.size());
      CHECK(Pairs(found.begin(), found.end()) == expected_across);

      // Without a tree at hand.
      found.clear();
      const broad_phase::BoxOf<BoundsByAxis> box_of = [&](std::uint32_t i) { return broad_phase::by_axis(a[i]); };
      broad_phase::for_each_pair_block(a.size(), box_of, search, take);
      put_in_order(found);
      CHECK(found.size() == expected.size());
      CHECK(Pairs(found.begin(), found.end()) == expected);

      found.clear();
      std::atomic<double> until{0.125};
      search.until = &until;
      broad_phase::for_each_pair_block(tree, search, take);
      put_in_order(found);
      const Pairs early(found.begin(), found.end());
      std::size_t lost = 0;
      for (const auto& pair : expected) {
        if (broad_phase::meet(a[pair.first], a[pair.second], 0.125) && early.count(pair) == 0) ++lost;
      }
      CHECK(lost == 0);
      CHECK((count < 1000 || early.size() < expected.size()));

      // Ended by the first pairs: then each thread may look at a part of the boxes, and hand out a block of each.
      found.clear();
      until = 1;
      std::atomic<std::size_t> asked{0};
      broad_phase::for_each_pair_block<BoundsByAxis>(
          a.size(),
          [&](std::uint32_t i) {
            ++asked;
            return broad_phase::by_axis(a[i]);
          },
          search,
          [&](const broad_phase::Pair* pairs, std::size_t size) {
            take(pairs, size);
            until = -1;
          });
      CHECK((found.empty() == expected.empty()));
      if (count == 40'000 && threads == 1) CHECK(asked < 50'000);  // each is asked once before the tree is built
    }
  }
}

TEST_CASE("what a consumer throws while the tree is built comes out, and nothing else happens") {
  seeded::Rng random(23);
  const auto boxes = random_boxes(random, 60'000, 0, 1);
  const broad_phase::BoxOf<BoundsByAxis> box_of = [&](std::uint32_t i) { return broad_phase::by_axis(boxes[i]); };
  for (const int threads : {1, 2, 16}) {
    std::atomic<int> blocks{0};
    const auto take = [&](const broad_phase::Pair*, std::size_t) {
      if (++blocks > 3) throw std::runtime_error("enough");
    };
    CHECK_THROWS_AS(broad_phase::for_each_pair_block(boxes.size(), box_of, {threads}, take), std::runtime_error);
  }
}

TEST_CASE("boxes at rest are compared as moving ones are") {
  seeded::Rng random(17);
  for (const std::size_t count : {1, 9, 300, 3000}) {
    auto moving = random_boxes(random, count, 2, 0);
    std::vector<broad_phase::Box> boxes;
    for (MovingBox& box : moving) {
      for (std::size_t k = 0; k < 3; ++k) {  // bounds that are equal, too
        box.start.low[k] = std::round(16 * box.start.low[k]) / 16;
        box.start.high[k] = std::max(box.start.low[k], std::round(16 * box.start.high[k]) / 16);
      }
      box.end = box.start;
      boxes.push_back(box.start);
    }
    Pairs expected;
    broad_phase::for_each_pair(moving, [&](std::uint32_t i, std::uint32_t j) { expected.insert({i, j}); });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    const broad_phase::BoxOf<broad_phase::Box> box_of = [&](std::uint32_t i) { return boxes[i]; };
    broad_phase::for_each_pair_block(count, box_of, {}, [&](const broad_phase::Pair* pairs, std::size_t size) {
      for (std::size_t i = 0; i < size; ++i) found.push_back({pairs[i][0], pairs[i][1]});
    });
    put_in_order(found);
    CHECK(found.size() == expected.size());
    CHECK(Pairs(found.begin(), found.end()) == expected);
    CHECK((count < 300 || expected.size() > 10));
  }
}

TEST_CASE("a box that grows by a margin reaches at least so far, and little farther") {
  seeded::Rng random(19);
  constexpr double kMost = std::numeric_limits<double>::max();
  const auto number = [&] {
    const int exponent = random.one_in(4) ? random.between(-1074, 1023) : random.between(-6, 6);
    return std::ldexp(random.one_in(3) ? 1 : random.symmetric(), exponent);
  };
  for (int i = 0; i < 200'000; ++i) {
    const double low = number(), high = random.one_in(2) ? low : std::max(low, number());
    const double margin = random.one_in(4) ? std::fabs(low) : std::fabs(number());
    broad_phase::Box box{{low, 0, -kMost}, {high, 0, kMost}};
    broad_phase::grow(box, margin);
    const auto is_at_least = [](double bound, const Exact& exact) {
      return std::isinf(bound) || !(Exact(bound) < exact);
    };
    if (margin == 0) continue;
    CAPTURE(low, high, margin);
    REQUIRE(is_at_least(box.high[0], Exact(high) + Exact(margin)));
    REQUIRE(is_at_least(-box.low[0], Exact(margin) - Exact(low)));
    REQUIRE(box.low[2] <= -kMost);
    REQUIRE(box.high[2] >= kMost);
    const double size = std::fabs(high) + margin;
    REQUIRE(box.high[0] <= high + margin + 0x1p-50 * size + 0x1p-1070);
    BoundsByAxis bounds =
        broad_phase::by_axis({{{low, 0, -kMost}, {high, 0, kMost}}, {{low, 0, -kMost}, {high, 0, kMost}}});
    broad_phase::grow(bounds, margin);
    REQUIRE((bounds.low[0][0] == box.low[0] && bounds.low[0][1] == box.low[0]));
    REQUIRE((bounds.high[0][0] == box.high[0] && bounds.high[0][1] == box.high[0]));
  }
}

TEST_CASE("boxes that are all alike, or in one place at one end of the step, make no deep tree and lose no pair") {
  for (const bool alike : {true, false}) {
    std::vector<MovingBox> boxes(300, {{{0, 0, 0}, {1, 1, 1}}, {{5, 5, 5}, {6, 6, 6}}});
    double far = 1;
    for (MovingBox& box : boxes) {  // each twice as far away as the one before
      if (alike) break;
      box.end.low[0] = far;
      box.end.high[0] = far + 1;
      far *= 2;
    }
    std::size_t found = 0;
    broad_phase::for_each_pair(boxes, [&](std::uint32_t, std::uint32_t) { ++found; });
    CHECK(found == 300 * 299 / 2);  // at t = 0 at least
  }
}

TEST_CASE("boxes that share a point at some time are never said not to meet") {
  seeded::Rng random(12);
  long meeting = 0, apart = 0, within_rounding = 0;
  const auto judge = [&](const MovingBox& a, const MovingBox& b) {
    const bool truth = meet_exactly(a, b);
    ++(truth ? meeting : apart);
    if (!truth && broad_phase::meet(a, b)) ++within_rounding;
    if (!truth) return;
    REQUIRE(broad_phase::meet(a, b));
    REQUIRE(broad_phase::meet(b, a));
  };
  for (int round = 0; round < 600; ++round) {
    const auto boxes = random_boxes(random, 24, 4, std::ldexp(1, random.between(-4, 30)));
    for (std::size_t i = 0; i + 1 < boxes.size(); ++i) judge(boxes[i], boxes[i + 1]);
  }
  CHECK(meeting > 500);
  CHECK(apart > 500);
  CHECK(within_rounding == 0);

  meeting = apart = 0;
  for (int i = 0; i < 200'000; ++i) {
    const auto [a, b] = barely_meeting(random);
    judge(a, b);
  }
  CHECK(meeting > 20'000);
  CHECK(apart > 20'000);
  CHECK(10 * within_rounding > 9 * apart);  // which is where the rounding matters
}

TEST_CASE("bounds whose difference overflows, and infinite ones, prove nothing") {
  constexpr double kMost = std::numeric_limits<double>::max(), kInfinity = std::numeric_limits<double>::infinity();
  const MovingBox passing{{{-kMost, 0, 0}, {-kMost, 1, 1}}, {{kMost, 0, 0}, {kMost, 1, 1}}};
  const MovingBox coming{{{kMost, 0, 0}, {kMost, 1, 1}}, {{-kMost, 0, 0}, {-kMost, 1, 1}}};
  const MovingBox everywhere{{{-kInfinity, 0, 0}, {kInfinity, 1, 1}}, {{-kInfinity, 0, 0}, {kInfinity, 1, 1}}};
  CHECK(broad_phase::meet(passing, coming));
  CHECK(broad_phase::meet(passing, everywhere));
  CHECK(broad_phase::meet(everywhere, everywhere));
  CHECK_FALSE(broad_phase::meet(passing, {{{-kMost, 2, 0}, {kMost, 3, 1}}, {{-kMost, 2, 0}, {kMost, 3, 1}}}));
}
