// The workbench: a folder of files that groundslab's server hands out.
import { defineConfig } from "vite";

export default defineConfig({
  root: "src/app",
  base: "./",
  build: {
    outDir: "../../../src/groundslab/workbench/static",
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 0,
    rolldownOptions: { output: { entryFileNames: "[name].js", chunkFileNames: "[name].js", assetFileNames: "[name][extname]" } },
  },
});
