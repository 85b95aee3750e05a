const kMost = 5;
const kWithin = 3 * 60 * 1000;

/** Whether a crashed server is restarted: at most five times in three minutes. */
export class Restarts {
  private crashes: number[] = [];

  constructor(private readonly now: () => number = Date.now) {}

  /** The user asked for it: earlier crashes do not count. */
  forget(): void {
    this.crashes = [];
  }

  /** Call it once for each crash. */
  again(): boolean {
    const now = this.now();
    this.crashes = [...this.crashes.filter((when) => now - when < kWithin), now];
    return this.crashes.length <= kMost;
  }
}
