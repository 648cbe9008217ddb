// The worker that computes, as promises. While it computes, the page goes on.

export class Engine {
  constructor(worker) {
    this.worker = worker;
    this.asked = new Map();
    this.next = 0;
    this.waiting = null;  // the newest question of `ask_latest`
    this.busy = false;    // with one of them
    worker.onmessage = ({ data }) => this.answer(data);
    worker.onerror = (event) => {
      for (const { reject } of this.asked.values()) reject(new Error(event.message || 'the worker ended: too little memory?'));
      this.asked.clear();
    };
  }

  answer({ id, result, error, progress }) {
    const { resolve, reject, report } = this.asked.get(id) ?? {};
    if (progress) return report?.(progress);
    this.asked.delete(id);
    if (error === undefined) resolve?.(result);
    else reject?.(new Error(error));
  }

  // Runs a handler of the worker. `report` gets what it sends before its result.
  ask(kind, args, report, transfer = []) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.asked.set(id, { resolve, reject, report });
      this.worker.postMessage({ id, kind, args }, transfer);
    });
  }

  // For questions that come faster than answers, as while a pointer moves: of those that wait only the newest is asked.
  // The promise of another one gives null. `ready` is waited for before an answer is given and the next question asked.
  ask_latest(kind, args, ready = () => null) {
    this.waiting?.resolve(null);
    return new Promise((resolve, reject) => {
      this.waiting = { kind, args, ready, resolve, reject };
      this.ask_waiting();
    });
  }

  async ask_waiting() {
    if (this.busy || !this.waiting) return;
    const { kind, args, ready, resolve, reject } = this.waiting;
    this.waiting = null;
    this.busy = true;
    const answer = await this.ask(kind, args).catch((error) => reject(error));
    await ready();
    this.busy = false;
    this.ask_waiting();  // before the answer is shown: the worker computes meanwhile
    resolve(answer);
  }
}
