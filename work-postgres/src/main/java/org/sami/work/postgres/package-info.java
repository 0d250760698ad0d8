/**
 * Work that several machines divide: its runs, who makes them and what came of them stand in tables of a PostgreSQL schema of their own (docs/decisions 0545).
 *
 * <p>Belongs here: the tables, leases of runs, the loop that takes runs and makes them. Does not belong here: what a run is and what its result says, which are text here; journals.
 */
@NullMarked
package org.sami.work.postgres;

import org.jspecify.annotations.NullMarked;
