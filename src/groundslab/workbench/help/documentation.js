// Light or dark, as in the workbench.
const chosen = localStorage.getItem("groundslab-theme");
if (chosen === "light" || chosen === "dark") document.documentElement.dataset.theme = chosen;
