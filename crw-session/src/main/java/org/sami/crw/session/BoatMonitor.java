package org.sami.crw.session;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.TakenWaypoints;
import org.sami.crw.proxy.command.UploadCount;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.status.LinkState;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.protocol.Priority;

/**
 * Looks after the boats' proxies from time to time: how many paths have gone to each boat, and why one that should be under way is
 * not. Says the latter once for each reason that lasts, and which boats wait for one that lies at their next waypoint. For the fleet's thread.
 */
final class BoatMonitor {
    /** So many looks, a second apart, are the usual time of an upload and of a boat's answers. */
    private static final int PATIENCE = 3;

    private final FleetHistory history;
    private final SessionTelemetry telemetry;
    private final SessionMessages messages;
    private final MissionTitles titles;
    private final boolean keepsReasons;
    private final LongSupplier nowMillis;
    private final Map<String, Standstill> standstills = new HashMap<>();
    private final TakenWaypoints takenWaypoints = new TakenWaypoints();

    private record Standstill(String reason, int looks) {}

    /**
     * A monitor before its first look.
     *
     * @param keepsReasons whether each look records why each boat moves or does not; otherwise only standstills are explained
     * @param nowMillis gives the session's time
     */
    BoatMonitor(
            FleetHistory history,
            SessionTelemetry telemetry,
            SessionMessages messages,
            MissionTitles titles,
            boolean keepsReasons,
            LongSupplier nowMillis) {
        this.history = history;
        this.telemetry = telemetry;
        this.messages = messages;
        this.titles = titles;
        this.keepsReasons = keepsReasons;
        this.nowMillis = nowMillis;
    }

    /** Looks at all boats; to be called once a second. */
    void look(ProxyRegistry boats) {
        boats.all().forEach(this::look);
        for (TakenWaypoints.Taken taken : takenWaypoints.look(boats.all())) {
            messages.tell(new OperatorMessage(
                    nowMillis.getAsLong(),
                    taken.mission(),
                    OperatorMessage.Source.DOMAIN,
                    Priority.LOW,
                    taken.words(),
                    List.of(taken.boat(), taken.by()),
                    ""));
        }
    }

    private void look(BoatProxy boat) {
        UploadCount uploads = boat.commands().uploads();
        if (history.uploaded(boat.boatId(), uploads)) {
            telemetry.uploads(boat.boatId(), uploads);
        }
        boolean stands = !boat.isUnderWay()
                && !boat.isAtRest()
                && boat.status().link() != LinkState.LOST; // that was said at once
        String why = stands || keepsReasons ? boat.explain(titles).text() : "";
        if (keepsReasons) {
            history.explained(boat.boatId(), why);
        }
        if (stands) {
            stands(boat.boatId(), why);
        } else {
            standstills.remove(boat.boatId());
        }
    }

    private void stands(String boat, String text) {
        String reason = text.replaceAll("[0-9]+", "#"); // whatever is counted in it is not another reason
        Standstill before = standstills.get(boat);
        int looks = before != null && before.reason.equals(reason) ? before.looks + 1 : 1;
        standstills.put(boat, new Standstill(reason, looks));
        if (looks == PATIENCE) {
            messages.notice(text);
        }
    }
}
