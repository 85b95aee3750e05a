import type { Trace } from '../api.ts';
import { windowOf } from './time.ts';

/** What `open` reads again. */
export function traceJson(trace: Trace): string {
  return JSON.stringify({ version: 1, ...trace }, null, 2) + '\n';
}

/** For mails and terminals: a line a step, its changes below. */
export function traceText(trace: Trace): string {
  const width = Math.max(0, ...trace.steps.map((step) => windowOf(step).length));
  const lines = [`${trace.description}: ${trace.verdict}`, ''];
  for (const [name, value] of Object.entries(trace.initial)) lines.push(`    ${name} ${value}`);
  lines.push('');
  trace.steps.forEach((step, index) => {
    if (trace.loop === index) lines.push('    -- from here on for ever --');
    const place = step.location ? `  (${step.location.uri}:${step.location.range.start.line + 1})` : '';
    lines.push(`${String(index + 1).padStart(5)}  ${windowOf(step).padStart(width)} s  ${step.actor}: ${step.description}${place}`);
    for (const change of step.changes)
      lines.push(`${' '.repeat(width + 11)}${change.variable}: ${change.before} -> ${change.after}`);
  });
  return lines.join('\n') + '\n';
}

/** A name that all file systems take. */
export const fileName = (name: string, extension: string): string =>
  `${name.replace(/[^A-Za-z0-9_.-]+/g, '_') || 'trace'}.${extension}`;
