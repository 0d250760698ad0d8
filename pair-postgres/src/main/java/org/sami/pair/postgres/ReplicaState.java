package org.sami.pair.postgres;

/**
 * What a database says of its replica.
 *
 * @param isConnected whether it answers
 * @param isStreaming whether it gets entries as they come, not what it missed
 * @param behindBytes of the log that it has not applied
 */
record ReplicaState(boolean isConnected, boolean isStreaming, long behindBytes) {}
