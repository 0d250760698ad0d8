package org.sami.petri.query;

import java.util.Optional;
import org.sami.petri.symmetry.NetSymmetry;

/**
 * By what searches for queries are made smaller.
 *
 * @param reduces whether queries about deadlocks use stubborn sets
 * @param symmetry by which states count as one; used for queries that do not tell exchanged parts apart
 */
public record QueryMeans(boolean reduces, Optional<NetSymmetry> symmetry) {}
