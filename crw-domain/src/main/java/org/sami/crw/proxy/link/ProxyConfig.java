package org.sami.crw.proxy.link;

import java.util.Objects;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.MotionDefaults;

/**
 * The configuration of the base's side of the links.
 *
 * @param clientId names this base and its commands to the boats. Over a network it must be unique among all bases and sessions that the boats
 *     ever meet: boats do not execute an id again
 * @param epoch counts the starts of this base in one session, so that wire ids of an earlier start are never used again
 * @param cruiseSpeedMps speed of paths that name none, in m/s
 * @param telemetryHz telemetry messages a second to ask for
 * @param lostAfterMs time without a frame after which the link is lost
 * @param resendMs time after which an unanswered request is sent again
 * @param maxSends number of sends after which an unanswered request is given up
 */
public record ProxyConfig(
        String clientId,
        int epoch,
        double cruiseSpeedMps,
        double telemetryHz,
        long lostAfterMs,
        long resendMs,
        int maxSends) {

    /** What {@link LinkDefaults} and {@link BaseDefaults} say. */
    public static final ProxyConfig DEFAULT = new ProxyConfig(
            "base",
            0,
            MotionDefaults.CRUISE_SPEED_MPS,
            LinkDefaults.TELEMETRY_HZ,
            LinkDefaults.LINK_LOST_AFTER_MS,
            BaseDefaults.RESEND_MS,
            BaseDefaults.MAX_SENDS);

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

    /** Id of this start of the base, by which boats know whom they have appointed. */
    public String session() {
        return clientId + "." + epoch;
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
