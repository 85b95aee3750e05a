import type { Trace } from '../api.ts';
import { isRelevant, marksRelevance } from './filter.ts';
import { windowOf } from './time.ts';

/** The form that `open` reads. A part of a recording becomes a trace of its own, since the recording may be elsewhere. */
export function traceJson({ part: _, stale: __, ...trace }: Trace): string {
  return JSON.stringify({ version: 1, ...trace }, null, 2) + '\n';
}

/** Text for mails and terminals: a line per step, with its changes below; a star marks relevant steps. */
export function traceText(trace: Trace): string {
  const width = Math.max(0, ...trace.steps.map((step) => windowOf(step).length));
  const lines = [`${trace.description}: ${trace.verdict}`, ...(trace.summary ? [trace.summary] : []), ''];
  const marks = marksRelevance(trace);
  for (const [name, value] of Object.entries(trace.initial)) lines.push(`    ${name} ${value}`);
  lines.push('');
  trace.steps.forEach((step, index) => {
    if (trace.loop === index) lines.push('    -- from here on for ever --');
    const place = step.location ? `  (${step.location.uri}:${step.location.range.start.line + 1})` : '';
    lines.push(`${marks && isRelevant(step) ? '*' : ' '}${String(index + 1).padStart(4)}  ${windowOf(step).padStart(width)} s  ${step.actor}: ${step.description}${place}`);
    if (step.why) lines.push(`${' '.repeat(width + 11)}why: ${step.why}`);
    for (const change of step.changes)
      lines.push(`${' '.repeat(width + 11)}${change.variable}: ${change.before} -> ${change.after}`);
  });
  return lines.join('\n') + '\n';
}

/** A name that all file systems accept. */
export const fileName = (name: string, extension: string): string =>
  `${name.replace(/[^A-Za-z0-9_.-]+/g, '_') || 'trace'}.${extension}`;
