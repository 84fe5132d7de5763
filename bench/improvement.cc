#include "improvement.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>

#include "rooms.h"
#include "timing.h"

namespace layoutbox::bench {
namespace {

std::atomic<bool> stopped_by_timer = false;

// Sets the flag above after so many seconds of this process's processor time.
class StopTimer {
 public:
  explicit StopTimer(double seconds) {
    stopped_by_timer = false;
    std::signal(SIGALRM, [](int) { stopped_by_timer = true; });
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL, event.sigev_signo = SIGALRM;
    timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer_);
    itimerspec when{};
    when.it_value.tv_sec = static_cast<time_t>(seconds);
    when.it_value.tv_nsec = static_cast<long>((seconds - std::floor(seconds)) * 1e9) + 1;
    timer_settime(timer_, 0, &when, nullptr);
  }
  ~StopTimer() { timer_delete(timer_); }
  StopTimer(const StopTimer&) = delete;
  StopTimer& operator=(const StopTimer&) = delete;

 private:
  timer_t timer_{};
};

// Improved without end, but stopped after so much processor time.
Result<Layout> improved_for(const SceneGraph& scene, double seconds, std::uint64_t seed = 1) {
  SolveOptions ask = first_legal(1'000'000);
  ask.seed = seed, ask.improve = true, ask.effort = 100'000'000, ask.stop = &stopped_by_timer;
  const StopTimer timer(seconds);
  return solve(scene, Catalog::builtin(), ask);
}

double cost_of(const Layout& layout) { return 1 / layout.score - 1; }

// The best of one seed after another, as long as there is time.
Result<Layout> best_within(const SceneGraph& scene, double seconds) {
  const double end = cpu_seconds() + seconds;
  Result<Layout> best = improved_for(scene, seconds);
  for (std::uint64_t seed = 2; best && end - cpu_seconds() > 0.01; ++seed) {
    Result<Layout> other = improved_for(scene, end - cpu_seconds(), seed);
    if (other && other->score > best->score) best = std::move(other);
  }
  return best;
}

constexpr double kSoon = 0.1;  // seconds after the first legal layout

}  // namespace

void improvement(const std::vector<int>& sizes, int rooms, int first_room, double limit, double best_known) {
  for (const int n : sizes) {
    std::vector<double> shares;
    double whole = 0;
    for (int seed = first_room; seed < first_room + rooms; ++seed) {
      const SceneGraph scene = furnished_scene(n, static_cast<std::uint64_t>(seed));
      Result<Layout> first = Layout{}, soon = Layout{};
      const double found = timed([&] { first = solve(scene, Catalog::builtin(), first_legal(limit)); });
      const double ended = timed([&] { soon = improved_for(scene, found + kSoon); });
      const auto late = best_within(scene, best_known);
      if (!first || !soon || !late) continue;
      const double way = cost_of(*first) - std::min(cost_of(*late), cost_of(*soon));
      shares.push_back(way <= 0 ? 1 : (cost_of(*first) - cost_of(*soon)) / way);
      whole += ended - found;
      fmt::print("  room {}: first after {:.1f} ms {:.3f}, {:.0f} ms later {:.3f}, after {:.0f} s {:.3f}: share {:.3f}\n", seed,
                 1000 * found, cost_of(*first), 1000 * (ended - found), cost_of(*soon), best_known, cost_of(*late), shares.back());
      std::fflush(stdout);
    }
    std::sort(shares.begin(), shares.end());
    if (!shares.empty())
      fmt::print("{} objects, {} rooms: share of the way {:.0f} ms after the first: median {:.3f}, least {:.3f}\n", n, shares.size(),
                 1000 * whole / static_cast<double>(shares.size()), shares[shares.size() / 2], shares[0]);
  }
}

}  // namespace layoutbox::bench
