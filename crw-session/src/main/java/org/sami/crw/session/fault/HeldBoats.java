package org.sami.crw.session.fault;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.MotionDefaults;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.explanation.ExplainedCommand;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * Has boats stand still whose missions do not go on. What an operator wants of a boat by hand comes before it; a critical command of a mission, such as to
 * come home on an empty battery, is carried out; what else missions have for a boat waits. For the fleet's thread.
 */
final class HeldBoats {

    private final Map<String, String> holds = new HashMap<>(); // the command that holds it, by boat
    private long made;

    /** Boats that carry out a mission's command, or are about to, hold their places from now on; to be called again and again. */
    void hold(ProxyRegistry boats) {
        for (BoatProxy boat : boats.all()) {
            Optional<GeoPoint> here = boat.status().pose().map(BoatPose::position);
            if (here.isPresent()
                    && boat.commands().current().filter(HeldBoats::isToWait).isPresent()) {
                hold(boat, here.get());
            }
        }
    }

    private static boolean isToWait(BoatCommand command) {
        return command.mission() != Ids.NONE && command.priority() != Priority.CRITICAL;
    }

    private void hold(BoatProxy boat, GeoPoint here) {
        String command = ExplainedCommand.AT_FAULT + ++made + "-" + boat.boatId();
        String before = holds.put(boat.boatId(), command);
        if (before != null) {
            boat.commands().withdraw(before);
        }
        boat.commands()
                .submit(new KeepStation(
                        command, Ids.NONE, Ids.NONE, here, MotionDefaults.HOLD_RADIUS_M, Priority.CRITICAL, false));
    }

    /** All boats are stopped until they are released. */
    void stop(ProxyRegistry boats) {
        boats.fleetStop();
    }

    /** Boats that were held go on with what missions want. */
    void letGo(ProxyRegistry boats) {
        holds.forEach((boat, command) ->
                boats.find(boat).ifPresent(proxy -> proxy.commands().withdraw(command)));
        holds.clear();
    }
}
