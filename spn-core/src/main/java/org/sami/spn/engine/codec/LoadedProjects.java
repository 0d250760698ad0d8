package org.sami.spn.engine.codec;

import org.sami.spn.engine.net.CompiledProject;

/** Finds the projects that a session loaded, of which its state names the documents only. */
@FunctionalInterface
public interface LoadedProjects {
    /**
     * One of them, compiled.
     *
     * @param before the version before it that the state knows
     * @param sha256 of its document
     * @throws IllegalArgumentException where there is no such document, or it cannot be read
     */
    CompiledProject compiled(CompiledProject before, int version, String sha256);
}
