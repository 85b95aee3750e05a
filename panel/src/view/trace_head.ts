import type { Trace } from '../api.ts';
import { decimal } from '../model/time.ts';
import { h, plural, prose } from './dom.ts';

/** The head of a trace: the property with its verdict, and a sentence about what the trace shows. */
export class TraceHead {
  private readonly line = h('div', { class: 'trace-head' });
  private readonly summary = h('p', { class: 'trace-summary' });
  private readonly renewed = h('span', { class: 'renewed', role: 'status' });
  readonly elements = [this.line, this.summary];

  draw(trace: Trace): void {
    const end = trace.steps.at(-1)?.date;
    const time = trace.part ? '' : `, ${end ? decimal(end) : '0'} s`; // the description of a part has its times
    this.line.replaceChildren(h('span', { class: `badge ${trace.verdict}` }, trace.verdict || 'trace'),
      h('h2', { title: trace.name }, prose(trace.description)),
      h('span', { class: 'extent' }, h('span', { class: 'faint', title: end ? `It ends at ${end.exact} s` : '' }, plural(trace.steps.length, 'step'), time),
        h('span', { class: 'stale-mark', title: 'The text has changed since: places may have moved' }, 'for an older text')), this.renewed);
    this.say('');
    this.summary.replaceChildren(prose(trace.summary ?? ''));
    this.summary.hidden = !trace.summary;
  }

  /** A notice about a trace that replaced another one. */
  say(words: string): void {
    this.renewed.textContent = words;
    this.renewed.title = words;
  }
}
