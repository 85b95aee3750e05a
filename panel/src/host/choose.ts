import type { Host } from '../api.ts';
import { HttpHost } from './http.ts';
import { ReportHost } from './report.ts';
import { vsCodeHost } from './vscode.ts';

/** Where the panel is: in a report that has its data, in VS Code, or served by `proskill view`. */
export function chooseHost(): Host {
  const data = document.getElementById('proskill-report');
  return data ? new ReportHost(data.textContent ?? '') : (vsCodeHost() ?? new HttpHost());
}
