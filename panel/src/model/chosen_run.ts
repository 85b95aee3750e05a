import type { ChosenRun, ChosenStep } from '../api.ts';

type Json = { [key: string]: unknown };

export const chosenStep = ({ actor, description, transitions, late }: ChosenStep): ChosenStep =>
  ({ actor, description, transitions, ...(late && { late }) });

/** A file to replay: its steps must be possible, and its end as expected. Null: no such file. */
export function runOf(text: string): ChosenRun | null {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return null;
  }
  const { main, steps, expect } = (value ?? {}) as Json;
  if (!Array.isArray(steps) || typeof expect !== 'object' || expect === null) return null;
  return {
    steps: steps.map((step) => chosenStep(step as ChosenStep)), expect: expect as { [variable: string]: string },
    ...(typeof main === 'string' && main !== '' && { main }),
  };
}
