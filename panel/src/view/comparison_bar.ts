import type { Trace } from '../api.ts';
import { isDifferent, type Pair } from '../model/compare.ts';
import { h, plural, prose } from './dom.ts';
import { button, icon } from './icons.ts';

/** Says how a trace differs from another one, and moves between the differences. */
export function comparisonBar(other: Trace, pairs: readonly Pair[], move: (by: 1 | -1) => void, close: () => void): (Node | string)[] {
  const count = pairs.filter(isDifferent).length;
  return [icon('compare'), h('span', {}, 'Compared with ', prose(other.description), ': ', count === 0 ? 'the same steps' : plural(count, 'step differs', 'steps differ')),
    button({ icon: 'previous', title: 'Previous difference', onclick: () => move(-1) }),
    button({ icon: 'next', title: 'Next difference', onclick: () => move(1) }),
    h('span', { class: 'push' }), button({ icon: 'close', title: 'End the comparison', onclick: close })];
}
