// The report's script and style: one file each, which groundslab writes into every report.
import { defineConfig } from "vite";

export default defineConfig({
  build: {
    outDir: "../src/groundslab/report/static",
    emptyOutDir: true,
    target: "es2022",
    lib: { entry: "src/report/main.ts", formats: ["iife"], name: "groundslabReport", fileName: () => "report.js", cssFileName: "report" },
  },
});
