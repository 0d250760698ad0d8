package org.sami.pair.postgres;

/**
 * What a database says of its standby.
 *
 * @param isConnected whether it answers
 * @param isStreaming whether it gets entries as they come, not what it missed
 * @param behindBytes of the log that it has not applied
 * @param isWatched whether a base waits there to go on with the session, and not its database alone
 * @param hasEnded whether its base ended in order, and does not go on with the session
 */
record StandbyState(boolean isConnected, boolean isStreaming, long behindBytes, boolean isWatched, boolean hasEnded) {}
