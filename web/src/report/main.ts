import "./report.css";
console.log("report");
