package org.sami.boat.server;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;

/**
 * Two bases with three links each, and a boat that is restarted now and then with its log. What they send comes in any order,
 * late, twice, and over links that were made again in between. It notes every motion that is executed after a stop that was sent
 * later.
 */
final class DelayedFrames {
    private static final int LINKS = 6;

    /** A frame on its way, and when it was sent among all frames. */
    private record Late(int link, long sent, LinkMessage message, Supplier<byte[]> frame) {}

    private final SplittableRandom random;
    private final List<ServerTestBench.Client> links = new ArrayList<>();
    private final long[] sequences = new long[LINKS];
    private final List<Late> onTheWay = new ArrayList<>();
    private final List<String> faults = new ArrayList<>();
    private ServerTestBench bench = new ServerTestBench();
    private long sent;
    private long newestStop = -1;
    private long stops;
    private long motions;

    DelayedFrames(long seed, List<Waypoint> path) {
        random = new SplittableRandom(seed);
        connectAll();
        links.get(0).say(sequences[0]++, new Hello("boat1", "base0", Role.COMMANDER, 1, ""));
        links.get(0).say(sequences[0]++, new UploadWaypoints("u", "l", path));
    }

    private void connectAll() {
        links.clear();
        for (int i = 0; i < LINKS; i++) {
            links.add(bench.new Client());
        }
    }

    /** Motions that were executed although an executed stop was sent after them. */
    List<String> faults() {
        return faults;
    }

    /** How many stops were executed. */
    long stops() {
        return stops;
    }

    /** How many motions were executed. */
    long motions() {
        return motions;
    }

    void play(int steps) {
        for (int i = 0; i < steps; i++) {
            int what = random.nextInt(100);
            if (what < 45) {
                send(random.nextInt(LINKS));
            } else if (what < 92) {
                deliver();
            } else if (what < 97) {
                bench.run(random.nextInt(5) == 0 ? 4 : 0.2);
            } else if (what < 99) {
                connectAnew(random.nextInt(LINKS));
            } else {
                startAnew();
            }
        }
    }

    private void send(int link) {
        LinkMessage message = message(link);
        byte[] frame = links.get(link).frame(sequences[link]++, message);
        onTheWay.add(new Late(link, sent++, message, () -> frame));
    }

    private LinkMessage message(int link) {
        String id = "c" + sent;
        return switch (random.nextInt(12)) {
            case 0, 1 -> new Hello("boat1", "base" + link % 2, Role.COMMANDER, 1, "");
            case 2 -> new TakeCommand(id);
            case 3, 4 -> new StartWaypoints(id, "l", 0);
            case 5, 6 -> new Teleoperate(hand(sent), 0);
            case 7 -> new HoldPosition(id);
            case 8 -> new FleetStop(id);
            case 9 -> new FleetRelease(id);
            case 10 -> new Heartbeat(1);
            default -> new StopMotors(id);
        };
    }

    /** An effort that only one message asks for. */
    private static double hand(long sent) {
        return 0.1 + sent * 1e-4;
    }

    /** The oldest, mostly, or any that is on its way; sometimes it stays on its way and comes again. */
    private void deliver() {
        if (onTheWay.isEmpty()) {
            return;
        }
        int which = random.nextInt(3) > 0 ? 0 : random.nextInt(onTheWay.size());
        Late late = onTheWay.get(which);
        if (random.nextInt(4) > 0) {
            onTheWay.remove(which);
        }
        BoatMode before = bench.server.mode();
        int executed = bench.log.size();
        links.get(late.link()).hear(late.frame().get());
        bench.run(0.1);
        boolean wasExecuted = late.message() instanceof CommandMessage command
                && bench.log.subList(executed, bench.log.size()).contains(command.commandId() + " ack");
        note(late, before, wasExecuted);
    }

    private void note(Late late, BoatMode before, boolean wasExecuted) {
        LinkMessage message = late.message();
        boolean byHand = message instanceof Teleoperate
                && bench.server.mode() == BoatMode.TELEOPERATION
                && Math.abs(bench.vehicle.thrust() - hand(late.sent())) < 1e-6;
        boolean moves = wasExecuted
                && (message instanceof StartWaypoints
                        || (message instanceof FleetRelease && before == BoatMode.FLEET_STOP)
                        || (message instanceof HoldPosition && before == BoatMode.STOPPED));
        if (byHand || moves) {
            motions++;
            if (late.sent() < newestStop) {
                faults.add(message.type() + " sent as " + late.sent() + ", stop sent as " + newestStop);
            }
        }
        if (wasExecuted && (message instanceof StopMotors || message instanceof FleetStop)) {
            stops++;
            newestStop = Math.max(newestStop, late.sent());
        }
    }

    /** The link breaks and is made again; what was on its way in it comes over the new one. */
    private void connectAnew(int link) {
        links.get(link).session.closed(bench.nowMs);
        links.set(link, bench.new Client());
    }

    private void startAnew() {
        bench = bench.startedAnew();
        connectAll();
    }
}
