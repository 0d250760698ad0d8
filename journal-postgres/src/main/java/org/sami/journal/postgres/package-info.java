/**
 * The journal of a session in PostgreSQL: the tables of {@code spn.journal} in a schema of their own, and a lease with an epoch that decides which base may write (docs/decisions 0493).
 *
 * <p>Belongs here: addresses, connections, migrations, the lease, what PostgreSQL's faults mean in words. Does not belong here: the chain of checksums and how far a journal is true
 * ({@code spn.journal}), who commands boats, replication, which is PostgreSQL's.
 */
@NullMarked
package org.sami.journal.postgres;

import org.jspecify.annotations.NullMarked;
