/**
 * The interface between the panel and its host: VS Code's webview, a browser that `proskill view` serves, or a report. It consists of messages
 * (`Message`) in plain JSON. Their data have the form of the language server (docs/lsp.md), so that a host passes answers on unchanged. A `Location`
 * is opaque to the panel, except for its line.
 */

import type { Live, Run, RunControl, RunStatus, RunSteps } from './api_run.ts';
export type * from './api_run.ts';

export const contractVersion = 1;

// ---- places ---------------------------------------------------------------------------------

/** Lines and characters from 0, in the host's units. */
export interface Position {
  line: number;
  character: number;
}
export interface Range {
  start: Position;
  end: Position;
}
export interface Location {
  uri: string;
  range: Range;
  /** of the text, if the end of its URI is not its name, as in a notebook */
  label?: string;
}

// ---- what there is to see -------------------------------------------------------------------

export interface Seconds {
  exact: string;
  seconds: number;
}
/** `strict`: arbitrarily near to the date, but not at it. */
export interface Moment extends Seconds {
  strict: boolean;
}
export interface Change {
  variable: string;
  before: string;
  after: string;
}
export interface Step {
  actor: string;
  description: string;
  location: Location | null;
  date: Seconds;
  delay: Seconds;
  earliest: Moment;
  /** null: unbounded */
  latest: Moment | null;
  changes: Change[];
  /** the reason of the step, as a sentence */
  why?: string;
  /** absent or true: relevant for what the trace shows */
  relevant?: boolean;
  /** the steps it depends on directly, from 0 */
  causes?: number[];
  transitions: string[];
  origins?: number[];
  /** in a recorded run: not a step of the model but a remark, such as `fault` or `undershoot` */
  remark?: string;
  /** in a run: what a `printf` has printed, with its values */
  message?: string;
  /** In a simulation: taken as late as possible. */
  late?: boolean;
  /** In a run that is watched: the processes that it has moved, and to which of their places. */
  moves?: [process: number, place: number][];
}
export type ActorKind = 'skill' | 'branch' | 'watchdog' | 'event' | 'environment' | 'variable' | 'process' | 'property';
export interface Actor {
  name: string;
  kind: ActorKind;
  skill: string | null;
}
export interface Trace {
  name: string;
  description: string;
  verdict: string;
  /** what the trace shows, as a sentence */
  summary?: string;
  initial: { [variable: string]: string };
  steps: Step[];
  /** If absent, the panel derives them from the descriptions of the steps. */
  actors?: Actor[];
  /** The steps from this one on are repeated for ever. */
  loop?: number | null;
  /** It is about older texts. */
  stale?: boolean;
  /** The digests of the texts that it is about, by file. */
  sources?: { [file: string]: string };
  /** of a longer recording: which part it is */
  part?: PartOfRun;
}
/** In seconds since the start of the run. */
export interface PartOfRun {
  begin: number;
  end: number;
  /** of the recorded run */
  length: number;
}

export type VerdictWord = 'holds' | 'violated' | 'reachable' | 'unreachable' | 'inconclusive';
export interface Verdict {
  name: string;
  kind: string;
  subject: string;
  description: string;
  verdict: VerdictWord;
  good: boolean;
  severity: 'error' | 'warning';
  location: Location | null;
  reason: string;
  /** what its trace shows, as a sentence */
  summary?: string;
  /** being verified, not decided yet */
  pending?: boolean;
  /** of its trace; null: it has none */
  steps: number | null;
}
export interface Exploration {
  classes: number;
  transitions: number;
  bytes: number;
  seconds: number;
  complete: boolean;
  stopped: string;
}
export type PictureKind = 'sv' | 'skill' | 'body' | 'calls';
export interface PictureName {
  kind: PictureKind;
  name: string;
  title: string;
}
/** The verdicts and the state of a program, as in the server's notification `proskill/verdicts`. */
export interface Program {
  program: string;
  label: string;
  main: string | null;
  state: 'waiting' | 'checking' | 'done' | 'errors' | 'failed' | 'off';
  /** The verdicts are for older texts. */
  stale: boolean;
  message: string;
  progress: { decided: number; total: number; classes: number; rate: number; bytes: number; seconds: number } | null;
  verdicts: Verdict[];
  exploration: Exploration | null;
  pictures: PictureName[];
  /** in a list of files, if the panel shows the source itself */
  files: { uri: string; label: string }[];
}

export interface PictureNode {
  id: string;
  role: string;
  label: string;
  details: string[];
  location: Location | null;
  cluster: string | null;
}
export interface PictureEdge {
  id: string;
  from: string;
  to: string;
  role: string;
  label: string;
  location: Location | null;
}
export interface PictureCluster {
  id: string;
  label: string;
  parent: string | null;
  location: Location | null;
}
/** A picture; an `id` is that of a group of the SVG. */
export interface Picture {
  kind: PictureKind;
  name: string;
  title: string;
  note: string;
  /** SVG or DOT, as requested */
  content: string;
  /** The program has errors, so parts of the picture may be missing. */
  errors: boolean;
  nodes: PictureNode[];
  edges: PictureEdge[];
  clusters: PictureCluster[];
  /** Parts that can be folded; absent or empty: none. */
  foldable?: Foldable[];
  /** A sentence if more was folded than requested, because the picture is large. */
  foldedBecause?: string;
}
/** A cluster that can be drawn as one node. */
export interface Foldable {
  /** does not change when parts are folded */
  key: string;
  label: string;
  /** the id of its cluster, or of the node in its place; null: inside another folded part */
  part: string | null;
  folded: boolean;
}
export interface PictureParams {
  kind: PictureKind;
  name: string;
  format: 'svg' | 'dot';
  dark: boolean;
  forbidden?: boolean;
  /** Keys of `foldable`; absent: the host decides, depending on the size of the picture. */
  fold?: string[];
}

