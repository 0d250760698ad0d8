package org.sami.crw.session.fault;

import java.util.List;
import java.util.Objects;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.sami.crw.operator.HealthModel;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.HostStatus;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;

/**
 * What a session does when its engine waits for the journal, or has stopped: says so, and has boats stand still until it goes on. The fleet's thread does
 * not need the engine for that, nor for a fleet stop. Safe for use by several threads.
 */
public final class EngineWatch implements HostListener {
    private static final String WAITS = "Missions stand still; ";
    private static final String STOPPED = "The engine has stopped: ";

    private final HealthModel health;
    private final Executor fleet;
    private final Supplier<ProxyRegistry> boats;
    private final Consumer<String> broken;
    private final HeldBoats held = new HeldBoats(); // for the fleet's thread
    private volatile BoatsAtFault still;
    private volatile boolean down;

    /**
     * Watches an engine that runs.
     *
     * @param fleet the fleet's thread
     * @param boats for the fleet's thread
     * @param still what boats do meanwhile
     * @param broken receives, once, why the session cannot go on
     */
    public EngineWatch(
            HealthModel health,
            Executor fleet,
            Supplier<ProxyRegistry> boats,
            BoatsAtFault still,
            Consumer<String> broken) {
        this.health = Objects.requireNonNull(health, "health");
        this.fleet = Objects.requireNonNull(fleet, "fleet");
        this.boats = Objects.requireNonNull(boats, "boats");
        this.still = Objects.requireNonNull(still, "still");
        this.broken = Objects.requireNonNull(broken, "broken");
    }

    /** What boats do when the engine or its journal does not work. */
    public BoatsAtFault still() {
        return still;
    }

    /** Sets what boats do; counts at once. */
    public void setStill(BoatsAtFault other) {
        still = Objects.requireNonNull(other, "other");
        if (down) {
            begin();
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        // All is well.
    }

    @Override
    public void onWaiting(HostStatus status) {
        health.report(HealthFault.ofSession(
                        HealthKind.JOURNAL,
                        Priority.CRITICAL,
                        WAITS + status.reason(),
                        remedy(status.reason()) + ", and missions go on; " + still.brief() + ", F12 works")
                .withDetails(details(still.words() + "; the fleet stop (F12) works", status)));
        begin();
    }

    private static String remedy(String reason) {
        if (reason.contains("is full")) {
            return "Make room on the journal's disk";
        }
        if (reason.contains("another program")) {
            return "End the program that has the journal open";
        }
        return reason.contains("database")
                ? "See to the database and the network to it"
                : "See to the journal's file and its disk";
    }

    private static String details(String first, HostStatus status) {
        return status.details().isEmpty() ? first : first + ". " + status.details();
    }

    @Override
    public void onGoingOn() {
        down = false;
        health.over(HealthKind.JOURNAL, "");
        fleet.execute(() -> held.letGo(boats.get()));
    }

    @Override
    public void onFailed(HostStatus status) {
        health.report(HealthFault.ofSession(
                        HealthKind.ENGINE,
                        Priority.CRITICAL,
                        STOPPED + status.reason(),
                        "Bring boats home by hand, or stop them (F12); then end the session and open it again")
                .withDetails(details(
                        "No mission goes on. " + still.words()
                                + ". A session that is opened again goes on where its journal ends",
                        status)));
        health.over(HealthKind.JOURNAL, ""); // what it waited for is in the reason
        begin();
        broken.accept(status.reason());
    }

    private void begin() {
        down = true;
        if (still == BoatsAtFault.STOP) {
            fleet.execute(() -> held.stop(boats.get()));
        } else {
            look();
        }
    }

    /** Has boats held that meanwhile began with what missions have for them; to be called every second. */
    public void look() {
        if (down && still == BoatsAtFault.HOLD) {
            fleet.execute(() -> held.hold(boats.get()));
        }
    }
}
