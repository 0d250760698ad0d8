/**
 * Questions about the reachable markings of a net: their text, and how a search answers them (thesis, sections 4.3.1 to 4.3.3).
 *
 * <p>Not here: questions about plans, whose places and boats have names of their own.
 */
@NullMarked
package org.sami.petri.query;

import org.jspecify.annotations.NullMarked;
