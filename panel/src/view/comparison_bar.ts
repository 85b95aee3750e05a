import type { Trace, Verdict } from '../api.ts';
import { compare, isDifferent, type Pair } from '../model/compare.ts';
import { h, plural, prose } from './dom.ts';
import { button, icon } from './icons.ts';
import type { Section } from './menu.ts';

export interface ComparisonEvents {
  /** Another trace is compared with, or none any more. */
  changed(): void;
  /** To the next or previous difference. */
  move(by: 1 | -1): void;
  fetch(name: string): Promise<Trace>;
}

/** Compares a trace with another one of the program: a bar says how they differ, and moves between the differences. */
export class ComparisonBar {
  readonly element = h('div', { class: 'comparing', hidden: true });
  compared: { other: Trace; pairs: Pair[] } | null = null;
  /** the program's verdicts that have a trace */
  private others: Verdict[] = [];

  constructor(private readonly events: ComparisonEvents) {}

  setOthers(verdicts: readonly Verdict[]): void {
    this.others = verdicts.filter((verdict) => verdict.steps !== null);
  }

  /** What `trace` can be compared with. */
  sections(trace: Trace): Section[] {
    const others = this.others.filter((verdict) => verdict.name !== trace.name);
    const items = others.map(({ name, description, steps }) => ({ label: description.replaceAll('`', ''), hint: plural(steps ?? 0, 'step'), choose: () => void this.begin(trace, name) }));
    return [{ title: items.length > 0 ? 'Compare with the trace of' : 'No other property has a trace', items }];
  }

  private async begin(trace: Trace, name: string): Promise<void> {
    const other = await this.events.fetch(name);
    this.compared = { other, pairs: compare(trace, other) };
    this.draw(this.compared);
    this.events.changed();
  }

  /** The trace was replaced by another one of its property. */
  renew(trace: Trace): void {
    if (!this.compared) return;
    this.compared = { other: this.compared.other, pairs: compare(trace, this.compared.other) };
    this.draw(this.compared);
  }

  end(): void {
    this.compared = null;
    this.element.hidden = true;
  }

  /** The next step, in this direction, that only this trace has, or where the other has additional steps. */
  difference(from: number, direction: 1 | -1): number | undefined {
    const marked = new Set<number>();
    let last = 0;
    for (const pair of this.compared?.pairs ?? []) {
      if (isDifferent(pair)) marked.add(pair.left ?? last);
      last = pair.left ?? last;
    }
    const sorted = [...marked].sort((a, b) => a - b);
    return direction > 0 ? sorted.find((index) => index > from) : sorted.findLast((index) => index < from);
  }

  private draw({ other, pairs }: { other: Trace; pairs: Pair[] }): void {
    const count = pairs.filter(isDifferent).length;
    const close = (): void => {
      this.end();
      this.events.changed();
    };
    this.element.hidden = false;
    this.element.replaceChildren(icon('compare'), h('span', {}, 'Compared with ', prose(other.description), ': ', count === 0 ? 'the same steps' : plural(count, 'step differs', 'steps differ')),
      button({ icon: 'previous', title: 'Previous difference', onclick: () => this.events.move(-1) }),
      button({ icon: 'next', title: 'Next difference', onclick: () => this.events.move(1) }),
      h('span', { class: 'push' }), button({ icon: 'close', title: 'End the comparison', onclick: close }));
  }
}
