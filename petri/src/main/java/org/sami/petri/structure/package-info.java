/**
 * What follows from the arcs of a net alone, without its reachable markings: invariants, siphons, traps and the state equation, and the answers that they prove.
 *
 * <p>Every answer that says "never" or "always" carries a proof in whole numbers that was checked by exact arithmetic; the linear programs, which compute with
 * floating point, only suggest such proofs. What structure cannot prove stays open: then a search through markings is needed, which is not here.
 *
 * <p>Inhibitor arcs only take firings away, so everything that holds of all markings without them still holds. A reset arc is treated as a transition that may
 * remove tokens of its place one by one ({@link org.sami.petri.structure.Incidence}): what is proved then holds however much a reset removes.
 */
@NullMarked
package org.sami.petri.structure;

import org.jspecify.annotations.NullMarked;
