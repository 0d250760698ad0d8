/**
 * Reachability graphs: all markings that a net reaches, in packed form, with shortest runs to them, within a budget (thesis, sections 4.2.1 and 4.3).
 *
 * <p>Not here: texts of questions, which {@code petri.query} reads, coverability, and what the structure of a net says without its states.
 */
@NullMarked
package org.sami.petri.graph;

import org.jspecify.annotations.NullMarked;
