package org.sami.pair.postgres;

/**
 * What a database says of its standby.
 *
 * @param isConnected whether it answers
 * @param isStreaming whether it gets entries as they come, not what it missed
 * @param behindBytes of the log that it has not applied
 * @param hasEnded whether its base ended in order, and does not go on with the session
 */
record StandbyLook(boolean isConnected, boolean isStreaming, long behindBytes, boolean hasEnded) {}
