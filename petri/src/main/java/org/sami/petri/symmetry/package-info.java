/**
 * Symmetries of nets: which parts can be exchanged without a difference, and markings that are alike because of it.
 *
 * <p>Not here: the search that uses them, and which boats of a plan are alike.
 */
@NullMarked
package org.sami.petri.symmetry;

import org.jspecify.annotations.NullMarked;
