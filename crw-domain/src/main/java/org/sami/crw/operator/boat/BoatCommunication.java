package org.sami.crw.operator.boat;

import java.util.List;
import java.util.Objects;
import java.util.OptionalLong;
import org.sami.crw.proxy.status.LinkState;

/**
 * How a boat stands in all missions (thesis 6.3.4), and its link.
 *
 * @param status severe if it is so in any mission, else warning if it is so in any, else nominal
 * @param missions what each mission said last, in order of missions; without those that said nothing
 * @param link how its link stands, whatever missions say
 * @param heardAtMillis when the last frame came, on the session's clock; empty before one has
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
