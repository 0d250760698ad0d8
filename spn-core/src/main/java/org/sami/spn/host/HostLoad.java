package org.sami.spn.host;

/**
 * What a host has to do and did; each number by itself is exact, together they are of slightly different moments.
 *
 * @param queued inputs that wait now
 * @param mostQueued the most that ever waited
 * @param processed inputs processed and durable
 * @param batches batches written to the journal
 * @param refused inputs that came after the host had stopped
 * @param telemetryReplaced awaited telemetry that a newer one of the same proxy replaced before it was processed
 * @param slowListeners listener calls that took longer than the host's limit
 * @param listenerFaults listener calls that threw
 */
public record HostLoad(
        long queued,
        long mostQueued,
        long processed,
        long batches,
        long refused,
        long telemetryReplaced,
        long slowListeners,
        long listenerFaults) {}
