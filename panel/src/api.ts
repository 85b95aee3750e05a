/**
 * The contract between the panel and its host: VS Code's webview, a browser that `proskill view`
 * serves, or a report. It is spoken in messages (`Message`) that are plain JSON.
 *
 * The data are those of the language server (docs/lsp.md) and keep its names, so that a host passes
 * answers on as they are. A `Location` is opaque to the panel: it shows its line and gives it back.
 */

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
}

// ---- what there is to see -------------------------------------------------------------------

export interface Seconds {
  exact: string;
  seconds: number;
}
/** `strict`: not the date itself, but arbitrarily near to it. */
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
  /** null: as late as one likes */
  latest: Moment | null;
  changes: Change[];
  /** why it came, or came so, in a sentence */
  why?: string;
  /** absent or true: it matters to what the trace shows */
  relevant?: boolean;
  /** the steps that it depends on directly, from 0 */
  causes?: number[];
  transitions: string[];
  origins?: number[];
  /** of a recorded run: this is no step of the model, but something that is said of the run: `fault`, `undershoot` … */
  remark?: string;
  /** Of a run that was chosen: it came as late as it could. */
  late?: boolean;
}
export type ActorKind = 'skill' | 'branch' | 'watchdog' | 'event' | 'environment' | 'variable' | 'process';
export interface Actor {
  name: string;
  kind: ActorKind;
  skill: string | null;
}
export interface Trace {
  name: string;
  description: string;
  verdict: string;
  /** what the trace shows, in a sentence */
  summary?: string;
  initial: { [variable: string]: string };
  steps: Step[];
  /** Where absent, the panel makes them out by the words of the steps. */
  actors?: Actor[];
  /** The steps from this one on repeat for ever. */
  loop?: number | null;
  stale?: boolean;
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
  /** what its trace shows, in a sentence */
  summary?: string;
  /** it is being verified, and not decided yet */
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
/** All that is known of a program, as the server's notification `proskill/verdicts` tells it. */
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
  /** for a list to choose from, where the panel shows the source itself */
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
  /** SVG or DOT, as asked for */
  content: string;
  /** The program has errors: the picture may lack parts. */
  errors: boolean;
  nodes: PictureNode[];
  edges: PictureEdge[];
  clusters: PictureCluster[];
  /** What can be folded. Absent or empty: nothing. */
  foldable?: Foldable[];
  /** A sentence where more is folded than was asked for, because the picture is large. */
  foldedBecause?: string;
}
/** A cluster that can be drawn as one node. */
export interface Foldable {
  /** the same, whatever is folded */
  key: string;
  label: string;
  /** the id of its cluster, or of the node in its place; null: it is within another that is folded */
  part: string | null;
  folded: boolean;
}
export interface PictureParams {
  kind: PictureKind;
  name: string;
  format: 'svg' | 'dot';
  dark: boolean;
  forbidden?: boolean;
  /** Keys of `foldable`; absent: as the host thinks best for a picture of this size. */
  fold?: string[];
}

/** A step of a run that somebody chose, as it is found again, also after edits. */
export interface ChosenStep {
  actor: string;
  description: string;
  transitions: string[];
  late?: boolean;
}
/** A run as it is saved and asked for: a trace has all of it but what it expects. */
export interface ChosenRun {
  main?: string;
  steps: ChosenStep[];
  /** values behind the last step */
  expect?: { [variable: string]: string };
}
/** Where a chosen run is. */
export interface Simulation {
  main: string;
  /** the steps that were possible */
  trace: Trace;
  /** what may come next, the likeliest first; empty: nothing is possible any more */
  choices: Step[];
  /** the first of the steps that is not possible where it was */
  missing: { index: number; why: string } | null;
  /** of what the run expects */
  unmet: { variable: string; expected: string; actual: string }[];
}

// ---- what the panel asks its host ------------------------------------------------------------

export interface Hello {
  contract: typeof contractVersion;
  /** `all`: with a list of verdicts and the source; else one view, for a host that has the rest */
  layout: 'all' | 'trace' | 'automaton' | 'simulation';
  can: {
    /** The panel shows the source itself, by `source`. */
    source: boolean;
    /** The host writes files, by `save`; else the browser does. */
    save: boolean;
    /** `open` asks the user for a trace's file; else the browser does. */
    open: boolean;
    /** `verify` begins a verification. */
    verify: boolean;
    /** `simulate` takes steps that the user chooses. */
    simulate: boolean;
    /** `caret` is sent when the caret moves. */
    follow: boolean;
  };
  program: Program | null;
  /** What to show first. */
  show?: Show;
  /** What `remember` was given last. */
  remembered?: Remembered;
}

/** Each request's parameters and its result. */
export interface Requests {
  /** Sent once, when the panel is there. */
  hello: [Record<string, never>, Hello];
  trace: [{ name: string }, Trace];
  picture: [PictureParams, Picture];
  source: [{ uri: string }, { uri: string; text: string }];
  save: [{ name: string; type: string; text?: string; base64?: string }, { saved: boolean }];
  /** The host shows what it has read, by `show`. */
  open: [Record<string, never>, null];
  verify: [Record<string, never>, null];
  /** The host keeps nothing of it: all steps are sent each time. */
  simulate: [ChosenRun, Simulation];
}
export type Method = keyof Requests;

/** What the panel tells its host without waiting. */
export interface Told {
  /** Show this place in the source. `focus`: the keyboard goes there too. */
  reveal: { location: Location; focus: boolean };
  /** The current step: values for decorations, origins for the Fiacre text; null: none is. */
  step: CurrentStep | null;
  /** To be given back in `Hello` when the panel is opened again. */
  remember: Remembered;
}
export interface CurrentStep {
  trace: string;
  index: number;
  count: number;
  step: Step;
  values: { [variable: string]: string };
  /** The user went there; else the trace is another one, and views stay where they are. */
  byUser: boolean;
}
export interface Remembered {
  picture?: PictureName;
  trace?: string;
  step?: number;
  pinned?: string[];
  /** conditions whose value is shown at each step */
  watches?: string[];
  /** of the simulation */
  run?: ChosenRun;
}

// ---- what the host tells the panel -----------------------------------------------------------

export interface Show {
  picture?: { kind: PictureKind; name: string };
  /** by the name of its property */
  trace?: string;
  /** that is not one of the program's, such as one of a file */
  given?: Trace;
  /** of the trace */
  step?: number;
  /** to replay and to go on with */
  run?: ChosenRun;
  /** The node at this place, once. */
  at?: Location;
}
export interface News {
  /** It changed: verdicts, progress, or its text. Without verdicts where they are as before. */
  program: Omit<Program, 'verdicts'> & { verdicts?: Verdict[] };
  show: Show;
  /** Where the caret is; an empty range. */
  caret: Location;
  /** The text changed: pictures are asked for again. */
  edited: Record<string, never>;
  /** The host has ended: what is here stays, nothing new comes. */
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
