package org.sami.uav.handler;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.crw.handler.CrwDomain;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.fleet.FleetConfig;
import org.sami.crw.sim.fleet.SimulatedFleet;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostClock;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** A base with its journal in a file, and simulated copters, which stay where they are when another base goes on with the journal. */
final class JournalledBase implements HostClock, AutoCloseable {
    private static final long STEP_MS = 100;
    private static final int LONGEST_S = 600;

    final List<String> messages = new ArrayList<>();
    final List<Decision> asked = new ArrayList<>();
    final SimulatedFleet fleet;
    private final VirtualClock clock = new VirtualClock();
    private final ArrayDeque<Runnable> work = new ArrayDeque<>();
    private final Project project;
    private final Path file;
    private SqliteJournal journal;
    private EngineHost host;
    private CrwDomain domain;

    JournalledBase(Path file, Project project, double chargePercent) throws IOException {
        this.file = file;
        this.project = project;
        fleet = new SimulatedFleet(
                clock,
                1,
                1,
                45.7,
                10.72,
                id -> event -> domain.events().publish(event),
                FleetConfig.DEFAULT.withHull(HullConfig.COPTER));
        copter().setBatteryPercent(chargePercent);
        JournalHeader header = JournalHeader.of("copters", Map.of(), Map.of());
        begin(SqliteJournal.create(file, header, JournalOptions.DEFAULT));
        fleet.start();
        pass(5);
        post(new Input.ProxyJoined("copter1"));
    }

    private void begin(SqliteJournal opened) throws IOException {
        journal = opened;
        Engine engine = new Engine(UavRuns.DOMAIN.vocabulary(), project);
        host = EngineHostBuilder.of(engine, opened.lastIndex() == 0 ? engine.newState() : opened.restore(engine))
                .journal(opened)
                .clock(this)
                .executor(work::add)
                .build();
        host.addListener((index, at, input, effects, view) -> effects.stream()
                .filter(Effect.DecisionOpened.class::isInstance)
                .forEach(effect -> asked.add(((Effect.DecisionOpened) effect).decision())));
        domain = CrwDomain.install(host, fleet.proxies(), work::add, message -> messages.add(message.text()));
        host.resume();
        drain();
    }

    /** This base ends, and another one goes on with its journal; it knows nothing else. */
    void restart() throws IOException {
        drain();
        close();
        for (BoatProxy proxy : fleet.proxies().all()) {
            Stream.concat(proxy.commands().current().stream(), proxy.commands().waiting().stream())
                    .map(BoatCommand::commandId)
                    .toList()
                    .forEach(proxy.commands()::withdraw);
        }
        work.clear();
        begin(SqliteJournal.open(file, JournalOptions.DEFAULT));
    }

    void pass(double seconds) {
        long until = clock.nowMs() + (long) (seconds * 1000);
        while (clock.nowMs() < until) {
            clock.runUntil(clock.nowMs() + STEP_MS);
            drain();
        }
    }

    private void drain() {
        while (!work.isEmpty()) {
            work.remove().run();
        }
    }

    void post(Input input) {
        host.post(input);
        drain();
    }

    <T> T ask(Function<EngineView, T> question) {
        return host.ask(question);
    }

    /** Waits for a question, which stays open. */
    Decision await(String type) {
        for (int s = 0; s < LONGEST_S; s++) {
            Optional<Decision> open = ask(EngineView::decisions).stream()
                    .filter(one -> one.type().equals(type))
                    .findFirst();
            if (open.isPresent()) {
                return open.get();
            }
            pass(1);
        }
        throw new AssertionError("nobody asks " + type + ": " + messages);
    }

    /** The operator answers a question once it is asked. */
    void answer(String type, Answer answer) {
        post(new Input.AnswerDecision(await(type).id(), answer, Answerer.OPERATOR));
        pass(1);
    }

    long times(String type) {
        return asked.stream().filter(one -> one.type().equals(type)).count();
    }

    SimulatedHull copter() {
        return fleet.boats().get(0).hull();
    }

    @Override
    public long nowMillis() {
        return clock.nowMs();
    }

    @Override
    public void wakeAt(long millis, Runnable action) {
        clock.at(Math.max(millis, clock.nowMs()), action);
    }

    @Override
    public void close() throws IOException {
        domain.close();
        host.close();
        drain();
        journal.close();
    }
}
