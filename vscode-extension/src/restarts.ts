const kMost = 5;
const kWithin = 3 * 60 * 1000;

/** Whether a server that has crashed is started again: at most five times in three minutes. */
export class Restarts {
  private crashes: number[] = [];

  constructor(private readonly now: () => number = Date.now) {}

  /** A person has asked for it: the past does not count. */
  forget(): void {
    this.crashes = [];
  }

  /** To be asked once for each crash. */
  again(): boolean {
    const now = this.now();
    this.crashes = [...this.crashes.filter((when) => now - when < kWithin), now];
    return this.crashes.length <= kMost;
  }
}
