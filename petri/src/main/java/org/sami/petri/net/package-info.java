/**
 * Place/transition nets with weighted, inhibitor and reset arcs, and their firing rule.
 *
 * <p>Not here: files, which {@code petri.pnml} reads and writes, and every kind of analysis, which has a package of its own. No plan and no boat: what turns
 * plans into nets knows this module, never the other way round.
 */
@NullMarked
package org.sami.petri.net;

import org.jspecify.annotations.NullMarked;
