package org.sami.crw.operator.boat;

import java.util.List;
import java.util.Objects;
import java.util.OptionalLong;
import org.sami.crw.proxy.status.LinkState;

/**
 * The status of a boat in all missions (thesis 6.3.4), and its link.
 *
 * @param status severe if any mission says so, otherwise warning if any does, otherwise nominal
 * @param missions the last status in each mission, in order of missions; without missions that gave none
 * @param link state of its link, independent of missions
 * @param heardAtMillis time of the last frame on the session's clock; empty before the first
 */
public record BoatCommunication(
        String boat, ProxyStatus status, List<InMission> missions, LinkState link, OptionalLong heardAtMillis) {

    /**
     * What one mission said.
     *
     * @param event the type of the event whose markup said so
     * @param sinceMillis since when it has been so
     */
    public record InMission(long mission, ProxyStatus status, String event, long sinceMillis) {
        public InMission {
            Objects.requireNonNull(status, "status");
            Objects.requireNonNull(event, "event");
        }
    }

    public BoatCommunication {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(status, "status");
        missions = List.copyOf(missions);
        Objects.requireNonNull(link, "link");
        Objects.requireNonNull(heardAtMillis, "heardAtMillis");
    }
}
