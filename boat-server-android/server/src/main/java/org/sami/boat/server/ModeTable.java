package org.sami.boat.server;

import static org.sami.boat.server.ModeAction.DENY;
import static org.sami.boat.server.ModeAction.HAND;
import static org.sami.boat.server.ModeAction.HOLD;
import static org.sami.boat.server.ModeAction.HOME;
import static org.sami.boat.server.ModeAction.KEEP;
import static org.sami.boat.server.ModeAction.LOCK;
import static org.sami.boat.server.ModeAction.NONE;
import static org.sami.boat.server.ModeAction.PATH;
import static org.sami.boat.server.ModeAction.STOP;

import java.util.EnumMap;
import java.util.Map;
import org.sami.boat.link.BoatMode;

/** What a boat does at each event in each mode; the same table is in docs/link.md. */
final class ModeTable {
    private static final Map<ModeEvent, Map<BoatMode, ModeAction>> ACTIONS = new EnumMap<>(ModeEvent.class);

    static {
        // STOPPED, PATH, HOLD, TELEOPERATION, RETURN, FLEET_STOP
        row(KEEP, HOLD, KEEP, KEEP, KEEP, KEEP, ModeEvent.UPLOAD);
        row(PATH, PATH, PATH, PATH, PATH, DENY, ModeEvent.START);
        row(HOLD, HOLD, HOLD, HOLD, HOLD, DENY, ModeEvent.START_AT_END);
        row(HOLD, HOLD, HOLD, HOLD, HOLD, DENY, ModeEvent.HOLD_POSITION);
        row(HOLD, HOLD, HOLD, HOLD, HOLD, DENY, ModeEvent.PANORAMA);
        row(HAND, HAND, HAND, HAND, HAND, DENY, ModeEvent.TELEOPERATE);
        row(STOP, STOP, STOP, STOP, STOP, KEEP, ModeEvent.STOP_MOTORS);
        row(LOCK, LOCK, LOCK, LOCK, LOCK, LOCK, ModeEvent.FLEET_STOP);
        row(KEEP, KEEP, KEEP, KEEP, KEEP, STOP, ModeEvent.FLEET_RELEASE);
        row(HOLD, HOLD, KEEP, HOLD, HOLD, KEEP, ModeEvent.LINK_LOST_HOLD);
        row(HOME, HOME, HOME, HOME, KEEP, KEEP, ModeEvent.LINK_LOST_RETURN);
        row(HOLD, KEEP, KEEP, HOLD, HOLD, KEEP, ModeEvent.LINK_LOST_CONTINUE);
        row(STOP, STOP, STOP, STOP, STOP, KEEP, ModeEvent.LINK_LOST_DRIFT);
        row(NONE, HOLD, NONE, NONE, NONE, NONE, ModeEvent.PATH_DONE);
        row(NONE, NONE, NONE, NONE, HOLD, NONE, ModeEvent.HOME_REACHED);
        row(NONE, NONE, NONE, STOP, NONE, NONE, ModeEvent.HAND_SILENT);
    }

    private ModeTable() {}

    private static void row(
            ModeAction stopped,
            ModeAction path,
            ModeAction hold,
            ModeAction teleoperation,
            ModeAction returning,
            ModeAction fleetStop,
            ModeEvent event) {
        Map<BoatMode, ModeAction> row = new EnumMap<>(BoatMode.class);
        row.put(BoatMode.STOPPED, stopped);
        row.put(BoatMode.PATH, path);
        row.put(BoatMode.HOLD, hold);
        row.put(BoatMode.TELEOPERATION, teleoperation);
        row.put(BoatMode.RETURN, returning);
        row.put(BoatMode.FLEET_STOP, fleetStop);
        ACTIONS.put(event, row);
    }

    static ModeAction action(BoatMode mode, ModeEvent event) {
        Map<BoatMode, ModeAction> row = ACTIONS.get(event);
        ModeAction action = row == null ? null : row.get(mode);
        if (action == null) {
            throw new IllegalStateException("the table has nothing for " + event + " in " + mode);
        }
        return action;
    }
}
