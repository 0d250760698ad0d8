package org.sami.crw.session;

import java.util.HashMap;
import java.util.Map;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.HealthModel;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.link.LinkLosses;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.protocol.Priority;

/** Reports links that are lost again and again to the session's health, until they have stood for a while. For the fleet's thread. */
final class LinkWatch {
    private final HealthModel health;
    private final Map<String, LinkLosses> links = new HashMap<>();
    private final Map<String, HealthFault> reported = new HashMap<>();

    LinkWatch(HealthModel health) {
        this.health = health;
    }

    /** Something happened to the fleet. */
    void take(FleetEvent event, long nowMillis) {
        if (event instanceof FleetEvent.LinkChanged changed) {
            String boat = changed.boat();
            LinkLosses losses = links.computeIfAbsent(boat, id -> new LinkLosses());
            if (changed.status().link() == LinkState.LOST) {
                losses.lost(nowMillis);
            } else if (changed.status().link() == LinkState.LINKED) {
                losses.back();
            }
            look(boat, losses, nowMillis);
        } else if (event instanceof FleetEvent.Removed removed) {
            links.remove(removed.boat());
            over(removed.boat());
        }
    }

    /** Time has passed: what was counted grows old. */
    void look(long nowMillis) {
        links.forEach((boat, losses) -> look(boat, losses, nowMillis));
    }

    private void look(String boat, LinkLosses losses, long nowMillis) {
        if (!losses.flaps(nowMillis)) {
            over(boat);
            return;
        }
        HealthFault fault = HealthFault.ofBoat(
                HealthKind.LINK,
                boat,
                losses.isLost() ? Priority.HIGH : Priority.MEDIUM,
                "The link to " + boat + " was lost " + losses.words(nowMillis)
                        + (losses.isLost() ? " and is lost now" : "; it stands now"),
                "Bring it nearer or hold it: do not rely on a stop that goes over this link");
        if (!fault.equals(reported.put(boat, fault))) {
            health.report(fault);
        }
    }

    private void over(String boat) {
        if (reported.remove(boat) != null) {
            health.over(HealthKind.LINK, boat);
        }
    }
}
