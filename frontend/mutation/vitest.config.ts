import page from "../vite.config";

/** The tests that should notice: those of the rooms in which something is changed. */
const NOTICING = `src/@(${process.env["MUTATED_ROOMS"]})/**/*.test`;

const { projects = [], ...test } = page.test ?? {};

export default {
  ...page,
  test: {
    ...test,
    // What one file's tests have run must not count as run by the next file's.
    isolate: true,
    projects: projects.map((project) => {
      if (typeof project !== "object" || !("test" in project)) {
        throw new Error("the page's tests are described in another way");
      }
      const [all = ""] = project.test?.include ?? [];
      return { ...project, test: { ...project.test, include: [all.replace("src/**/*.test", NOTICING)] } };
    }),
  },
};
