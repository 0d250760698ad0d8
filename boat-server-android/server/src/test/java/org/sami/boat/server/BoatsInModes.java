package org.sami.boat.server;

import java.util.List;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.ServerTestBench.Client;

/** Brings the boat of a test bench into a mode, by what a commander says. */
final class BoatsInModes {
    /** The list {@code l1} that these boats hold: one waypoint, 1.1 km north of home. */
    static final List<Waypoint> PATH = List.of(new Waypoint(45.01, 10, 1.5));

    private BoatsInModes() {}

    /** Puts the boat 50 m north of home, looking north, into a mode; all but a boat in {@code FLEET_STOP} were moved by a command before. */
    static Client boatIn(BoatMode mode, ServerTestBench bench) {
        bench.vehicle.northM = 50;
        Client client = bench.commander();
        client.command(new UploadWaypoints("u", "l1", PATH));
        switch (mode) {
            case PATH -> client.command(new StartWaypoints("g", "l1", 0));
            case HOLD -> client.command(new HoldPosition("h"));
            case TELEOPERATION -> client.say(new Teleoperate(0.4, 0));
            case FLEET_STOP -> client.command(new FleetStop("f"));
            case RETURN -> { // as an earlier lost link has left it
                client.command(new StartWaypoints("g", "l1", 0));
                client.command(new SetLostLinkAction("before", LostLinkAction.RETURN));
                client.session.closed(bench.nowMs);
                client = bench.commander();
            }
            case STOPPED -> { // on its way before: a boat that nobody has moved is moved by no lost link
                client.command(new StartWaypoints("g", "l1", 0));
                client.command(new StopMotors("s"));
            }
        }
        return client;
    }
}
