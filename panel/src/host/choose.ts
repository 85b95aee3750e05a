import type { Host } from '../api.ts';
import { HttpHost } from './http.ts';
import { ReportHost } from './report.ts';
import { vsCodeHost } from './vscode.ts';

/** The environment of the panel: a report with its data, VS Code, or `proskill view`. */
export function chooseHost(): Host {
  const data = document.getElementById('proskill-report');
  return data ? new ReportHost(data.textContent ?? '') : (vsCodeHost() ?? new HttpHost());
}
