/**
 * Hosting an engine: its one thread, its journal, its listeners and its handlers.
 *
 * <p>Belongs here: whatever gives the engine's function threads, time and durability. Does not belong here: firing rules
 * ({@code spn.engine}), the journal's file format ({@code spn.journal}), handlers of a domain.
 */
@NullMarked
package org.sami.spn.host;

import org.jspecify.annotations.NullMarked;
