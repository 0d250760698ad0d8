package org.sami.crw.console;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletionStage;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.sami.boat.link.BoatMode;
import org.sami.crw.operator.boat.Age;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.FleetCount;
import org.sami.crw.operator.boat.FleetRows;
import org.sami.crw.operator.boat.FleetStopState;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.session.api.FrontFleet;
import org.sami.spn.value.GeoPoint;

/** Commands about boats: which there are, and what a person does with them by hand. */
final class BoatCommands {
    private static final double LONGEST_DRIVE_S = 600;
    private static final double SAYS_WITHIN_S = 1; // how it is; the dead man's time is longer

    private static final String ADDS_BOATS = "Adds simulated boats, which move in real time.";
    private static final String DRIVES = "Drives a boat by hand, -1 to 1 each; 2 s by default";
    private static final String WAITS = " Missions wait until it is given back.";
    private static final String HANDS_BACK = "Gives a boat that was driven by hand back to the missions.";
    private static final String FLEET_STOP = " 'stop all' is the fleet stop.";

    private final ConsoleContext context;

    BoatCommands(ConsoleContext context) {
        this.context = context;
    }

    List<ConsoleCommand> all() {
        return List.of(
                ConsoleCommand.of("boats", "Lists the boats, how they are and what they do.", this::boats),
                ConsoleCommand.of(
                        "connect HOST:PORT[,HOST:PORT...]",
                        "Connects to boats' servers, and keeps at it.",
                        this::connect),
                withBoat(
                        "disconnect BOAT|HOST:PORT",
                        "Gives a boat up, or an address that does not answer; missions keep a boat until it is"
                                + " dropped.",
                        this::disconnect),
                ConsoleCommand.of(
                        "add NAME LAT,LON [COUNT]",
                        context.words()
                                .of(
                                        ADDS_BOATS,
                                        ADDS_BOATS,
                                        "Adds simulated robots, which move in real time: copters where the name begins"
                                                + " with copter, as in copter1, else surface boats."),
                        this::add),
                withBoat(
                        "drop BOAT [MISSION]", "Takes a boat out of a mission, or of all and gives it up.", this::drop),
                withBoat(
                        "take BOAT",
                        "Takes command of a boat, also from another base.",
                        carriedOut(FrontFleet::takeCommand, "taken")),
                withBoat(
                        "ask BOAT",
                        "Asks who commands a boat for its command.",
                        carriedOut(FrontFleet::askForCommand, "asked for")),
                withBoat(
                        "watch BOAT",
                        "Only watches a boat: another base may command it.",
                        carriedOut(FrontFleet::handOver, "watched only")),
                ConsoleCommand.of(
                        "lost-link [ACTION|nothing|set]",
                        "Says what boats do when their link is lost, and what the session wishes; changes the wish, or"
                                + " sets it on the boats that do something else.",
                        new LostLinkCommand(context)::run,
                        words -> LostLinkCommand.words()),
                withBoat("give BOAT CLIENT", "Gives a boat's command to another base.", this::give),
                withBoat(
                        "drive BOAT THRUST RUDDER [SECONDS]",
                        context.words()
                                .of(
                                        DRIVES + "." + WAITS,
                                        "Is refused: copters are not flown by hand from here, but by the radio control"
                                                + " of each.",
                                        DRIVES + "; copters refuse it." + WAITS),
                        this::drive),
                withBoat(
                        "back BOAT",
                        context.words()
                                .of(
                                        HANDS_BACK,
                                        "Is not for copters, which are not flown by hand from here.",
                                        HANDS_BACK),
                        carriedOut(FrontFleet::handBack, "given back")),
                ConsoleCommand.of(
                        "stop BOAT|all",
                        context.words()
                                .of(
                                        "Stops motors at once, until they are released;" + FLEET_STOP,
                                        "Stops a copter at once, until it is released: in the air it stays where it is,"
                                                + " with its motors on;" + FLEET_STOP,
                                        "Stops motors at once, until they are released; a copter in the air stays where"
                                                + " it is, with its motors on;" + FLEET_STOP),
                        this::stop,
                        this::boatOrAll),
                ConsoleCommand.of("release BOAT|all", "Ends a stop.", this::release, this::boatOrAll));
    }

