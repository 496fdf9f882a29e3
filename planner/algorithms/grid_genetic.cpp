#include "planner/algorithms/grid_genetic.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "planner/genetic_operators.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// Shares of m in mutation: at most a tenth of the cells, which keeps most of a parent.
constexpr int kCellsPerMutation = 10;

struct Chromosome {
  std::vector<int> order;  // X
  Three counted{};         // on Y
  Three weights{};
  double cost = 0.0;     // by the request's weights
  double fitness = 0.0;  // by its own
};

struct Evolution {
  const GridPlanRequest& request;
  const GridProblem& problem;
  const DistanceTable* table = nullptr;  // null: chromosomes are driven as they are
  bool adaptive = false;
  bool single_point = false;
  double jump_cost = 0.0;
  double crossover = 0.0;
  double mutation = 0.0;
  int elites = 1;
  SeededRandom& random;
  PlanSearch& search;
};

std::vector<int> path_of(const Evolution& evolution, const std::vector<int>& order) {
  if (evolution.table == nullptr) return order;
  return adjusted(evolution.problem.graph, *evolution.table, order, evolution.problem.end >= 0);
}

void measure(Evolution& evolution, Chromosome& one) {
  const GridGraph& graph = evolution.problem.graph;
  const std::vector<int> path = path_of(evolution, one.order);
  const GridCounts counts = count_path(graph, path);
  one.counted = {static_cast<double>(counts.repeats), static_cast<double>(counts.turns),
                 static_cast<double>(counts.u_turns)};
  one.cost = cost_of(evolution.request.cost, counts, graph.cell_m);
  for (std::size_t i = 1; evolution.table == nullptr && i < path.size(); ++i) {
    if (direction_between(graph, path[i - 1], path[i]) < 0) one.cost += evolution.jump_cost;
  }
  ++evolution.search.evaluations;
}

void set_fitness(const Evolution& evolution, Chromosome& one) {
  const double own_cost =
      std::inner_product(one.weights.begin(), one.weights.end(), one.counted.begin(), 0.0);
  one.fitness = fitness_of(evolution.adaptive ? own_cost : one.cost);
}

Three mean_counted(const std::vector<Chromosome>& population) {
  Three mean{};
  for (const Chromosome& one : population) {
    for (std::size_t i = 0; i < mean.size(); ++i) {
      mean[i] += one.counted[i] / static_cast<double>(population.size());
    }
  }
  return mean;
}

// Eq (16), over the sums of fitness up to each individual.
const Chromosome& drawn_by_roulette(const std::vector<Chromosome>& population,
                                    const std::vector<double>& sums, SeededRandom& random) {
  return at(population, draw_by_sums(random, sums));
}

// 2.2.5.
void mutate(const Evolution& evolution, std::vector<int>& order) {
  const FreePlaces places = free_places(evolution.problem);
  const int count = places.end - places.first;
  if (count < 2) return;
  const int most = std::max(1, static_cast<int>(order.size()) / kCellsPerMutation);
  const int pairs = evolution.single_point ? 1 : 1 + draw_below(evolution.random, most);
  for (int i = 0; i < pairs; ++i) {
    const int a = places.first + draw_below(evolution.random, count);
    const int b = places.first + draw_below(evolution.random, count);
    std::swap(at(order, a), at(order, b));
  }
}

Chromosome child_of(Evolution& evolution, const std::vector<Chromosome>& population,
                    const std::vector<double>& sums) {
  SeededRandom& random = evolution.random;
  Chromosome child = drawn_by_roulette(population, sums, random);
  const std::vector<int> before = child.order;
  if (draw_unit(random) < evolution.crossover) {
    const Chromosome& other = drawn_by_roulette(population, sums, random);
    const int kept = 1 + draw_below(random, static_cast<int>(child.order.size()));
    child.order = crossed(child.order, other.order, kept);
  }
  if (draw_unit(random) < evolution.mutation) mutate(evolution, child.order);
  if (child.order != before) measure(evolution, child);
  return child;
}

std::vector<Chromosome> next_generation(Evolution& evolution,
                                        const std::vector<Chromosome>& population) {
  std::vector<double> sums;
  sums.reserve(population.size());
  for (const Chromosome& one : population) {
    sums.push_back((sums.empty() ? 0.0 : sums.back()) + one.fitness);
  }
  const Three mean = mean_counted(population);
  std::vector<Chromosome> next(population.begin(), population.begin() + evolution.elites);
  while (next.size() < population.size()) {
    stop_if(evolution.search.cancelled);
    next.push_back(child_of(evolution, population, sums));
    if (evolution.adaptive) adapt_weights(mean, next.back().counted, next.back().weights);
    set_fitness(evolution, next.back());
  }
  std::ranges::stable_sort(next, std::ranges::greater{}, &Chromosome::fitness);
  return next;
}

