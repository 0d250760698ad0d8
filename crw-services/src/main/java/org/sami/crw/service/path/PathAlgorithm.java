package org.sami.crw.service.path;

import org.sami.crw.service.choice.DeclaredAlgorithm;

/** Finds a way that enters nothing forbidden, or says that it finds none. Deterministic; no state. */
public interface PathAlgorithm extends DeclaredAlgorithm<PathProblem> {
    /** A way, or why there is none. */
    PathAnswer find(PathProblem problem);
}
