/**
 * The session's journal: one SQLite file with the plans and the vocabulary that ran, every input, snapshots of the state,
 * telemetry and marks of a simulated world (docs/decisions 0030, 0031).
 *
 * <p>Belongs here: the file format, its durability, finding out how much of a damaged file is true, the state at any
 * entry. Does not belong here: threads and clocks of a session ({@code spn.host}), how messages look as JSON
 * ({@code spn.json}), firing rules.
 */
@NullMarked
package org.sami.spn.journal;

import org.jspecify.annotations.NullMarked;
