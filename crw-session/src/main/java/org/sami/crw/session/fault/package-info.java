/**
 * What a session does when a part of it fails: the engine or its journal, a thread, the memory, the disk. Finds such faults, reports them to the session's
 * health and has boats stand still meanwhile (docs/decisions, 0391 to 0393). Does not belong here: faults of boats, links and missions.
 */
@NullMarked
package org.sami.crw.session.fault;

import org.jspecify.annotations.NullMarked;
