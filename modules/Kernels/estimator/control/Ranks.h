// SPDX-License-Identifier: BSD-3-Clause
// The processes that share one solve. Scene and receivers are replicated; each rank owns whole replicates, so that
// every sum is formed by one rank in one order and the numbers do not depend on how many ranks there are.
#ifndef kalos_estimator_control_Ranks_h
#define kalos_estimator_control_Ranks_h

#include <exception>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace kalos
{
/// One process. A higher layer adds MPI; the kernels know only gather().
class Ranks
{
public:
  virtual ~Ranks() = default;
  virtual int rank() const { return 0; }
  virtual int size() const { return 1; }

  /// The parts of all ranks, joined in the ranks' order, on every rank. Parts may differ in length. Every rank must
  /// call.
  virtual std::vector<double> gather(const std::vector<double>& own) const { return own; }

  /// First replicate of a rank; it owns those up to firstReplicate(rank + 1, ...). Beyond `replicates`, ranks are idle.
  int firstReplicate(int ofRank, int replicates) const
  {
    return static_cast<int>(static_cast<long long>(replicates) * ofRank / this->size());
  }

  /// Fetches from every rank the values of the replicates that it owns: forValues(first, last, visit) calls
  /// visit(double&) for those of replicates [first, last), in a fixed order.
  template <class ForValues>
  void exchange(int replicates, const ForValues& forValues) const
  {
    if (this->size() == 1)
      return;
    auto first = [&](int rank) { return this->firstReplicate(rank, replicates); };
    std::vector<double> own;
    forValues(first(this->rank()), first(this->rank() + 1), [&](double& value) { own.push_back(value); });
    const std::vector<double> all = this->gather(own);
    auto next = all.begin();
    for (int rank = 0; rank < this->size(); ++rank)
      forValues(first(rank), first(rank + 1), [&](double& value) { value = *next++; });
  }

  /// The value of the first rank, so that all ranks decide alike.
  double agree(double value) const { return this->gather({value}).front(); }

  double sum(double value) const
  {
    const std::vector<double> all = this->gather({value});
    return std::accumulate(all.begin(), all.end(), 0.0);
  }

  /// Runs a step on all ranks and returns whether all completed it. An exception on one rank ends the step on all, so
  /// that no rank waits forever.
  template <class Step>
  bool together(const Step& step) const
  {
    enum
    {
      Done,
      Aborted,
      Failed
    };
    std::exception_ptr failure;
    double state = Failed;
    try
    {
      state = step() ? Done : Aborted;
    }
    catch (...)
    {
      failure = std::current_exception();
    }
    const std::vector<double> states = this->gather({state});
    if (failure)
      std::rethrow_exception(failure);
    bool done = true;
    for (std::size_t r = 0; r < states.size(); ++r)
    {
      if (states[r] == Failed)
        throw std::runtime_error("rank " + std::to_string(r) + " of " + std::to_string(states.size()) +
                                 ": failed; its own message says why");
      done = done && states[r] == Done;
    }
    return done;
  }
};
}  // namespace kalos

#endif
