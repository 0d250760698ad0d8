package org.sami.crw.sim.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Executor;
import org.sami.crw.handler.CrwDomain;
import org.sami.crw.handler.CrwServices;
import org.sami.crw.operator.OperatorMessage;
import org.sami.crw.proxy.BoatConnector;
import org.sami.crw.proxy.BoatListener;
import org.sami.crw.proxy.BoatListeners;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.sim.report.NoteResult;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostClock;
import org.sami.spn.host.InputJournal;

/** The base: the engine with its host, and the boats domain on it. Everything of it runs on the run's one executor. */
final class BaseStation {
    /** In a run in process nobody waits for a listener but the run itself. */
    private static final long NEVER_SLOW_MILLIS = 3_600_000;

    private final EngineHost host;
    private final HostClock clock;
    private final ProxyRegistry boats = new ProxyRegistry();
    private final CrwDomain domain;
    private final ReadingRecorder readings;
    private final List<NoteResult> messages = new ArrayList<>();

    BaseStation(RunPlan plan, InputJournal journal, HostClock clock, Executor executor, BoatConnector connector) {
        this.clock = clock;
        Engine engine = new Engine(plan.vocabulary(), plan.project());
        host = EngineHost.builder(engine, engine.newState())
                .journal(journal)
                .clock(clock)
                .executor(executor)
                .slowListenerMillis(NEVER_SLOW_MILLIS)
                .build();
        domain = CrwDomain.install(host, boats, executor, this::tell, CrwServices.STANDARD, connector);
        readings = new ReadingRecorder(clock);
    }

    private void tell(OperatorMessage message) {
        messages.add(new NoteResult(
                message.atMillis(),
                message.source().name().toLowerCase(Locale.ROOT) + " message",
                message.mission(),
                message.text()));
    }

    EngineHost host() {
        return host;
    }

    /** What the base hears of each boat. */
    BoatListener boatListener() {
        return new BoatListeners(domain.boatListener(), readings);
    }

    /** From now on the base has all of these boats. */
    void know(ProxyRegistry fleet) {
        fleet.all().stream().filter(boat -> boats.find(boat.boatId()).isEmpty()).forEach(boats::add);
    }

    /** What the boats' sensors measured. */
    ReadingRecorder readings() {
        return readings;
    }

    /** What plans and the domain told the operator, oldest first, and at last what was not noted down. */
    List<NoteResult> messages() {
        List<NoteResult> all = new ArrayList<>(messages);
        all.addAll(readings.notes(clock.nowMillis()));
        return all;
    }
}
