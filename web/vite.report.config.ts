// The report's script and style: one file each, which groundslab writes into every report; and a list of its messages.
import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";

import { messagesOf } from "./messages.ts";
import { notice } from "./notice.ts";

/** Writes the messages of the sources beside the script, so that a report can hold their translations. */
const listMessages: Plugin = {
  name: "list-messages",
  generateBundle() {
    const folders = ["src/viewer", "src/report"].map((folder) => fileURLToPath(new URL(folder, import.meta.url)));
    const source = `${JSON.stringify(messagesOf(folders), null, 1)}\n`;
    this.emitFile({ type: "asset", fileName: "messages.json", source });
  },
};

export default defineConfig({
  plugins: [listMessages],
  build: {
    outDir: "../src/groundslab/views/report/static",
    emptyOutDir: true,
    target: "es2022",
    rolldownOptions: { output: { postBanner: notice("three", "uplot") } },
    lib: {
      entry: "src/report/main.ts",
      formats: ["iife"],
      name: "groundslabReport",
      fileName: () => "report.js",
      cssFileName: "report",
    },
  },
});
