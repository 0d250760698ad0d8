package org.sami.crw.cli.run;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.cli.station.StationLinks;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.crw.sim.boat.WaterAround;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.spn.journal.JournalAddress;

/** Opens a session as its options say, and has it used by a command. */
final class SessionOpening {
    private final Asked asked;
    private final List<BoatAddress> addresses;
    private final FaultPolicy policy;
    private final Optional<String> station;

    /**
     * A session that is not open yet.
     *
     * @param addresses of boats' servers to connect to
     * @param policy what boats of missions do while the engine or its journal does not work
     * @param station the address of the ground station to which simulated boats are shown; empty for none
     */
    SessionOpening(Asked asked, List<BoatAddress> addresses, FaultPolicy policy, Optional<String> station) {
        this.asked = asked;
        this.addresses = addresses;
        this.policy = policy;
        this.station = station;
    }

    /**
     * What is to be opened.
     *
     * @param stated the errors of boats that do not report theirs
     * @param water of simulated boats; empty for calm water
     * @param around what there is on that water
     * @param lostLinkWish what boats are to do when their link is lost; empty where it is not said: what the journal says counts then
     * @param earlier the journal with the session that goes on; empty for a new session
     */
    record Asked(
            SessionSetup setup,
            NamedConditions stated,
            Optional<NamedConditions> water,
            WaterAround around,
            Optional<LostLinkAction> lostLinkWish,
            Optional<JournalAddress> earlier) {}

    /** Begins a session, with the boats that are to be connected. */
    @FunctionalInterface
    interface Begin {
        /** Begins it; says by lines what of earlier processes goes on. */
        void begin(Consumer<String> lines) throws IOException;
    }

    /** What a command does with a session that is open and has not begun. */
    @FunctionalInterface
    interface Use {
        /**
         * Runs it.
         *
         * @return the exit code
         */
        int run(Session session, Begin begin) throws IOException, InterruptedException;
    }

    /**
     * Opens the session, and closes it when it has been used.
     *
     * @return the exit code
     * @throws UsageFault if simulated boats are to be shown to a ground station and the session has none
     */
    int run(Use use) throws IOException, InterruptedException {
        Conditions ofSimulated = asked.water().map(NamedConditions::conditions).orElse(Conditions.CALM);
        SimulatedBoatsOnTcp simulated = new SimulatedBoatsOnTcp(
                1, ofSimulated, HandlerModules.robotsOf(asked.setup().vocabulary()));
        asked.around().under(simulated);
        StationLinks stations = new StationLinks(simulated);
        if (station.isPresent() && simulated.robots() != RobotKind.BOAT) {
            throw new UsageFault("--mavlink shows boats, and this session has none");
        }
        station.ifPresent(stations::start);
        SessionRuntime runtime = SessionRuntime.RealTime.ofThisProcess().withSimulatedBoats(simulated);
        SessionSetup setup =
                asked.setup().with(asked.stated().services()).with(runtime).with(policy);
        try (Session session = Session.open(setup)) {
            Thread.setDefaultUncaughtExceptionHandler(session.faults().guard());
            return use.run(session, lines -> begin(session, lines));
        } finally {
            stations.stop();
            Thread.setDefaultUncaughtExceptionHandler(null);
        }
    }

    private void begin(Session session, Consumer<String> lines) throws IOException {
        if (asked.earlier().isPresent()) {
            goOn(session, asked.earlier().get(), lines);
        }
        session.fleet().wish(asked.lostLinkWish());
        addresses.forEach(session.fleet()::connect);
        session.begin();
    }

    private void goOn(Session session, JournalAddress journal, Consumer<String> lines) throws IOException {
        List<String> boats = session.earlierBoats().reconnect(new HashSet<>(addresses));
        lines.accept("going on with " + journal + (boats.isEmpty() ? "" : ", with " + String.join(", ", boats)));
        String damage = session.setup().journal().damage();
        if (!damage.isEmpty()) {
            lines.accept("crw: " + journal + " is damaged: " + damage);
        }
    }
}