    private ConsoleCommand withBoat(String usage, String help, ConsoleCommand.Action action) {
        return ConsoleCommand.of(usage, help, action, words -> words.size() > 1 ? List.of() : context.boats());
    }

    private List<String> boatOrAll(List<String> words) {
        List<String> all = new ArrayList<>(List.of("all"));
        all.addAll(context.boats());
        return words.size() > 1 ? List.of() : all;
    }

    private FrontFleet fleet() {
        return context.session().fleet();
    }

    private ConsoleCommand.Action carriedOut(BiFunction<FrontFleet, String, CompletionStage<Void>> what, String words) {
        return (arguments, out) -> {
            String boat = arguments.next("boat");
            arguments.end();
            context.await(what.apply(fleet(), boat));
            out.accept(boat + " is " + words);
        };
    }

    private void boats(Arguments arguments, Consumer<String> out) {
        arguments.end();
        long now = context.session().nowMillis();
        List<UnreachedBoat> unreached = context.models().unreached().snapshot();
        List<BoatSnapshot> known = context.models().fleet().snapshot();
        List<BoatSnapshot> boats = FleetRows.of(known, unreached, now);
        if (boats.isEmpty()) {
            out.accept("there is no boat; connect one with: connect HOST:PORT");
        }
        for (BoatSnapshot boat : boats) {
            out.accept(line(boat, now));
        }
        FleetCount count = FleetCount.of(known, unreached);
        if (count.linked() < count.all()) {
            out.accept(count.words() + " linked");
        }
        FleetStopState stop = context.models().fleetStop().snapshot();
        if (stop.isLatched()) {
            out.accept(stop.words());
        }
    }

    /** How one is and what it does; of one that flies also how high it is above the place of its take-off. */
    static String line(BoatSnapshot boat, long nowMillis) {
        StringBuilder line = new StringBuilder(boat.boat()).append("  link ");
        line.append(boat.link().name().toLowerCase(Locale.ROOT));
        boat.linkAgeMillis(nowMillis).ifPresent(age -> line.append(' ').append(Age.words(age)));
        boat.battery()
                .ifPresent(battery ->
                        line.append("  ").append(Math.round(battery.percent())).append(" %"));
        boat.pose().ifPresent(pose -> {
            GeoPoint at = pose.position();
            line.append(String.format(Locale.ROOT, "  %s  %.5f,%.5f", boat.speedWords(), at.latDeg(), at.lonDeg()));
            if (boat.flies()) {
                line.append("  ").append(Math.round(at.altM())).append(" m high");
            }
        });
        if (boat.points() > 0) {
            line.append("  ").append(boat.visited()).append('/').append(boat.points());
        }
        return line.append("  ").append(boat.why().text()).toString();
    }

    private void connect(Arguments arguments, Consumer<String> out) {
        List<BoatAddress> addresses = new ArrayList<>();
        try {
            addresses.addAll(BoatAddress.parseAll(arguments.next("address")));
        } catch (IllegalArgumentException unfit) {
            throw new ConsoleFault(String.valueOf(unfit.getMessage()));
        }
        arguments.end();
        for (BoatAddress address : addresses) {
            out.accept("connecting to " + address);
            context.session().fleet().connect(address); // the boat is reported when it answers
        }
    }

    private void disconnect(Arguments arguments, Consumer<String> out) {
        String boat = arguments.next("boat");
        arguments.end();
        boolean address = context.models().unreached().snapshot().stream()
                .anyMatch(one -> one.address().equals(boat));
        boolean known = context.await(address ? fleet().disconnect(BoatAddress.parse(boat)) : fleet().disconnect(boat));
        out.accept(known ? boat + " is given up" : "there is no boat '" + boat + "'");
    }

