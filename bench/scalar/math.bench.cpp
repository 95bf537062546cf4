// What exp, log, pow, cbrt, sqrt and rsqrt cost per number, in each scalar. `std` is the library's own function on a
// double. per_number is the time of one number of 1024 that stay in the cache, each independent of the others.
#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include <strike/scalar.hpp>

namespace {

using strike::Pack;

struct Exp {
  template <class T>
  static T of(const T& x) {
    using std::exp;
    return exp(x);
  }
};
struct Log {
  template <class T>
  static T of(const T& x) {
    using std::log;
    return log(x);
  }
};
struct Pow {  // Johnson-Cook's hardening
  template <class T>
  static T of(const T& x) {
    using std::pow;
    return pow(x, 0.26);
  }
};
struct Cbrt {
  template <class T>
  static T of(const T& x) {
    using std::cbrt;
    return cbrt(x);
  }
};
struct Sqrt {
  template <class T>
  static T of(const T& x) {
    using std::sqrt;
    return sqrt(x);
  }
};

struct Rsqrt {
  template <class T>
  static T of(const T& x) {
    using strike::rsqrt;
    return rsqrt(x);
  }
};

constexpr std::size_t numbers = 1024;

template <class T, class Function>
void price(benchmark::State& state) {
  constexpr std::size_t lanes = strike::lanes<T>;
  std::vector<T> x(numbers / lanes);
  for (std::size_t i = 0; i < numbers; ++i)
    strike::set_lane(x[i / lanes], i % lanes, strike::RealOf<T>(0.01 + 3.0 * double(i) / numbers));
  for (auto _ : state) {
    benchmark::ClobberMemory();
    T sum(0);  // a store would wait for the next load where their addresses agree modulo 4 KiB
    for (const T& x_i : x) sum += Function::of(x_i);
    benchmark::DoNotOptimize(sum);
  }
  state.counters["per_number"] =
      benchmark::Counter(numbers, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class Function>
void prices(const std::string& name) {
  benchmark::RegisterBenchmark((name + "/double (std)").c_str(), price<double, Function>);
  benchmark::RegisterBenchmark((name + "/Pack<double, 4>").c_str(), price<Pack<double, 4>, Function>);
  benchmark::RegisterBenchmark((name + "/Pack<double, 8>").c_str(), price<Pack<double, 8>, Function>);
  benchmark::RegisterBenchmark((name + "/Pack<double, 16>").c_str(), price<Pack<double, 16>, Function>);
  benchmark::RegisterBenchmark((name + "/Pack<float, 8>").c_str(), price<Pack<float, 8>, Function>);
  benchmark::RegisterBenchmark((name + "/Pack<float, 16>").c_str(), price<Pack<float, 16>, Function>);
}

const bool registered = [] {
  prices<Exp>("exp");
  prices<Log>("log");
  prices<Pow>("pow");
  prices<Cbrt>("cbrt");
  prices<Sqrt>("sqrt");
  prices<Rsqrt>("rsqrt");
  return true;
}();

}  // namespace
