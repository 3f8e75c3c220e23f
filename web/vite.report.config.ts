// The report's script and style: one file each, which groundslab writes into every report.
import { defineConfig } from "vite";

import { notice } from "./notice.ts";

export default defineConfig({
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
