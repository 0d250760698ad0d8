package org.sami.crw.session;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.MotionDefaults;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Commands boats for the end of a session, and says which do not do so yet. */
final class EndCommands {
    private static final long TIMEOUT_MS = 3000;
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

    private final BoatsAtEnd end;
    private final Map<String, GeoPoint> held = new LinkedHashMap<>();

    EndCommands(BoatsAtEnd end) {
        this.end = end;
    }

    /**
     * Gives the commands, and waits until the boats execute them or the time is over; afterwards nothing is recorded about boats. Not on the fleet's thread.
     *
     * @param last runs when the boats have been commanded, while what they report still counts
     * @return the boats that have not confirmed it, in words
     */
    List<String> giveTo(SessionFleet fleet, Runnable last) {
        fleet.onFleet(boats -> {
            fleet.watches().lookAtBoats();
            tell(boats);
            return null;
        });
        long latest = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(TIMEOUT_MS);
        while (!fleet.onFleet(this::isDone) && System.nanoTime() < latest) {
            LockSupport.parkNanos(LOOK_NANOS);
        }
        last.run();
        List<String> others = fleet.onFleet(boats -> {
            fleet.watches().flushPoses();
            return others(boats); // some confirm it while something else is waited for
        });
        fleet.listenNoLonger();
        return others;
    }

    /** Tells them. A boat that is to hold its place and has not said where it is stops. */
    private void tell(ProxyRegistry boats) {
        if (end == BoatsAtEnd.GO_ON) {
            return;
        }
        for (BoatProxy boat : boats.all()) {
            List<BoatCommand> queued = new ArrayList<>(boat.commands().waiting());
            boat.commands().current().ifPresent(queued::add);
            queued.forEach(command -> boat.commands().withdraw(command.commandId())); // a block stays
            boat.release(); // what it is to do would wait as long as it is driven by hand
            if (end == BoatsAtEnd.HOLD && boat.isCommanding()) {
                boat.status().pose().map(BoatPose::position).ifPresent(here -> hold(boat, here));
            }
        }
    }

    private void hold(BoatProxy boat, GeoPoint here) {
        held.put(boat.boatId(), here);
        String command = "hold-at-end-" + boat.boatId();
        boat.commands()
                .submit(new KeepStation(
                        command, Ids.NONE, Ids.NONE, here, MotionDefaults.HOLD_RADIUS_M, Priority.CRITICAL, false));
    }

    /** Whether nothing is to be waited for: a boat without a link cannot say anything. */
    private boolean isDone(ProxyRegistry boats) {
        return boats.all().stream().allMatch(boat -> does(boat) || boat.status().link() != LinkState.LINKED);
    }

    /** The boats that have not confirmed their last command, in words. */
    private List<String> others(ProxyRegistry boats) {
        String what = end == BoatsAtEnd.HOLD ? "it holds its place" : "it stops";
        return boats.all().stream()
                .filter(boat -> !does(boat))
                .map(boat -> boat.boatId() + " has not said that " + what
                        + "; without a link it does what is set for a lost one")
                .toList();
    }

    private boolean does(BoatProxy boat) {
        if (end == BoatsAtEnd.GO_ON) {
            return true;
        }
        if (!held.containsKey(boat.boatId())) {
            return boat.isAtRest();
        }
        Optional<BoatMode> mode = boat.status().mode();
        return mode.filter(now -> now == BoatMode.HOLD || now == BoatMode.FLEET_STOP)
                .isPresent();
    }
}
