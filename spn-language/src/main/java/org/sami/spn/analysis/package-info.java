/**
 * Checks of plans that need no run: what is missing, what contradicts itself, what can never happen (thesis 4.3.3, 5.1).
 *
 * <p>Belongs here: one class for each check, with stable codes, and what they have in common. Does not belong here: whether
 * a document can be read at all ({@code spn.json}), the exploration of markings.
 */
@NullMarked
package org.sami.spn.analysis;

import org.jspecify.annotations.NullMarked;
