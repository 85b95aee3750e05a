import type { Run, RunProperty, RunStatus, RunSteps, Trace } from '../api.ts';

/** A watched run as far as the page has received it. */
export class Running {
  trace: Trace;
  status: RunStatus;
  /** number of steps before the first of the trace */
  skipped = 0;
  private received = performance.now();
  private readonly verdicts = new Map<string, RunProperty['verdict']>();

  constructor(readonly run: Run) {
    this.trace = run.trace;
    this.status = run.status;
  }

  take(status: RunStatus): void {
    this.status = status;
    this.received = performance.now();
  }

  /** The number of the next step to request. */
  get next(): number {
    return this.skipped + this.trace.steps.length;
  }

  get isComplete(): boolean {
    return this.next >= this.status.steps;
  }

  /** Whether the steps continue those before; otherwise some are missing, and the trace begins again. */
  add({ from, initial, steps }: RunSteps): boolean {
    for (const { actor, remark } of steps)
      if (remark === 'holds' || remark === 'violated') this.verdicts.set(actor, remark === 'holds' ? 'true' : 'false');
    if (from === this.next) {
      this.trace = { ...this.trace, steps: [...this.trace.steps, ...steps] };
      return true;
    }
    this.skipped = from;
    this.trace = { ...this.trace, ...(initial && { initial }), steps };
    return false;
  }

  /** What the run has decided about one of the program's properties; undefined: nothing that the page has received. */
  verdictOf(name: string): RunProperty['verdict'] | undefined {
    return this.status.end?.properties.find((it) => it.name === name)?.verdict ?? this.verdicts.get(name);
  }

  /** In seconds of the run. */
  get now(): number {
    const { date, speed } = this.status;
    return Math.max(date + (speed * (performance.now() - this.received)) / 1000, this.trace.steps.at(-1)?.date.seconds ?? 0);
  }
}
