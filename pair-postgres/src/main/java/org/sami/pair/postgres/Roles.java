package org.sami.pair.postgres;

/** Who may do what in the database of a pair. */
final class Roles {
    /** Owns the database; used to make it only. */
    static final String ADMIN = "sami_admin";
    /** Writes sessions, says whether a standby is waited for, and promotes a replica. */
    static final String SESSION = "sami";
    /** Reads for a replica. */
    static final String REPLICA = "sami_replica";

    /** The database. */
    static final String DATABASE = "sami";

    private Roles() {}
}
