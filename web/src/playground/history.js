// The states of the playground in their order, for undo and redo. A state is never changed, only replaced.

const kMost = 200;  // states that are kept

export class History {
  constructor(state) {
    this.states = [state];
    this.at = 0;
  }

  get state() {
    return this.states[this.at];
  }

  // A state that follows the current one: those that were undone are gone.
  push(state) {
    this.states = [...this.states.slice(0, this.at + 1), state].slice(-kMost);
    this.at = this.states.length - 1;
  }

  // Goes `by` states on, or back where it is negative. Returns whether there is such a state.
  move(by) {
    const found = this.at + by in this.states;
    if (found) this.at += by;
    return found;
  }
}
