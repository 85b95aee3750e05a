import type { Trace } from '../api.ts';
import { byName } from './natural.ts';

/** All values are stored at intervals of this many steps, so that others can be computed quickly. */
const stride = 64;

/** The values of all variables after any step of a trace. */
export class Values {
  /** sorted */
  readonly names: string[];
  private readonly kept: Map<string, string>[] = [];

  constructor(private readonly trace: Trace) {
    const now = new Map(Object.entries(trace.initial));
    trace.steps.forEach((step, index) => {
      if (index % stride === 0) this.kept.push(new Map(now));
      for (const change of step.changes) now.set(change.variable, change.after);
    });
    if (this.kept.length === 0) this.kept.push(new Map(now));
    this.names = [...now.keys()].sort(byName);
  }

  /** After the step with this index; -1: at the start. */
  at(index: number): Map<string, string> {
    const from = Math.floor(Math.max(index, 0) / stride);
    const values = new Map(this.kept[Math.min(from, this.kept.length - 1)]);
    for (let i = from * stride; i <= index; ++i)
      for (const change of this.trace.steps[i]?.changes ?? []) values.set(change.variable, change.after);
    return values;
  }
}
