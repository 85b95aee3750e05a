import type { ActorKind, Trace } from '../api.ts';
import { actorsOf } from './actors.ts';
import { byName } from './natural.ts';

/** Colour of a bar: a value of a variable, or the outcome of a skill. */
export type Tone = 'running' | 'success' | 'failure' | 'interrupted' | 'value';

/** Between two steps, or from the start if `from` is -1; `to` is the last step if it is still open. */
export interface Bar {
  from: number;
  to: number;
  open: boolean;
  label: string;
  tone: Tone;
}
export interface Lane {
  name: string;
  kind: ActorKind;
  bars: Bar[];
  /** Steps of this actor, or that change this variable. */
  marks: number[];
}

const starts = /^starts$|^starts its action|^starts measuring$/;
const failing = /^fails|^detects an (under|over)shoot|^(under|over)shoot/;

/** The outcome of an actor, from the description of a step and its status after it. */
function endOf(words: string, status: string | undefined, hasStatus: boolean): Tone | null {
  if (status === 'success') return 'success';
  if (status === 'failure' || status === 'failed_inv') return 'failure';
  if (status === 'interrupted') return 'interrupted';
  if (/^succeeds|^ends$|^stops measuring$/.test(words)) return 'success';
  if (failing.test(words)) return 'failure';
  if (hasStatus) return null; // it is only about to end
  if (/^finds its invariant /.test(words)) return 'failure';
  return /^is interrupted|^is stopped/.test(words) ? 'interrupted' : null;
}

/** A bar for each run of a skill; a step before its start is a mark. */
function skillLane(trace: Trace, name: string, kind: ActorKind): Lane {
  const lane: Lane = { name, kind, bars: [], marks: [] };
  const variable = `${name}.status`;
  const hasStatus = variable in trace.initial;
  let running: Bar | null = null;
  trace.steps.forEach((step, index) => {
    const status = step.changes.find((change) => change.variable === variable)?.after;
    const mine = step.actor === name;
    if (mine) lane.marks.push(index);
    const isStep = step.remark === undefined;
    const ended = isStep && (mine || status) ? endOf(mine ? step.description : '', status, hasStatus) : null;
    if (running && ended) {
      Object.assign(running, { to: index, open: false, tone: ended });
      running = null;
    } else if (mine && !running && starts.test(step.description)) {
      running = { from: index, to: trace.steps.length - 1, open: true, label: name, tone: 'running' };
      lane.bars.push(running);
    }
  });
  return lane;
}

/** A bar for each value of a variable. */
function variableLane(trace: Trace, name: string): Lane {
  const lane: Lane = { name, kind: 'variable', bars: [], marks: [] };
  const value = (label: string, from: number): Bar => ({
    from, to: trace.steps.length - 1, open: true, label, tone: 'value',
  });
  lane.bars.push(value(trace.initial[name] ?? '', -1));
  trace.steps.forEach((step, index) => {
    const change = step.changes.find((it) => it.variable === name);
    if (!change) return;
    Object.assign(lane.bars.at(-1)!, { to: index, open: false });
    lane.bars.push(value(change.after, index));
    lane.marks.push(index);
  });
  return lane;
}

/** The status and the result of a skill are shown in its own lane. */
const isOfSkill = (variable: string): boolean => /\.(status|res)$/.test(variable);

const order: { [K in Lane['kind']]: number } = {
  skill: 0, branch: 0, watchdog: 1, event: 2, environment: 2, property: 2, variable: 3, process: 3,
};

/** The lanes of a trace: skills with their branches, watchdogs, events, and the variables that change. */
export function lanesOf(trace: Trace): Lane[] {
  const lanes: Lane[] = [];
  for (const actor of actorsOf(trace)) {
    if (actor.kind === 'skill' || actor.kind === 'branch' || actor.kind === 'watchdog') {
      lanes.push(skillLane(trace, actor.name, actor.kind));
    } else if (actor.kind !== 'variable' && actor.kind !== 'process') {
      const marks: number[] = [];
      trace.steps.forEach((step, index) => step.actor === actor.name && marks.push(index));
      lanes.push({ name: actor.name, kind: actor.kind, bars: [], marks });
    }
  }
  const changed = new Set(trace.steps.flatMap((step) => step.changes.map((change) => change.variable)));
  for (const name of Object.keys(trace.initial).sort(byName))
    if (changed.has(name) && !isOfSkill(name)) lanes.push(variableLane(trace, name));
  return lanes
    .map((lane, index) => ({ lane, index }))
    .sort((a, b) => order[a.lane.kind] - order[b.lane.kind] || a.index - b.index)
    .map(({ lane }) => lane);
}

/** The position of each step on the axis: its date, or its number from 1; 0 is the start in both. */
export function axisOf(trace: Trace, by: 'date' | 'step'): Float64Array {
  return Float64Array.from(trace.steps, (step, index) => (by === 'date' ? step.date.seconds : index + 1));
}

/** The end of the axis, with space after it to show what the last step did. */
export function endOfAxis(axis: Float64Array, by: 'date' | 'step', begin = 0): number {
  const last = axis.at(-1) ?? 0;
  return Math.max(by === 'date' ? begin + (last - begin) * 1.05 : last + 1, begin + 1e-9);
}

export interface Drawn {
  x: number;
  width: number;
  bar: Bar | null; // null: several bars that are too narrow to show separately
  count: number;
}

/**
 * The visible bars of a lane in pixels, for a section of the axis with this width; open ones end at `openEnd`. Narrow bars are joined, so that there
 * are never more bars than pixels.
 */
export function drawBars(lane: Lane, axis: Float64Array, from: number, to: number, width: number, openEnd = Infinity): Drawn[] {
  const scale = width / (to - from || 1);
  const out: Drawn[] = [];
  for (const bar of lane.bars) {
    const begin = bar.from < 0 ? 0 : axis[bar.from]!;
    const stop = bar.open ? Math.max(Math.min(to, openEnd), begin) : axis[bar.to]!;
    if (stop < from || begin > to) continue;
    const x = Math.max((begin - from) * scale, -4);
    const right = Math.min((stop - from) * scale, width + 4);
    const last = out.at(-1);
    if (last && right - x < 3 && x - (last.x + last.width) < 1 && (!last.bar || last.width < 3)) {
      last.width = Math.max(last.width, right - last.x);
      last.bar = null;
      ++last.count;
    } else out.push({ x, width: Math.max(right - x, 0), bar, count: 1 });
  }
  return out;
}

/** The visible marks, at most one per pixel: position and first step. */
export function drawMarks(lane: Lane, axis: Float64Array, from: number, to: number, width: number): { x: number; step: number; count: number }[] {
  const scale = width / (to - from || 1);
  const out: { x: number; step: number; count: number }[] = [];
  for (const step of lane.marks) {
    const x = ((axis[step] ?? 0) - from) * scale;
    if (x < -4 || x > width + 4) continue;
    const last = out.at(-1);
    if (last && x - last.x < 2) ++last.count;
    else out.push({ x, step, count: 1 });
  }
  return out;
}

/** The step of a lane's actor, or of any, nearest to a position on the axis. */
export function nearest(steps: readonly number[], axis: Float64Array, at: number): number | null {
  let best: number | null = null;
  for (const step of steps)
    if (best === null || Math.abs(axis[step]! - at) < Math.abs(axis[best]! - at)) best = step;
  return best;
}
