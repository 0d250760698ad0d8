package org.sami.crw.session;

import java.util.Optional;
import org.sami.crw.fleet.FleetWants;
import org.sami.crw.operator.OperatorModels;
import org.sami.spn.vocabulary.Vocabulary;

/** The periodic looks of a session: models show what changes by itself, watches look at boats, engine and machine. For the engine's thread. */
final class SessionLooks {
    private static final long LOOK_MS = 1000;
    private static final long STUCK_MS = 1000;

    /** Short against the half second that is left of a journal's lease once its holder stops: nothing is commanded after its end, also where nothing is to be written. */
    private static final long DATABASE_MS = 250;

    private static final int SHOWN_BEFORE_REFRESH = 3;

    private final Vocabulary vocabulary;
    private final SessionThreads threads;
    private final SessionEngine engine;
    private final SessionFleet fleet;
    private final SessionDomain domain;
    private final OperatorModels models;
    private final Optional<SessionMonitor> monitor;
    private final long shownBeforeStuck;
    private long shown;

    /**
     * Nothing is looked at yet.
     *
     * @param monitor empty where everything is one thread of the caller's, who sees what it throws
     */
    SessionLooks(
            Vocabulary vocabulary,
            SessionThreads threads,
            SessionEngine engine,
            SessionFleet fleet,
            SessionDomain domain,
            OperatorModels models,
            Optional<SessionMonitor> monitor) {
        this.vocabulary = vocabulary;
        this.threads = threads;
        this.engine = engine;
        this.fleet = fleet;
        this.domain = domain;
        this.models = models;
        this.monitor = monitor;
        shownBeforeStuck = threads.isRealTime() ? STUCK_MS / OperatorModels.SHOW_MILLIS : 1;
    }

    /** Looks now, and from now on periodically. */
    void begin() {
        keepLookingAfterBoats();
        keepShowing();
        monitor.filter(SessionMonitor::watchesDatabase).ifPresent(this::keepLookingAfterDatabase);
    }

    private void keepLookingAfterDatabase(SessionMonitor watching) {
        try {
            watching.checkJournal();
        } finally {
            threads.scheduler().after(DATABASE_MS, () -> keepLookingAfterDatabase(watching));
        }
    }

    /** Ages and reasons change by themselves. */
    private void keepShowing() {
        try {
            fleet.connector().executor().execute(models::look);
            if (++shown % SHOWN_BEFORE_REFRESH == 0) {
                models.refresh(engine.host(), vocabulary);
            }
            if (shown % shownBeforeStuck == 0) {
                lookForStuckMissions();
            }
        } finally {
            threads.scheduler().after(threads.showMillis(), this::keepShowing);
        }
    }

    private void keepLookingAfterBoats() {
        try {
            fleet.connector().executor().execute(fleet::look);
            monitor.ifPresent(one -> one.look(threads.nowMs()));
        } finally {
            threads.scheduler().after(LOOK_MS, this::keepLookingAfterBoats);
        }
    }

    /** After what missions asked before has reached the proxies. */
    private void lookForStuckMissions() {
        fleet.connector().executor().execute(() -> {
            FleetWants wants = domain.handlers().wants();
            threads.engine()
                    .execute(() -> engine.host().ask(view -> {
                        models.stuck().look(view, wants, threads.nowMs());
                        return null;
                    }));
        });
    }
}