    private void add(Arguments arguments, Consumer<String> out) {
        String name = arguments.next("name");
        String[] place = arguments.next("place").split(",", -1);
        long count = arguments.hasNext() ? arguments.number("count") : 1;
        arguments.end();
        GeoPoint at;
        try {
            if (place.length != 2) {
                throw new NumberFormatException();
            }
            at = GeoPoint.of(Double.parseDouble(place[0]), Double.parseDouble(place[1]));
        } catch (IllegalArgumentException unfit) {
            throw new ConsoleFault("a place is LAT,LON in degrees, such as 25.35,51.53");
        }
        if (count < 1 || count > 100) {
            throw new ConsoleFault("1 to 100 boats can be added, not " + count);
        }
        out.accept("added " + String.join(", ", context.await(fleet().addSimulated(name, at, (int) count))));
    }

    private void drop(Arguments arguments, Consumer<String> out) {
        String boat = arguments.next("boat");
        if (arguments.hasNext()) {
            long mission = arguments.number("mission");
            arguments.end();
            context.await(context.session().drop(boat, mission));
            out.accept(boat + " is out of mission " + mission);
        } else {
            context.await(context.session().drop(boat));
            out.accept(boat + " is out of all missions, and given up");
        }
    }

    private void give(Arguments arguments, Consumer<String> out) {
        String boat = arguments.next("boat");
        String client = arguments.next("client");
        arguments.end();
        context.await(fleet().handOver(boat, client));
        out.accept(boat + " is offered to " + client);
    }

    private void drive(Arguments arguments, Consumer<String> out) {
        String boat = arguments.next("boat");
        double thrust = arguments.real("thrust");
        double rudder = arguments.real("rudder");
        double seconds = arguments.hasNext() ? arguments.real("time") : 2;
        arguments.end();
        if (!(seconds > 0 && seconds <= LONGEST_DRIVE_S)) {
            throw new ConsoleFault(
                    "a boat is driven for up to " + Numbers.short1(LONGEST_DRIVE_S) + " s, not " + seconds);
        }
        long end = System.nanoTime() + (long) (seconds * 1e9);
        boolean driven = false;
        for (long left = end - System.nanoTime(); left > 0; left = end - System.nanoTime()) {
            context.await(fleet().teleoperate(boat, thrust, rudder));
            driven |= isByHand(boat);
            context.until(() -> false, Math.min(left / 1e9, FrontFleet.DRIVE_MS / 1e3));
        }
        context.await(fleet().teleoperate(boat, 0, 0));
        driven |= context.until(() -> isByHand(boat), SAYS_WITHIN_S);
        if (!driven) {
            throw new ConsoleFault(boat + " has not said that it is driven by hand; the messages say why, where it"
                    + " does. Missions do not have it before: back " + boat);
        }
        out.accept(boat + " was driven for " + Numbers.short1(seconds) + " s; give it back with: back " + boat);
    }

    /** Whether the boat says so. */
    private boolean isByHand(String boat) {
        return context.models()
                .fleet()
                .boat(boat)
                .flatMap(BoatSnapshot::mode)
                .filter(BoatMode.TELEOPERATION::equals)
                .isPresent();
    }

    private void stop(Arguments arguments, Consumer<String> out) {
        String who = arguments.next("boat");
        arguments.end();
        if (who.equals("all")) {
            List<String> told = context.await(fleet().stopAll());
            out.accept("FLEET STOP: " + (told.isEmpty() ? "no boat is known yet" : String.join(", ", told)));
        } else {
            context.await(fleet().stop(who));
            out.accept(who + " is stopped");
        }
    }

    private void release(Arguments arguments, Consumer<String> out) {
        String who = arguments.next("boat");
        arguments.end();
        if (who.equals("all")) {
            out.accept("released: " + String.join(", ", context.await(fleet().releaseAll())));
        } else {
            context.await(fleet().release(who));
            out.accept(who + " is released");
        }
    }
}
