package org.sami.crw.sim.run.incident;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.DefaultAnswers;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.operator.ClickCount;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.service.Geodesy;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.run.LoopExecutor;
import org.sami.crw.sim.run.RunJournal;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.crw.sim.run.record.BoatState;
import org.sami.crw.sim.run.record.RunHash;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.world.SimulatedBoatConnector;
import org.sami.crw.sim.run.world.SimulatedWater;
import org.sami.spn.host.HostStatus;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/**
 * A run with incidents in simulated water, in one thread and in virtual time: any number of root missions, started, aborted and interrupted by a script
 * through the session's public methods. Equal inputs give equal results. Used once, by one thread.
 */
public final class IncidentRun {
    private static final long JOIN_MILLIS = 30_000;

    private final IncidentRunInput input;
    private final LoopExecutor executor = new LoopExecutor();
    private final VirtualClock clock = new VirtualClock();
    private final SimulatedWater water;
    private final Session session;
    private final RunMissions missions;
    private final ClickCount clicks = new ClickCount();
    private final RunHash hash = new RunHash();
    private final LocationsToVisit locations = new LocationsToVisit();
    private final ResolutionTimes resolutions;
    private final UniqueReadings readings;
    private final SimulatedOperatorDriver operator;
    private final IncidentQueue queue;
    private final ScriptPlayer player;
    private final EmptyBatteries batteries = new EmptyBatteries();

    /** Puts the world together; nothing has happened in it yet. */
    public IncidentRun(IncidentRunInput input) {
        this.input = input;
        SimulatedBoatConnector connector = new SimulatedBoatConnector(executor);
        session = open(new SessionRuntime.OneThread(clock, executor, connector));
        water = new SimulatedWater(clock, input.fleet(), connector::listenerOf);
        connector.launch(water);
        missions = new RunMissions(input.script().background());
        BackgroundWork background = new BackgroundWork(input.script().background());
        resolutions = new ResolutionTimes(input.phase());
        readings = new UniqueReadings(water.plane());
        CriticalBoats critical = new CriticalBoats();
        PressOutcome press = new PressOutcome();
        ScriptedAnswers answers = answers(background);
        operator = new SimulatedOperatorDriver(answers, session.scheduler(), input.answerAfterMillis(), water.quay());
        queue = new IncidentQueue(
                input.incidents(), critical, water::reportedBoats, () -> background.isNoticing(clock.nowMs()));
        player = new ScriptPlayer(input, session, answers, locations, missions, press, queue);
        List.of(missions, background, critical, press, resolutions).forEach(session::addListener);
        session.addListener((index, atMillis, step, effects, view) -> {
            clicks.count(step, effects);
            hash.add(atMillis, effects);
        });
        session.addListener(locations);
        session.addListener(readings);
        session.addOperator(operator);
        operator.connect(session);
    }

    private Session open(SessionRuntime world) {
        try {
            return Session.open(new SessionSetup(
                    input.vocabulary(),
                    input.project(),
                    SessionJournal.over(RunJournal.none().inputs()),
                    CrwServices.STANDARD.drivenWith(
                            input.fleet().inProcess().conditions().crossTrackError()),
                    world,
                    FaultPolicy.ATTENDED,
                    Optional.empty()));
        } catch (IOException noFile) {
            throw new UncheckedIOException(noFile); // it reads none
        }
    }

    private ScriptedAnswers answers(BackgroundWork background) {
        FleetSettings fleet = input.fleet();
        DefaultAnswers defaults = new DefaultAnswers(
                water.quay(),
                fleet.site().centreInProcess(),
                fleet.areaM(),
                fleet.locations(),
                fleet.seed(),
                fleet.boatNames());
        Map<String, Value> places = new LinkedHashMap<>();
        input.script().places().forEach((name, place) -> places.put(name, place.value(water.plane(), water.quay())));
        return new ScriptedAnswers(
                new SimulatedOperator(input.vocabulary(), defaults, AnswersFile.EMPTY),
                places,
                input.script().delays(),
                locations,
                background);
    }

    /**
     * Runs until the script and its missions have come to their end, until the limit, or until somebody wants it to stop.
     *
     * @param stop asked often
     * @return empty where it was stopped
     */
    public Optional<IncidentRunResult> run(BooleanSupplier stop) {
        session.begin();
        water.fleet().start();
        while (true) {
            executor.drain();
            beginWhenAllAreThere();
            player.look();
            executor.drain();
            Optional<String> fault = fault();
            if (player.isOver() || fault.isPresent()) {
                return Optional.of(result(fault));
            }
            if (stop.getAsBoolean()) {
                return Optional.empty();
            }
            clock.runNext();
        }
    }

    private void beginWhenAllAreThere() {
        boolean areThere = !player.hasBegun()
                && missions.joined() >= input.fleet().boats()
                && water.fleet().proxies().all().stream()
                        .allMatch(boat -> boat.status().pose().isPresent());
        if (areThere) {
            player.begin();
        }
    }

    private Optional<String> fault() {
        HostStatus status = session.host().status();
        if (status.kind() == HostStatus.Kind.FAILED) {
            return Optional.of(status.whole());
        }
        if (missions.isHalted()) {
            return Optional.of("a mission was halted: it fired without end (livelock)");
        }
        if (player.fault().isPresent()) {
            return player.fault();
        }
        if (!player.hasBegun() && clock.nowMs() > JOIN_MILLIS) {
            return Optional.of(
                    "only " + missions.joined() + " of " + input.fleet().boats() + " boats answered");
        }
        List<String> troubles = operator.troubles();
        if (!troubles.isEmpty()) {
            return Optional.of(troubles.get(0));
        }
        Optional<String> empty = batteries.isDue(clock.nowMs())
                ? batteries.look(clock.nowMs(), water.boats(), this::isUnderWay)
                : Optional.empty();
        if (empty.isPresent()) {
            return empty;
        }
        return clock.nowMs() > input.limitMillis()
                ? Optional.of("it did not end within " + input.limitMillis() / 1000 + " s" + whatIsLeft())
                : Optional.empty();
    }

    /** Which missions go on at the limit, and which boats lie there with nothing left in their batteries. */
    private String whatIsLeft() {
        List<String> facts = new ArrayList<>();
        missions.running().forEach(plan -> facts.add(plan + " goes on"));
        for (BoatState boat : water.boats()) {
            if (boat.batteryPercent() <= 0) {
                facts.add("the battery of " + boat.id() + " is empty, "
                        + Math.round(Geodesy.distanceM(water.quay(), GeoPoint.of(boat.latDeg(), boat.lonDeg())))
                        + " m from the quay");
            }
        }
        return facts.isEmpty() ? "" : ": " + String.join("; ", facts);
    }

    private boolean isUnderWay(String boat) {
        return water.fleet().proxies().find(boat).filter(BoatProxy::isUnderWay).isPresent();
    }

    private IncidentRunResult result(Optional<String> fault) {
        List<BoatState> boats = water.boats();
        boolean isLate = fault.isPresent() && clock.nowMs() > input.limitMillis();
        return new IncidentRunResult(
                fault.isEmpty() ? RunOutcome.ENDED : isLate ? RunOutcome.RUNNING : RunOutcome.FAILED,
                fault.orElse(""),
                missions.millis(),
                clicks.byKind(),
                boats.stream().mapToInt(BoatState::recharges).sum(),
                player.placed(),
                queue.left(),
                locations.unvisited().size(),
                resolutions.meanSeconds(),
                readings.count(),
                hash.with(boats));
    }
}
