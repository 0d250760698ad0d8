/**
 * Looking at a session again: when what happened, how its time is played, and what stood where at any moment of a journal.
 *
 * <p>Belongs here: what holds for the journal of any domain. Does not belong here: how journals are stored ({@code spn.journal}), telemetry,
 * whose words are the domain's.
 */
@NullMarked
package org.sami.spn.replay;

import org.jspecify.annotations.NullMarked;
