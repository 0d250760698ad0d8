package org.sami.crw.proxy.tcp;

import java.util.Objects;
import org.sami.crw.proxy.link.ProxyConfig;

/**
 * What is set for the TCP links of a base.
 *
 * @param proxy for each boat; its client id must be unique among all bases and sessions that the boats ever meet
 * @param seed of the jitter in reconnecting
 * @param tickMs time between two ticks of the proxies
 * @param connectWithinMs a try to connect is given up after this time
 * @param firstRetryMs time before the second try
 * @param longestRetryMs most time between two tries
 * @param maxQueuedFrames a boat that lets more frames wait is dropped, and connected anew
 * @param maxQueuedBytes the same for bytes
 */
public record TcpBaseConfig(
        ProxyConfig proxy,
        long seed,
        long tickMs,
        int connectWithinMs,
        long firstRetryMs,
        long longestRetryMs,
        int maxQueuedFrames,
        int maxQueuedBytes) {

    /** Ticks every 100 ms; 2 s to connect; again after 0.25 s, at most 4 s; 512 frames or 8 MiB may wait. */
    public static TcpBaseConfig of(ProxyConfig proxy, long seed) {
        return new TcpBaseConfig(proxy, seed, 100, 2000, 250, 4000, 512, 8 << 20);
    }

    /** Refuses what is not positive. */
    public TcpBaseConfig {
        Objects.requireNonNull(proxy, "proxy");
        if (tickMs <= 0 || connectWithinMs <= 0 || maxQueuedFrames <= 0 || maxQueuedBytes <= 0) {
            throw new IllegalArgumentException("ticks every " + tickMs + " ms, connect within " + connectWithinMs
                    + " ms, queue of " + maxQueuedFrames + " frames and " + maxQueuedBytes + " bytes");
        }
        if (firstRetryMs <= 0 || longestRetryMs < firstRetryMs) {
            throw new IllegalArgumentException("retries after " + firstRetryMs + " to " + longestRetryMs + " ms");
        }
    }
}
