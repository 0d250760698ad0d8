package org.sami.crw.session;

import java.util.Optional;
import org.sami.crw.session.fault.BoatsAtFault;
import org.sami.crw.session.fault.EngineWatch;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostStatus;

/** What becomes of a session when its engine, its journal or a thread fails (docs/decisions, 0391, 0392). From any thread. */
public final class SessionFaults {
    private final EngineHost host;
    private final ThreadGuard guard;
    private final Optional<EngineWatch> watch;
    private final BoatsAtFault first;

    /**
     * For one session.
     *
     * @param watch empty where everything is one thread of the caller's
     * @param first what boats do where nobody watches
     */
    SessionFaults(EngineHost host, ThreadGuard guard, Optional<EngineWatch> watch, BoatsAtFault first) {
        this.host = host;
        this.guard = guard;
        this.watch = watch;
        this.first = first;
    }

    /** Why the session cannot go on; empty as long as it can. */
    public Optional<String> failure() {
        HostStatus status = host.status();
        return status.kind() == HostStatus.Kind.FAILED ? Optional.of(status.whole()) : Optional.empty();
    }

    /** What boats do while the engine or its journal does not work. */
    public BoatsAtFault boats() {
        return watch.map(EngineWatch::still).orElse(first);
    }

    /** Sets it; counts at once. Does nothing where everything is one thread of the caller's. */
    public void setBoats(BoatsAtFault still) {
        watch.ifPresent(one -> one.setStill(still));
    }

    /** The handler for uncaught exceptions on other threads of a program that shows the session, such as a window's event thread. */
    public ThreadGuard guard() {
        return guard;
    }
}
