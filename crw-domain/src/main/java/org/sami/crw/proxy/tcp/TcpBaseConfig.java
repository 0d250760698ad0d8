package org.sami.crw.proxy.tcp;

import java.util.Objects;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.OpenLinks;
import org.sami.crw.proxy.link.ProxyConfig;

/**
 * The configuration of a base's TCP links.
 *
 * @param proxy for each boat; its client id must be unique among all bases and sessions that the boats ever meet
 * @param seed of the reconnection jitter
 * @param tickMs time between two ticks of the proxies
 * @param connectWithinMs time limit of a connection attempt
 * @param firstRetryMs delay before the second attempt
 * @param longestRetryMs longest delay between two attempts
 * @param maxQueuedFrames frames waiting at which a boat is dropped and connected again
 * @param maxQueuedBytes bytes waiting at which a boat is dropped and connected again
 * @param security how links are protected; keys withdrawn there are carried to the boats that the base commands
 */
public record TcpBaseConfig(
        ProxyConfig proxy,
        long seed,
        long tickMs,
        int connectWithinMs,
        long firstRetryMs,
        long longestRetryMs,
        int maxQueuedFrames,
        int maxQueuedBytes,
        LinkSecurity security) {

    /** Links as they are, without protection. */
    public TcpBaseConfig(
            ProxyConfig proxy,
            long seed,
            long tickMs,
            int connectWithinMs,
            long firstRetryMs,
            long longestRetryMs,
            int maxQueuedFrames,
            int maxQueuedBytes) {
        this(
                proxy,
                seed,
                tickMs,
                connectWithinMs,
                firstRetryMs,
                longestRetryMs,
                maxQueuedFrames,
                maxQueuedBytes,
                new OpenLinks());
    }

    /** The same with other protection. */
    public TcpBaseConfig withSecurity(LinkSecurity other) {
        return new TcpBaseConfig(
                proxy,
                seed,
                tickMs,
                connectWithinMs,
                firstRetryMs,
                longestRetryMs,
                maxQueuedFrames,
                maxQueuedBytes,
                other);
    }

    /** Ticks every 100 ms; 2 s to connect; again after 0.25 s, at most 4 s; 512 frames or 8 MiB may wait. */
    public static TcpBaseConfig of(ProxyConfig proxy, long seed) {
        return new TcpBaseConfig(proxy, seed, 100, 2000, 250, 4000, 512, 8 << 20, BaseProtection.ofThisProcess());
    }

    /** Refuses what is not positive. */
    public TcpBaseConfig {
        Objects.requireNonNull(proxy, "proxy");
        Objects.requireNonNull(security, "security");
        if (tickMs <= 0 || connectWithinMs <= 0 || maxQueuedFrames <= 0 || maxQueuedBytes <= 0) {
            throw new IllegalArgumentException("ticks every " + tickMs + " ms, connect within " + connectWithinMs
                    + " ms, queue of " + maxQueuedFrames + " frames and " + maxQueuedBytes + " bytes");
        }
        if (firstRetryMs <= 0 || longestRetryMs < firstRetryMs) {
            throw new IllegalArgumentException("retries after " + firstRetryMs + " to " + longestRetryMs + " ms");
        }
    }
}