// The best of all generations by the request's weights.
std::vector<int> evolved(Evolution& evolution, int size) {
  std::vector<Chromosome> population;
  for (int i = 0; i < size; ++i) {
    stop_if(evolution.search.cancelled);
    Chromosome one;
    one.order = random_order(evolution.problem, evolution.random);
    const GridWeights weights = weights_of(evolution.request.cost, evolution.problem.graph.cell_m);
    one.weights = {weights.repeat, weights.turn, weights.u_turn};
    measure(evolution, one);
    set_fitness(evolution, one);
    population.push_back(std::move(one));
  }
  std::ranges::stable_sort(population, std::ranges::greater{}, &Chromosome::fitness);
  std::vector<int> best;
  const auto note_best = [&] {
    const auto cheapest = std::ranges::min_element(population, {}, &Chromosome::cost);
    if (note_cost(evolution.search, cheapest->cost)) best = cheapest->order;
  };
  note_best();
  while (next_iteration(evolution.search)) {
    population = next_generation(evolution, population);
    note_best();
  }
  return best;
}

GridPlan planned(const GridPlanRequest& request, const std::string& name, bool in_pairs) {
  const GridProblem problem = grid_problem(request);
  const Parameters& parameters = request.parameters;
  const int size = static_cast<int>(number(parameters, "population"));
  const int elites = static_cast<int>(number(parameters, "elites"));
  check_grid_genetic(parameters, kGridPlanSource, "");
  DistanceTable table;
  if (in_pairs) table = distance_table(problem.graph, kGridPlanSource, request.cancelled);
  SeededRandom random(request.seed);
  PlanSearch search = begun_search(request);
  Evolution evolution{request,
                      problem,
                      in_pairs ? &table : nullptr,
                      false,
                      false,
                      0.0,
                      number(parameters, "crossover"),
                      number(parameters, "mutation"),
                      elites,
                      random,
                      search};
  if (in_pairs) {
    evolution.adaptive = word(parameters, "weights") == "adaptive";
    evolution.single_point = word(parameters, "mutation_points") == "single";
  } else {
    evolution.single_point = true;
    evolution.jump_cost = number(parameters, "jump_cost");
  }
  const std::vector<int> best = evolved(evolution, size);
  return finished_plan(request, problem, name, path_of(evolution, best), search);
}

const ParameterSpec kPopulation{"population", 200.0, 2.0, 2000.0, {}, "chromosomes (Q)", true};
const ParameterSpec kElites{"elites", 1.0, 0.0, 2000.0, {}, "best ones kept as they are (k)", true};
const ParameterSpec kCrossover{"crossover", 0.5, 0.0, 1.0, {}, "probability of crossover"};
const ParameterSpec kMutation{"mutation", 0.01, 0.0, 1.0, {}, "probability of mutation"};

}  // namespace

std::span<const ParameterSpec> grid_iga_parameters() {
  static const std::array kSpecs{
      kPopulation,
      kElites,
      kCrossover,
      kMutation,
      ParameterSpec{"mutation_points",
                    std::string("multi"),
                    0.0,
                    0.0,
                    {"multi", "single"},
                    "pairs that a mutation exchanges"},
      ParameterSpec{"weights",
                    std::string("fixed"),
                    0.0,
                    0.0,
                    {"fixed", "adaptive"},
                    "whether chromosomes adapt their weights"},
  };
  return kSpecs;
}

std::span<const ParameterSpec> grid_ga_parameters() {
  static const std::array kSpecs{
      kPopulation, kElites, kCrossover, kMutation,
      ParameterSpec{"jump_cost", 1.0, 0.0, 1000.0, {}, "cost of a move that is no step"}};
  return kSpecs;
}

void check_grid_genetic(const Parameters& parameters, const std::string& source,
                        const std::string& where) {
  const double size = number(parameters, "population");
  const double elites = number(parameters, "elites");
  if (elites <= size) return;
  throw InputError(source, key_path(where, "elites"), fmt::format("{}", elites),
                   fmt::format("at most {}, the population", size));
}

GridPlan plan_grid_iga(const GridPlanRequest& request) {
  return planned(request, "grid_iga", true);
}

GridPlan plan_grid_ga(const GridPlanRequest& request) { return planned(request, "grid_ga", false); }

}  // namespace headland
