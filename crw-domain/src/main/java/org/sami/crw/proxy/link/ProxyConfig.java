package org.sami.crw.proxy.link;

import java.util.Objects;

/**
 * What is set for the base's side of the links.
 *
 * @param clientId names this base to the boats, and its commands: over a network it must be unique among all bases and
 *     sessions that the boats ever meet, as boats do not execute an id again
 * @param epoch counts the starts of this base in one session, so that wire ids of an earlier start are never used again
 * @param cruiseSpeedMps speed of paths that name none, in m/s
 * @param telemetryHz wished telemetry messages a second
 * @param lostAfterMs the link is lost after this time without a frame
 * @param resendMs an unanswered request is sent again after this time
 * @param maxSends a request that stays unanswered is given up after so many times
 */
public record ProxyConfig(
        String clientId,
        int epoch,
        double cruiseSpeedMps,
        double telemetryHz,
        long lostAfterMs,
        long resendMs,
        int maxSends) {

    /** Cruise 1.5 m/s, telemetry once a second, lost after 3.5 s, 20 tries a second apart. */
    public static final ProxyConfig DEFAULT = new ProxyConfig("base", 0, 1.5, 1, 3500, 1000, 20);

    /** Refuses what is not positive. */
    public ProxyConfig {
        Objects.requireNonNull(clientId, "clientId");
        if (clientId.isEmpty() || epoch < 0) {
            throw new IllegalArgumentException("client " + clientId + ", epoch " + epoch);
        }
        if (!(cruiseSpeedMps > 0 && telemetryHz > 0 && lostAfterMs > 0 && resendMs > 0 && maxSends > 0)) {
            throw new IllegalArgumentException("cruise " + cruiseSpeedMps + " m/s, telemetry " + telemetryHz
                    + " Hz, lost after " + lostAfterMs + " ms, resend " + resendMs + " ms x " + maxSends);
        }
    }

    /** The same for a base of another name. */
    public ProxyConfig withClientId(String newClientId) {
        return new ProxyConfig(newClientId, epoch, cruiseSpeedMps, telemetryHz, lostAfterMs, resendMs, maxSends);
    }

    /** The same for a later start of this base. */
    public ProxyConfig withEpoch(int newEpoch) {
        return new ProxyConfig(clientId, newEpoch, cruiseSpeedMps, telemetryHz, lostAfterMs, resendMs, maxSends);
    }

    /** The same with another telemetry rate. */
    public ProxyConfig withTelemetryHz(double hz) {
        return new ProxyConfig(clientId, epoch, cruiseSpeedMps, hz, lostAfterMs, resendMs, maxSends);
    }
}
