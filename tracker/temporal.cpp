// SPDX-License-Identifier: MIT
// The weights of the paper, as logarithms: what is far away would vanish as a product.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "candidate.h"
#include "graspdb/core/error.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {
namespace {

constexpr std::array<const char*, kTemporalModels.size()> kNames = {"none", "gaussian", "kde",
                                                                    "successors"};

double log_gaussian(double squared_distance, double sigma) {
  return -squared_distance / (2 * sigma * sigma);
}

}  // namespace

std::string temporal_name(TemporalModel model) {
  return kNames.at(static_cast<std::size_t>(model));
}

TemporalModel temporal_from_name(const std::string& name) {
  for (const TemporalModel model : kTemporalModels) {
    if (name == temporal_name(model)) return model;
  }
  throw Error({.key = "temporal", .expected = "none, gaussian, kde or successors", .found = name});
}

// log p(x_t | what was known at t - 1), up to a constant.
double Tracker::log_prior(const PoseVector& pose) const {
  if (previous_.empty() || options_.temporal == TemporalModel::kNone) return 0;
  if (options_.temporal == TemporalModel::kGaussian) {
    return log_gaussian((pose - previous_.front().pose).squaredNorm(), options_.sigma_pose);
  }
  std::vector<double> terms;
  terms.reserve(previous_.size());
  for (const Candidate& before : previous_) {
    terms.push_back(before.log_weight +
                    log_gaussian((pose - before.pose).squaredNorm(), options_.bandwidth));
  }
  const double largest = *std::max_element(terms.begin(), terms.end());
  double sum = 0;
  for (double term : terms) sum += std::exp(term - largest);
  return largest + std::log(sum);
}

// Their order is sorted first: they are too large to be moved again and again.
void Tracker::put_heaviest_first(std::vector<Candidate>& candidates) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return candidates[a].log_weight > candidates[b].log_weight;
  });
  std::vector<Candidate> sorted;
  sorted.reserve(candidates.size());
  for (const std::size_t i : order) sorted.push_back(candidates[i]);
  candidates = std::move(sorted);
}

// Multiplies in the prior, normalises, and puts the heaviest first.
void Tracker::weigh(std::vector<Candidate>& candidates) const {
  GRASPDB_CHECK(!candidates.empty());
  for (Candidate& candidate : candidates) candidate.log_weight += log_prior(candidate.pose);
  put_heaviest_first(candidates);
  const double largest = candidates.front().log_weight;
  double sum = 0;
  for (const Candidate& candidate : candidates) sum += std::exp(candidate.log_weight - largest);
  for (Candidate& candidate : candidates) {
    candidate.log_weight -= largest + std::log(sum);
    candidate.weight = std::exp(candidate.log_weight);
  }
}

}  // namespace graspdb