/** A chosen step of a simulation, identified so that it can be found again after edits. */
export interface ChosenStep {
  actor: string;
  description: string;
  transitions: string[];
  late?: boolean;
}
/** A run as it is saved and requested; in a trace, the run without what it expects. */
export interface ChosenRun {
  main?: string;
  steps: ChosenStep[];
  /** values after the last step */
  expect?: { [variable: string]: string };
}
/** State of a simulation. */
export interface Simulation {
  main: string;
  /** the steps that were possible */
  trace: Trace;
  /** possible next steps, the likeliest first; empty: no step is possible */
  choices: Step[];
  /** the first step that is no longer possible */
  missing: { index: number; why: string } | null;
  /** expectations of the run that do not hold */
  unmet: { variable: string; expected: string; actual: string }[];
}

// ---- what the panel asks its host ------------------------------------------------------------

export interface Hello {
  contract: typeof contractVersion;
  /** `all`: with a list of verdicts and the source; otherwise one view, since the host has the rest */
  layout: 'all' | 'trace' | 'automaton' | 'simulation';
  can: {
    /** The panel shows the source itself, by `source`. */
    source: boolean;
    /** The host writes files, by `save`; otherwise the browser does. */
    save: boolean;
    /** `open` asks the user for a trace's file; otherwise the browser does. */
    open: boolean;
    /** `verify` starts a verification. */
    verify: boolean;
    /** `simulate` takes steps that the user chooses. */
    simulate: boolean;
    /** `caret` is sent when the caret moves. */
    follow: boolean;
  };
  program: Program | null;
  /** A run while it happens, and afterwards. */
  run?: Run | null;
  /** What to show first. */
  show?: Show;
  /** The last argument of `remember`. */
  remembered?: Remembered;
}

/** Parameters and result of each request. */
export interface Requests {
  /** Sent once, when the panel has started. */
  hello: [Record<string, never>, Hello];
  trace: [{ name: string }, Trace];
  /** Another part of a recording, from a time on; without one, its last. */
  part: [{ name: string; from?: number }, Trace];
  picture: [PictureParams, Picture];
  /** `verified`: the text that the verdicts are for, if it is another one */
  source: [{ uri: string }, { uri: string; text: string; verified?: string }];
  save: [{ name: string; type: string; text?: string; base64?: string }, { saved: boolean }];
  /** The host shows what it has read, by `show`. */
  open: [Record<string, never>, null];
  verify: [Record<string, never>, null];
  /** The host stores nothing: all steps are sent each time. */
  simulate: [ChosenRun, Simulation];
  steps: [{ from: number }, RunSteps];
  control: [RunControl, RunStatus];
}
export type Method = keyof Requests;

/** Notifications of the panel to its host. */
export interface Told {
  /** Show this place in the source. `focus`: move the keyboard focus there, too. */
  reveal: { location: Location; focus: boolean };
  /** The current step, with values for decorations and origins for the Fiacre text; null: none. */
  step: CurrentStep | null;
  /** What a run that is watched does at the current step. */
  shine: Live;
  /** Returned in `Hello` when the panel is opened again. */
  remember: Remembered;
}
export interface CurrentStep {
  trace: string;
  index: number;
  count: number;
  step: Step;
  values: { [variable: string]: string };
  /** The user went there; otherwise another trace was shown, and other views do not move. */
  byUser: boolean;
}
export interface Remembered {
  picture?: PictureName;
  trace?: string;
  step?: number;
  pinned?: string[];
  /** conditions whose values are shown at each step */
  watches?: string[];
  /** of the simulation */
  run?: ChosenRun;
}

// ---- notifications of the host ----------------------------------------------------------------

export interface Show {
  picture?: { kind: PictureKind; name: string };
  /** by name of its property */
  trace?: string;
  /** from elsewhere than the program, such as a file */
  given?: Trace;
  /** of the trace */
  step?: number;
  /** to replay and continue */
  run?: ChosenRun;
  /** Show the node at this place, once. */
  at?: Location;
}
export interface News {
  /** It changed: verdicts, progress, or its text. With all `verdicts`, else with those that `changed`, if any. */
  program: Omit<Program, 'verdicts'> & { verdicts?: Verdict[]; changed?: Verdict[] };
  show: Show;
  /** Position of the caret, as an empty range. */
  caret: Location;
  /** The text changed: request pictures again. */
  edited: Record<string, never>;
  /** There are steps of the run to request, or its status has changed. */
  run: RunStatus;
  /** The host has ended: the panel keeps what it shows. */
  gone: Record<string, never>;
}

// ---- messages --------------------------------------------------------------------------------

export type Message =
  | { type: 'request'; id: number; method: Method; params: unknown }
  | { type: 'reply'; id: number; result?: unknown; error?: string }
  | { type: 'told'; method: keyof Told; params: unknown }
  | { type: 'news'; method: keyof News; params: unknown };

/** A host, as the panel sees it. */
export interface Host {
  request<M extends Method>(method: M, params: Requests[M][0]): Promise<Requests[M][1]>;
  tell<M extends keyof Told>(method: M, params: Told[M]): void;
  onNews(listener: (...news: NewsOf) => void): void;
}
export type NewsOf = { [M in keyof News]: [method: M, params: News[M]] }[keyof News];
