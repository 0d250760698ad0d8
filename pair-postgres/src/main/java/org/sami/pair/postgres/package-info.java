/**
 * A pair of bases: each laptop runs an installed PostgreSQL of its own, in a folder of the user, and one replicates the other (thesis 6.2: the base itself is what fails; docs/decisions 0590).
 *
 * <p>Belongs here: making the two databases, starting and stopping them, whether the replica follows, what is protected. Does not belong here: replication, which is PostgreSQL's; journals and
 * their lease, which are journal-postgres'.
 */
@NullMarked
package org.sami.pair.postgres;

import org.jspecify.annotations.NullMarked;
