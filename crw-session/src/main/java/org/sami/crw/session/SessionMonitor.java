package org.sami.crw.session;

import java.io.Closeable;
import org.sami.crw.operator.HealthModel;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.fault.EngineWatch;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.crw.session.fault.SystemWatch;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.spn.host.EngineHost;

/** Monitors a session in real time: its engine, the disk or the database of its journal, its memory. */
final class SessionMonitor implements Closeable {
    private final EngineHost host;
    private final ThreadGuard guard;
    private final EngineWatch engine;
    private final SystemWatch system;
    private long faults; // of listeners; for the engine's thread

    SessionMonitor(
            EngineHost host,
            SessionJournal journal,
            FleetConnector fleet,
            HealthModel health,
            SessionMessages messages,
            FaultPolicy policy,
            ThreadGuard guard) {
        this.host = host;
        this.guard = guard;
        engine = new EngineWatch(
                health,
                work -> fleet.executor().execute(work),
                fleet::boats,
                policy.boats(),
                reason -> messages.each(listener -> listener.onBroken(reason)));
        system = new SystemWatch(journal.stored(), health, guard);
        host.addListener(engine);
    }

    EngineWatch engine() {
        return engine;
    }

    /** Whether the journal is kept in a database. */
    boolean watchesDatabase() {
        return system.watchesDatabase();
    }

    /** Has the engine stand still where its journal may not be written any more, also if there is nothing to write. On the engine's thread. */
    void checkJournal() {
        host.checkJournal();
    }

    /** To be called every second, on the engine's thread. */
    void look(long nowMillis) {
        engine.look();
        checkJournal();
        system.look(nowMillis);
        long now = host.load().listenerFaults();
        if (now > faults) {
            guard.lost("engine", new IllegalStateException((now - faults) + " listeners threw; the log says what"));
            faults = now;
        }
    }

    @Override
    public void close() {
        system.close();
    }
}
