/**
 * Coverability of nets whose places may be unbounded: the minimal coverability set and its graph, and which places hold any number of tokens.
 *
 * <p>Not here: graphs of all markings, which {@code petri.graph} builds, and what follows from the arcs alone, which {@code petri.structure} says.
 */
@NullMarked
package org.sami.petri.coverability;

import org.jspecify.annotations.NullMarked;
