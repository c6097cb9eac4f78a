// SPDX-License-Identifier: BSD-3-Clause
// The states of a value that a user changes, for undo and redo.
#ifndef studio_UndoHistory_h
#define studio_UndoHistory_h

#include <deque>

namespace studio
{
template <class Value>
class UndoHistory
{
public:
  explicit UndoHistory(Value first = {}) : States{std::move(first)} {}

  const Value& current() const { return this->States[this->Now]; }
  bool canUndo() const { return this->Now > 0; }
  bool canRedo() const { return this->Now + 1 < this->States.size(); }

  /// Adds a state and removes those that could be redone. Does nothing for the current value. Keeps 200 states.
  void set(Value value)
  {
    if (value == this->current())
      return;
    this->States.resize(this->Now + 1);
    this->States.push_back(std::move(value));
    if (this->States.size() > 200)
      this->States.pop_front();
    this->Now = this->States.size() - 1;
  }

  const Value& undo() { return this->States[this->Now -= this->canUndo() ? 1 : 0]; }
  const Value& redo() { return this->States[this->Now += this->canRedo() ? 1 : 0]; }

private:
  std::deque<Value> States;
  std::size_t Now = 0;
};
}  // namespace studio

#endif
