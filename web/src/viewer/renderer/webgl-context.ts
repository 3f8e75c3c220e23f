// Whether a graphics card stands behind the browser's WebGL.

/**
 * Return a WebGL 2 context of a canvas; throws where there is none, or one that the processor only imitates: our own
 * drawing is several times faster than that. An attribute data-painter="webgl" of the page takes any WebGL,
 * data-painter="processor" none.
 */
export function contextOf(canvas: HTMLCanvasElement, attributes: WebGLContextAttributes): WebGL2RenderingContext {
  const wanted = document.documentElement.dataset["painter"];
  const any = wanted === "webgl";
  const gl =
    wanted === "processor" ? null : canvas.getContext("webgl2", { ...attributes, failIfMajorPerformanceCaveat: !any });
  if (!gl) throw new Error("no WebGL 2");
  if (!any && isImitated(gl)) {
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    throw new Error("WebGL without a graphics card");
  }
  return gl;
}

function isImitated(gl: WebGL2RenderingContext): boolean {
  const about = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(about ? about.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
