import type { Simulation, Trace } from '../api.ts';
import { Values } from './values.ts';

/** The value of a variable after the last step. */
export function lastValues(trace: Trace): { [variable: string]: string } {
  return Object.fromEntries(new Values(trace).at(trace.steps.length - 1));
}

/** The run as a test: a trace that every program can read, with the values expected at its end. */
export function testOf(simulation: Simulation, program: string): string {
  const { trace, main } = simulation;
  const moved = new Set(trace.steps.flatMap((step) => step.changes.map(({ variable }) => variable)));
  const expect = Object.fromEntries(Object.entries(lastValues(trace)).filter(([variable]) => moved.has(variable)));
  return JSON.stringify({ version: 1, ...trace, program, main, expect }, null, 2) + '\n';
}
