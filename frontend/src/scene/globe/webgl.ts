let isOffered = false;

/** Whether this browser offers what the globe is drawn with. Asked before the engine is fetched, which is in vain without. */
export function hasWebgl(): boolean {
  // What was offered once stays; what was not may have been switched on meanwhile.
  if (!isOffered) {
    const context = document.createElement("canvas").getContext("webgl2");
    isOffered = context !== null;
    // A browser has some sixteen contexts, and this one is not needed any more.
    context?.getExtension("WEBGL_lose_context")?.loseContext();
  }
  return isOffered;
}
