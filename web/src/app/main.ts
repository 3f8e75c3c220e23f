document.body.textContent = "groundslab";
