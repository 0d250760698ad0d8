package org.sami.pair.postgres;

/**
 * What a database says of the standby of a session.
 *
 * @param replica how its database follows
 * @param isWatched whether a base waits there to go on with this session, and its database is not there alone
 * @param hasEnded whether the last base that waited there ended in order, and goes on with no session
 */
record StandbyState(ReplicaState replica, boolean isWatched, boolean hasEnded) {
    boolean isConnected() {
        return replica.isConnected();
    }
}
