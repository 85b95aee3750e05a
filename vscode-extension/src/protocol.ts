/** The server's own requests (docs/lsp.md). What the panel shows has the panel's types. */
import { NotificationType, RequestType } from 'vscode-languageclient/node';
import type { Location, Position, TextDocumentIdentifier, TextEdit } from 'vscode-languageclient/node';
import type * as panel from '../../panel/src/api';

export type { panel };

export interface TextVersion {
  uri: string;
  version: number | null;
}

export interface Verdicts extends Omit<panel.Program, 'pictures' | 'files' | 'progress'> {
  progress: Progress | null;
  /** `verdicts` contains only those that have changed. */
  changes: boolean;
  counts: { total: number; good: number; errors: number; warnings: number; inconclusive: number; pending: number };
  texts: TextVersion[];
}
export interface Progress {
  decided: number;
  total: number;
  classes: number;
  markings: number;
  waiting: number;
  bytes: number;
  seconds: number;
  rate: number;
}

export interface AutomatonParams {
  textDocument: TextDocumentIdentifier;
  kind?: panel.PictureKind;
  name?: string;
  position?: Position;
  format?: 'svg' | 'dot' | 'json';
  dark?: boolean;
  forbidden?: boolean;
  fold?: string[];
}
export interface Automaton extends panel.Picture {
  current: string | null;
  pictures: panel.PictureName[];
  texts: TextVersion[];
}

export interface Model {
  text: string;
  language: 'fiacre' | 'hfiacre';
  ranges: {
    origin: number;
    firstLine: number;
    lastLine: number;
    location: Location | null;
    actor: string;
    description: string;
  }[];
  texts: TextVersion[];
}

export interface TestedProperty {
  id: string;
  label: string;
  kind: string;
  severity: 'error' | 'warning';
  location: Location | null;
}
export interface TestedSubject {
  id: string;
  label: string;
  kind: string;
  location: Location | null;
  properties: TestedProperty[];
}
export interface TestedProgram {
  uri: string;
  label: string;
  main: string | null;
  error: string | null;
  listed: boolean;
  subjects: TestedSubject[];
  texts: TextVersion[];
}

export interface VerifyParams {
  textDocument: TextDocumentIdentifier;
  names?: string[];
  workDoneToken?: string;
}
export interface VerifyResult {
  program: string;
  main: string | null;
  verdicts: panel.Verdict[];
  exploration: panel.Exploration & { rate: number };
  texts: TextVersion[];
}

export interface Trace extends panel.Trace {
  program: string;
  main: string | null;
  texts: TextVersion[];
}

export interface Simulation extends panel.Simulation {
  texts: TextVersion[];
}

export const automaton = new RequestType<AutomatonParams, Automaton, void>('proskill/automaton');
export const model = new RequestType<
  { textDocument: TextDocumentIdentifier; edition?: string }, Model, void>('proskill/model');
export const tests = new RequestType<
  { textDocument?: TextDocumentIdentifier; workspace?: boolean }, { programs: TestedProgram[] }, void>('proskill/tests');
export const verify = new RequestType<VerifyParams, VerifyResult, void>('proskill/verify');
export const trace = new RequestType<
  { textDocument: TextDocumentIdentifier; name: string }, Trace, void>('proskill/trace');
/** A part of a recorded run. */
export interface Recording {
  trace: string;
  begin: number;
  end: number;
  length: number;
  whole: boolean;
}
export const recording = new RequestType<{ uri: string; from?: number }, Recording, void>('proskill/recording');
export const edited = new RequestType<{ sources: { [uri: string]: string } }, { edited: string[] }, void>('proskill/edited');
export const simulate = new RequestType<
  { textDocument: TextDocumentIdentifier } & panel.ChosenRun, Simulation, void>('proskill/simulate');
export const explain = new RequestType<
  { code: string }, { code: string; title: string; markdown: string; plain: string }, void>('proskill/explain');
export const indent = new RequestType<{ textDocument: TextDocumentIdentifier; lines: number[] }, TextEdit[], void>('proskill/indent');
export const verdicts = new NotificationType<Verdicts>('proskill/verdicts');
export const inView = new NotificationType<{ textDocument: TextDocumentIdentifier; range?: panel.Range }>('proskill/view');
