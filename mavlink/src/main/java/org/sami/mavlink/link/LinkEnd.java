package org.sami.mavlink.link;

import java.util.Objects;
import java.util.Optional;

/**
 * As whom this end of a link speaks.
 *
 * @param system its system id, 1 to 255
 * @param component its component id
 * @param linkId the number that its signatures give the link, so that two links of one end do not refuse each other's messages as repeated
 * @param signing how messages are signed; empty where they are not
 */
public record LinkEnd(int system, int component, int linkId, Optional<LinkSigning> signing) {
    private static final int MAX = 255;

    /** An end.
     *
     * @throws IllegalArgumentException if an id is not one
     */
    public LinkEnd {
        Objects.requireNonNull(signing, "signing");
        if (system < 1 || system > MAX || component < 0 || component > MAX || linkId < 0 || linkId > MAX) {
            throw new IllegalArgumentException(
                    "nobody is system " + system + ", component " + component + ", link " + linkId);
        }
    }

    /** Whether the other ends are vehicles, which send a heartbeat each second; ground stations and programs may send nothing for long. */
    boolean isOfBase() {
        return system == MavlinkLink.GROUND_SYSTEM;
    }

    /** A ground station that signs nothing. */
    public static LinkEnd ground() {
        return ground(0, Optional.empty());
    }

    /** A ground station. */
    public static LinkEnd ground(int linkId, Optional<LinkSigning> signing) {
        return new LinkEnd(MavlinkLink.GROUND_SYSTEM, MavlinkLink.GROUND_COMPONENT, linkId, signing);
    }
}
