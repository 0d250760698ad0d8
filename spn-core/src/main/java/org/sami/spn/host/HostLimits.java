package org.sami.spn.host;

/**
 * How much a host takes at once and how long it waits.
 *
 * @param batchLimit how many inputs one batch takes at most, if its last posting is not counted
 * @param slowListenerMillis from how many milliseconds on a listener's call is reported as slow
 * @param journalRetryMillis how long the host waits for a journal that cannot be written before it stops
 */
record HostLimits(int batchLimit, long slowListenerMillis, long journalRetryMillis) {}
