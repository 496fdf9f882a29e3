#include "planner/algorithms/region_pso.h"

#include <algorithm>
#include <array>

#include "planner/indexed.h"

namespace headland {
namespace {

struct Particle {
  RegionIndividual now;
  RegionIndividual best;
  std::vector<double> velocity;
};

struct SwarmFactors {
  double inertia = 0.0;
  double most_velocity = 0.0;
  double learning = 0.0;
};

void move_particle(RegionTask& task, const SwarmFactors& factors, const RegionGenes& leader,
                   Particle& particle) {
  RegionGenes genes = particle.now.genes;
  for (int i = 0; i < static_cast<int>(genes.size()); ++i) {
    const double to_own = draw_unit(task.random) * (at(particle.best.genes, i) - at(genes, i));
    const double to_leader = draw_unit(task.random) * (at(leader, i) - at(genes, i));
    double& velocity = at(particle.velocity, i);
    velocity = std::clamp(factors.inertia * velocity + factors.learning * (to_own + to_leader),
                          -factors.most_velocity, factors.most_velocity);
    at(genes, i) = std::clamp(at(genes, i) + velocity, 1.0, most_of_gene(task, i));
  }
  particle.now = individual_of(task, std::move(genes));
  if (particle.now.cost < particle.best.cost) particle.best = particle.now;
}

}  // namespace

std::span<const ParameterSpec> region_pso_parameters() {
  static const std::array kSpecs{
      region_population_spec(),
      ParameterSpec{"inertia", 0.8, 0.0, 1.0, {}, "share of a velocity that stays (w)"},
      ParameterSpec{"most_velocity", 0.8, 0.001, 1000.0, {}, "of a gene in an iteration (w_t)"},
      ParameterSpec{"learning", 2.0, 0.0, 10.0, {}, "learning factor (c)"}};
  return kSpecs;
}

RegionPlan plan_region_pso(const RegionRequest& request) {
  RegionTask task(request);
  const SwarmFactors factors{number(request.parameters, "inertia"),
                             number(request.parameters, "most_velocity"),
                             number(request.parameters, "learning")};
  std::vector<Particle> swarm;
  RegionIndividual leader;
  for (RegionIndividual& one : random_individuals(task, region_population(request))) {
    if (swarm.empty() || one.cost < leader.cost) leader = one;
    std::vector<double> velocity(one.genes.size());
    for (double& v : velocity) v = (2.0 * draw_unit(task.random) - 1.0) * factors.most_velocity;
    swarm.push_back({one, one, std::move(velocity)});
  }
  while (next_iteration(task.search)) {
    for (Particle& particle : swarm) {
      if (!goes_on(task.search)) break;
      move_particle(task, factors, leader.genes, particle);
      if (particle.best.cost < leader.cost) leader = particle.best;
    }
  }
  return finished_plan(task, "region_pso");
}

}  // namespace headland
