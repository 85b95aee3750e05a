// Runs that are watched (docs/runtime.md): a part of the contract of api.ts.
import type { Location, Step, Trace } from './api.ts';

/** A process of a run, and where in the program it may be. */
export interface RunProcess {
  actor: string;
  /** It performs the action of a basic skill; otherwise it executes a body. */
  performs: boolean;
  /** index of its place at the start */
  start: number;
  /** null: it does not run */
  places: (Location | null)[];
}
/** One of the program's own properties, and what the run has decided about it. */
export interface RunProperty {
  name: string;
  /** the property as written */
  description: string;
  location: Location | null;
  verdict: 'not yet' | 'true' | 'false';
  /** seconds since the start; null: not decided */
  date: string | null;
  /** why a run never decides it */
  whyNot: string | null;
}
/** What a run does now: the places where something runs, and the last message of each `printf`. */
export interface Live {
  active: readonly Location[];
  messages: readonly { location: Location; text: string; count: number }[];
}
/** An event, or a skill that can be interrupted. */
export interface RunSignal {
  name: string;
  interrupts: boolean;
  /** why it cannot be sent */
  whyNot: string | null;
}
export interface RunStatus {
  state: 'running' | 'paused' | 'ended';
  /** of steps and remarks so far */
  steps: number;
  /** time of the run in seconds, and how many seconds pass in one; 0: it stands still, or jumps from step to step */
  date: number;
  speed: number;
  /** events and interrupts that were sent and not yet taken */
  waiting: number;
  /** steps and remarks that are not shown, since they came too fast */
  lost: number;
  end: { why: string; mission: string; bad: number; failure?: string; properties: RunProperty[] } | null;
}
export interface Run {
  /** without steps */
  trace: Trace;
  processes: RunProcess[];
  /** such as `real time` */
  clock: string;
  /** why it cannot be influenced at all, and why it cannot be paused */
  whyNoControl: string | null;
  whyNoPause: string | null;
  /** as they are at the start */
  properties: RunProperty[];
  signals: RunSignal[];
  status: RunStatus;
}
/** Steps from a requested one on, or from the first that is still known, with the values before it. */
export interface RunSteps {
  from: number;
  initial?: { [variable: string]: string };
  steps: Step[];
  /** of the run so far */
  total: number;
}
export interface RunControl {
  /** `end`: the run; `close`: its page, after the end */
  do: 'pause' | 'continue' | 'step' | 'send' | 'end' | 'close';
  /** of `send`: its name */
  signal?: string;
}
